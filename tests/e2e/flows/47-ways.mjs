// Teaching by ways: what the robot would have done is not what is meant, the way that is meant is driven, and the word is
// understood from then on, here and where it is shared; undone, it is a word that nobody knows.

import { flow } from '../flow.mjs';
import { RING, openElsewhere, openIn } from '../page.mjs';

const SHUN = 'go to the blue room blarging the red room';
const OTHER = 'go to the blue room blarging the yellow room';
const BY_YELLOW = [...Array(7).fill('ArrowRight'), ...Array(3).fill('ArrowUp')];

/** Says it, and waits for the plan. */
async function tell(demo, command) {
  await demo.ask(command);
  await demo.planned();
}

flow('a contrast taught and used', async (t) => {
  const demo = await openIn(t, RING);
  await demo.ask(SHUN);
  await t.check(async () => (await demo.why()).includes('unknown_words'), async () => `${await demo.why()}`);
  await tell(demo, 'go to the blue room');
  await t.equal(() => demo.rooms(), ['green', 'red', 'blue'], 'what it does');
  await demo.press('unlike-plan');
  await t.equal(() => demo.by('contrast').allTextContents(), ['Not like this: green room, red room and blue room'], 'what is not meant');
  await t.equal(() => demo.by('lesson').inputValue(), 'go to the blue room', 'what was said');
  await t.equal(async () => (await demo.robot()).room, 'green', 'where it was said');
  await demo.keys(...BY_YELLOW);
  await t.equal(async () => (await demo.robot()).room, 'blue', 'driven');
  await t.accessible('a way that is shown');
  await t.shot('ways');
  await demo.by('lesson').fill(SHUN);
  await demo.press('teach');
  await demo.by('learned').waitFor();
  t.note((await demo.by('told').allTextContents()).join(' '));
  await tell(demo, SHUN);
  await t.equal(() => demo.by('never').allTextContents(), ['never: the red room'], 'what it forbids');
  await t.equal(() => demo.rooms(), ['green', 'yellow', 'blue'], 'what is done now');
  await demo.press('reset-world');
  await tell(demo, OTHER);
  await t.equal(() => demo.rooms(), ['green', 'red', 'blue'], 'the word in a sentence never heard');
  await t.accessible('a word that was taught by a way');

  const link = await demo.link();
  await openElsewhere(t, link, async (other) => {
    await t.equal(() => other.by('never').allTextContents(), ['never: the yellow room'], 'what came over');
    await t.equal(() => other.by('lesson-try').allTextContents(), [SHUN], 'the lesson');
  });
  const session = await demo.saved('save-session');
  const corpus = await demo.saved('save-lessons');
  const { runs } = JSON.parse(corpus);
  await t.equal(() => [runs[0].actions, runs[0].contrast.map((way) => way.length)], ['eeeeeeennn', [9]], 'the lesson as a corpus');

  await demo.press('unteach');
  await t.until('nothing is taught', async () => (await demo.by('lessons').count()) === 0);
  await demo.page.keyboard.press('Control+z');
  await demo.by('lessons').waitFor();
  await demo.press('unteach');
  await t.until('nothing is taught again', async () => (await demo.by('lessons').count()) === 0);
  await demo.ask(SHUN);
  await t.check(async () => (await demo.why()).includes('unknown_words'), 'nobody knows it');
  await demo.drop('shared.json', session);
  await demo.by('lessons').waitFor();
  await t.equal(() => demo.by('never').allTextContents(), ['never: the yellow room'], 'a file brings it back');
});

flow('the page itself offers the way that it would have gone', async (t) => {
  const demo = await openIn(t, RING);
  await demo.mode('teach');
  await demo.keys(...BY_YELLOW);
  await t.check(async () => /green room, red room and blue room/.test(await demo.by('straight').textContent()), 'another way to get there');
  await demo.press('unlike-straight');
  await t.equal(() => demo.by('contrast').count(), 1, 'it is not meant');
  await demo.press('undo');
  await demo.by('straight').waitFor();
  await demo.press('unlike-straight');
  await demo.by('lesson').fill('go to the blue room threading the yellow room');
  await demo.press('teach');
  await demo.by('learned').waitFor();
  await tell(demo, 'go to the red room threading the blue room');
  await t.equal(() => demo.rooms(), ['green', 'red', 'blue', 'red'], 'the word in a sentence never heard');
});
