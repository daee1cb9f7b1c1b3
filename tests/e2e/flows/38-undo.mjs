// Undo and redo go through everything: commands, rules, changes of the room, demonstrations and lessons.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

flow('everything is undone to the first view, and done again', async (t) => {
  const demo = await openPage(t);
  const signature = async () => [await demo.world(), await demo.plain(),
    await demo.by('rule-pull').isChecked().catch(() => null), await demo.by('lesson-try').allTextContents()];
  await demo.deepen('see');
  const first = await signature();
  await demo.ask('go to the red room');
  await demo.finish();
  await demo.by('rule-pull').check();
  await t.until('planned again', async () => (await demo.by('plan').count()) > 0);
  await demo.finish();
  await demo.mode('edit');
  await demo.drag([8, 6], [2, 6]);
  await demo.mode('teach');
  await demo.drag([2, 6], [8, 2]);
  await demo.by('lesson').fill('schlep the block to the green room');
  await demo.press('teach');
  await demo.by('learned').waitFor();
  await demo.ask('schlep the block to the green room');
  await demo.finish();

  const walk = async (button) => {
    const seen = [await signature()];
    while (await demo.by(button).isEnabled()) {
      await demo.press(button);
      // What comes of it: the plan of what was said is not played anew.
      seen.push(await signature());
      await t.check(seen.length < 20, `${button} ends`);
    }
    return seen;
  };
  await demo.mode('watch');
  const back = await walk('undo');
  await t.equal(back.at(-1), first, 'the first view');
  await t.check(back.length >= 6, `${back.length - 1} things were done`);
  const forth = await walk('redo');
  await t.equal(forth.at(-1)[3], ['schlep the block to the green room'], 'the lesson is back');
  await t.equal(forth.slice(1, -1), back.toReversed().slice(1, -1), 'the same way forth');
  await demo.ask('schlep the block to the red room');
  await demo.planned();
  await demo.finish();
  await t.check(async () => /block in the red room/.test(await demo.world()), 'what was taught works still');
});
