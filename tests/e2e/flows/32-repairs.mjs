// Commands that come to nothing, and the buttons that mend them: each kind of help is pressed once.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

/** Places of the worlds in the page's list. */
const LOCKED = 3;

flow('a thing that is not there is put there, and then told from another', async (t) => {
  const demo = await openPage(t);
  await demo.ask('put the red block in the green room');
  await t.equal(() => demo.why(), ['no_referent'], 'why');
  await demo.help('add', 'red block').click();
  await t.until('there is a plan', async () => (await demo.by('plan').count()) > 0);
  await demo.finish();
  await t.check(async () => /red block in the green room/.test(await demo.world()), () => demo.world());
  await demo.ask('go to the block');
  await t.check(async () => /2 things[^]*the yellow block and the red block/.test(await demo.by('why').textContent()), 'both are named');
  await demo.help('show').click();
  await t.check(async () => (await demo.page.locator('[data-testid="word"].linked').count()) > 0, 'its words are pointed at');
  await demo.help('say', 'the yellow block').click();
  await t.until('there is a plan', async () => (await demo.by('plan').count()) > 0);
  await t.equal(() => demo.by('command').inputValue(), 'go to the yellow block', 'the command');
  await t.equal(() => demo.why(), [], 'why');
});

flow('a word never seen is taken for one that is known, or taught', async (t) => {
  const demo = await openPage(t);
  await demo.ask('go to the blu room');
  await demo.help('say', '“blue”').click();
  await t.until('there is a plan', async () => (await demo.by('plan').count()) > 0);
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'where the robot ends');
  await demo.ask('fetch my slippers');
  await demo.help('teach').click();
  await t.equal(() => demo.by('lesson').inputValue(), 'fetch my slippers', 'the words of the lesson');
  await t.equal(() => demo.by('mode-teach').getAttribute('aria-pressed'), 'true', 'the room is for teaching');
});

flow('what is already so is answered with another room', async (t) => {
  const demo = await openPage(t);
  await demo.ask('go to the green room');
  await t.equal(() => demo.why(), ['already_true'], 'why');
  const before = await demo.world();
  await demo.help('other-world').click();
  await t.until('another room', async () => (await demo.world()) !== before);
});

flow('what is out of reach: doors are opened, the robot may pull, other things may be moved', async (t) => {
  const demo = await openPage(t);
  const mended = async (help, command, goal) => {
    await demo.ask(command);
    await t.equal(() => demo.why(), ['unreachable'], `why not “${command}”`);
    await demo.help(help).click();
    await t.until(`a plan after ${help}`, async () => (await demo.by('plan').count()) > 0);
    await demo.finish();
    await t.check(async () => goal.test(await demo.world()), async () => `after ${help}: ${await demo.world()}`);
  };
  await demo.by('world').selectOption({ index: LOCKED });
  await mended('unlock', 'go to the blue room', /robot is in the blue room/);
  await demo.by('world').selectOption({ index: 0 });
  await demo.mode('edit');
  await demo.drag([8, 6], [9, 7]);
  await mended('pull', 'take the block to the green room', /yellow block in the green room/);
  await demo.press('undo');
  await demo.press('undo');
  // A thing before either door of the green room.
  await demo.mode('edit');
  await demo.drag([9, 7], [5, 2]);
  await demo.press('tool-object');
  await demo.by('look-shape').selectOption('basket');
  await demo.tap([7, 3]);
  await mended('free-landmarks', 'go to the blue room', /robot is in the blue room/);
});
