// What was said: listed with its outcome, brought back by the arrow keys, said again, gone on from; undone and redone by
// keys; and the browser's own way back, from the first view on.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

flow('what was said is listed with what came of it, and gone on from', async (t) => {
  const demo = await openPage(t);
  await demo.ask('go to the blue room');
  await demo.finish();
  await demo.ask('go to the red room');
  await demo.finish();
  await demo.ask('go to the red room');
  await demo.ask('frobnicate the thing');
  await t.equal(() => demo.by('again').allTextContents(),
    ['frobnicate the thing', 'go to the red room', 'go to the red room', 'go to the blue room'], 'the latest first');
  const outcomes = () => demo.by('outcome').allTextContents();
  await t.check(async () => /Done in \d+ steps/.test((await outcomes())[3]) && /already/.test((await outcomes())[1]),
    async () => `outcomes: ${await outcomes()}`);
  await t.accessible('what was said');
  await t.shot('history');
  await demo.by('go-on').nth(3).click();
  await t.until('the robot is back', async () => (await demo.robot()).room === 'blue');
  await demo.by('again').nth(1).click();
  await demo.answered('go to the red room');
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'red', 'said again');
});

flow('arrow keys bring back what was said, Ctrl+Z takes back what was done', async (t) => {
  const demo = await openPage(t);
  await demo.ask('go to the blue room');
  await demo.finish();
  await demo.ask('go to the red room');
  await demo.finish();
  const box = demo.by('command');
  const at = (words) => t.until(words, async () => (await box.inputValue()) === words);
  await box.press('ArrowUp');
  await box.press('ArrowUp');
  await at('go to the blue room');
  await box.press('ArrowDown');
  await at('go to the red room');
  await box.press('Control+z');
  await t.until('the robot is back', async () => (await demo.robot()).room === 'blue');
  await box.press('Control+Shift+Z');
  await t.until('and there again', async () => (await demo.robot()).room === 'red');
  // What is being written is the browser's to undo.
  await box.fill('');
  await box.pressSequentially('go');
  await box.press('Control+z');
  await t.equal(async () => (await demo.robot()).room, 'red', 'the room is left alone');
});

flow('the browser goes back from view to view, to the first', async (t) => {
  const demo = await openPage(t);
  await demo.page.locator('body').press('?');
  await demo.by('guide').waitFor();
  await demo.press('view-kept');
  await demo.page.getByRole('main').getByText('Kept on this machine').waitFor();
  await demo.page.goBack();
  await demo.by('guide').waitFor();
  await demo.page.goBack();
  await demo.by('command').waitFor();
});
