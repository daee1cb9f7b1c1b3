// Lessons hold: what was shown is what is done when it is said again; a phrase is taught by other words; a closed word
// gets no new meaning; and all of it by keyboard alone.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

const BOTH = 'take the block to the green room and go to the blue room';

/** Where the block is, by the words a screen reader is told. */
const block = async (demo) => /yellow block in the (\w+) room/.exec(await demo.world())?.[1];

flow('a lesson of two things does both when it is said again', async (t) => {
  const demo = await openPage(t);
  await demo.mode('teach');
  await demo.drag([8, 6], [8, 2]);
  await demo.drag([6, 2], [2, 6]);
  await demo.by('lesson').fill(BOTH);
  await demo.press('teach');
  await t.until('it is learned, or there is a choice', async () =>
    (await demo.by('learned').count()) + (await demo.by('fit').count()) > 0);
  if ((await demo.by('fit').count()) > 0) {
    await t.shot('lesson-fits');
    await t.accessible('a choice of readings');
    await demo.by('fit').first().click();
    await demo.by('learned').waitFor();
  }
  await demo.ask(BOTH);
  await demo.finish();
  await t.equal(async () => [(await demo.robot()).room, await block(demo)], ['blue', 'green'], 'where they end');
});

flow('leaving a room is taught by the reading that fits', async (t) => {
  const demo = await openPage(t);
  await demo.mode('teach');
  await demo.drag([6, 2], [6, 6]);
  await demo.by('lesson').fill('leave the green room');
  await demo.press('teach');
  await t.until('it is learned, or there is a choice', async () =>
    (await demo.by('learned').count()) + (await demo.by('fit').count()) > 0);
  if ((await demo.by('fit').count()) > 0) {
    await demo.by('fit').first().click();
    await demo.by('learned').waitFor();
  }
  await demo.ask('leave the green room');
  await demo.finish();
  await t.check(async () => (await demo.robot()).room !== 'green', 'it left');
});

flow('another reading that is chosen is remembered', async (t) => {
  const demo = await openPage(t);
  await demo.deepen('see');
  await demo.ask('take the block to the green room');
  await demo.reading('The object is in').click();
  await demo.planned();
  await demo.finish();
  const meant = await demo.plain();
  await demo.press('remember');
  await demo.by('learned').waitFor();
  await demo.press('reset-world');
  await demo.ask('take the block to the green room');
  await demo.planned();
  await t.equal(() => demo.plain(), meant, 'what it means now');
  await t.equal(() => demo.by('question').count(), 0, 'without asking');
});

flow('a phrase is taught by saying it in other words, by keyboard alone', async (t) => {
  const demo = await openPage(t);
  await demo.reach('command');
  const say = async (words) => {
    await demo.page.keyboard.press('Control+a');
    await demo.page.keyboard.type(words);
    await demo.page.keyboard.press('Enter');
  };
  await say('tidy up means: put the block in the blue room');
  await demo.by('learned').waitFor();
  await t.accessible('a phrase that was taught');
  await t.shot('lesson-in-other-words');
  await demo.reach('command');
  await say('tidy up');
  await demo.answered('tidy up');
  await demo.planned();
  await demo.finish();
  await t.equal(() => block(demo), 'blue', 'where the block is');
  for (const [lesson, why] of [
    ['and so on means: go to the blue room', /“and” keeps its meaning/],
    ['go to the red room means: go to the blue room', /know what .* means already/],
    ['zip means: frobnicate the gadget', /not understand/],
  ]) {
    await demo.reach('command');
    await say(lesson);
    await demo.by('teach-notice').waitFor();
    await t.until(lesson, async () => why.test(await demo.by('teach-notice').textContent()));
  }
});

flow('the keyboard alone shows a lesson, says it, and has it done', async (t) => {
  const demo = await openPage(t);
  const { keyboard } = demo.page;
  const press = async (...keys) => {
    for (const key of keys) await keyboard.press(key);
  };
  await demo.reach('mode-teach');
  await press('Enter');
  await demo.reach('room');
  await press('ArrowUp', 'ArrowRight', 'ArrowUp', 'ArrowUp', 'r');
  await t.equal(async () => (await demo.robot()).room, 'red', 'driven');
  await demo.reach('lesson');
  await keyboard.type('flump to the red room');
  await press('Enter');
  await demo.by('told').first().waitFor();
  await t.equal(async () => (await demo.robot()).room, 'green', 'the room is as it was');
  await demo.reach('command');
  await press('Control+a');
  await keyboard.type('flump to the blue room');
  await press('Enter');
  await demo.answered('flump');
  await demo.planned();
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'what was never shown');
});

flow('a phrase of two things is taught by other words, and both are brought', async (t) => {
  const demo = await openPage(t);
  await demo.by('world').selectOption({ label: 'Hall' });
  await demo.by('command').fill('tidy up means: put the chair and the bag in the red room');
  await demo.press('ask');
  await demo.by('learned').waitFor();
  await demo.ask('tidy up');
  await demo.planned();
  await demo.finish();
  await t.check(async () => /orange chair in the red room/.test(await demo.world()), () => demo.world());
  await t.check(async () => /teal bag in the red room/.test(await demo.world()), () => demo.world());
});

flow('a name is taught by a description, is told, and is a name in any sentence', async (t) => {
  const demo = await openPage(t);
  await demo.by('command').fill('dungeon means: the blue room');
  await demo.press('ask');
  await demo.by('learned').waitFor();
  await t.equal(() => demo.by('lesson-means').allTextContents(), ['the blue room'], 'the list says what it means');
  await demo.ask('put the block in the dungeon');
  await t.equal(() => demo.plain(), 'I will bring the block into the blue room.', 'it is understood as that');
  await demo.by('command').fill('cellar means: where is the block?');
  await demo.press('ask');
  await demo.by('teach-notice').waitFor();
  await demo.ask('go to the dungeon');
  await t.equal(() => demo.by('teach-notice').count(), 0, 'what was wrong before is not told any more');
});

flow('what words mean now is said in plain words at every depth', async (t) => {
  const demo = await openPage(t);
  await demo.mode('teach');
  await demo.drag([6, 2], [2, 6]);
  await demo.by('lesson').fill('go to the dungeon');
  await demo.press('teach');
  await demo.by('learned').waitFor();
  await demo.by('told').first().waitFor();
  t.note((await demo.by('told').allTextContents()).join(' '));
  await t.equal(() => demo.by('added').count(), 0, 'no formulas');
  await demo.deepen('study');
  await t.check(async () => (await demo.by('added').count()) > 0, 'formulas for those who study');
});
