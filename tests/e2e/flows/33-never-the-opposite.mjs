// What turns round, joins or orders: a forbidden room, half a command, a shade, words from the general resource, a
// doubtful reading. Each: what it says, what it asks, what it does.

import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';
import { root } from '../packages.mjs';

const model = await readFile(path.join(root, 'assets/model/cleanup.model'), 'utf8');

/** The shipped model, so careful that it always asks. */
const careful = model.replace(/^doubt\t.*\n/gm, '').replace(/^signature\t/m, 'doubt\tthreshold\t1.1\n$&');

/** Opens the page and waits until it knows the words that no lexicon has. */
async function openWith(t, address) {
  const fetched = t.context.waitForEvent('response', (response) => /words\.txt$/.test(response.url()));
  const demo = await openPage(t, address);
  await fetched;
  return demo;
}

/** What the message of a kind says. */
const told = (demo, kind) => demo.page.locator(`[data-testid="why"][data-kind="${kind}"]`).textContent();

flow('a room that is forbidden is not gone to, and one to leave is left', async (t) => {
  const demo = await openPage(t);
  const before = await demo.robot();
  await demo.ask('do not go to the blue room');
  await t.equal(() => demo.plain(), 'I will stay out of the blue room.', 'what it understood');
  await t.equal(() => demo.why(), ['keeps'], 'why nothing moves');
  await t.check(async () => /^I stay out of the blue room\./.test(await told(demo, 'keeps')), () => told(demo, 'keeps'));
  await t.equal(() => demo.robot(), before, 'where the robot stays');
  await demo.says(/I stay out of the blue room/);
  await demo.ask('leave the green room');
  await t.equal(() => demo.plain(), 'I will stay out of the green room.', 'what it understood');
  await demo.finish();
  await t.check(async () => (await demo.robot()).room !== 'green', 'the robot has left');
  await demo.ask('do not go to the yellow room');
  await t.check(async () => (await demo.why()).includes('no_referent'), async () => `a room that is not there: ${await demo.why()}`);
  // What was forbidden is not remembered.
  await demo.ask('go to the blue room');
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'where one may go again');
});

flow('half a command is told and offered, and not done by itself', async (t) => {
  const demo = await openPage(t);
  const before = await demo.robot();
  await demo.ask('after moving the block go to the red room');
  await t.equal(() => demo.why(), ['time'], 'why nothing is done');
  const words = () => told(demo, 'time');
  await t.check(async () => /did not take into account: “after moving the block”/.test(await words()), words);
  await t.check(async () => /What comes first/.test(await words()), words);
  await t.equal(() => demo.by('plan').count(), 0, 'plans');
  await t.equal(() => demo.robot(), before, 'where the robot stays');
  const out = () => demo.page.locator('[data-testid="word"][data-fate="skipped"]').allTextContents();
  await t.check(async () => (await out()).some((word) => word.startsWith('after')), async () => `struck through: ${await out()}`);
  await t.accessible('half a command');
  const just = demo.help('just');
  await t.equal(() => just.textContent(), 'Do just this: go to the red room', 'what is offered');
  await just.click();
  await t.until('there is a plan', async () => (await demo.by('plan').count()) > 0);
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'red', 'where the robot ends');
  await t.equal(() => demo.help('just').count(), 0, 'it was done');
  await demo.ask('go to the blue room unless the block is there');
  await t.equal(() => demo.why(), ['beyond'], 'why nothing is done');
  await t.check(async () => /unless/.test(await told(demo, 'beyond')), () => told(demo, 'beyond'));
  await t.equal(() => demo.by('plan').count(), 0, 'plans');
});

flow('a shade is the colour most like it, and an unknown noun what lies near it', async (t) => {
  const demo = await openWith(t);
  await demo.ask('go to the violet room');
  await demo.says(/I take “violet” for “blue”/);
  await t.equal(() => demo.plain(), 'I will go to the violet room.', 'what it understood');
  await t.equal(() => demo.why(), ['taken'], 'what is said');
  await t.equal(() => told(demo, 'taken'), 'I take “violet” for “blue”. ', 'what it takes it for');
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'where the robot ends');
  await demo.ask('go to the armchair');
  await t.check(async () => /“armchair” for “chair”/.test(await told(demo, 'taken')), () => told(demo, 'taken'));
  await t.check(async () => (await demo.why()).includes('no_referent'), 'there is no chair');
  await demo.help('add').click();
  // Far words make it doubtful: it may ask.
  await demo.planned();
  await demo.finish();
  await t.check(async () => /next to the chair/.test(await demo.plain()), () => demo.plain());
});

flow('without the words that no lexicon has all else works', async (t) => {
  t.expect(/words\.txt|Failed to load resource/);
  await t.context.route(/words\.txt/, (route) => route.fulfill({ status: 404 }));
  const demo = await openWith(t);
  await demo.ask('go to the blue room');
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'where the robot ends');
});

flow('what is doubtful is asked, answered by keys, and remembered', async (t) => {
  const demo = await openPage(t);
  await demo.drop('careful.model', careful);
  await demo.says(/model/i);
  await demo.ready();
  const before = await demo.robot();
  await demo.ask('walk to the red room with the block');
  await demo.by('question').waitFor();
  await t.check(async () => (await demo.by('choice').count()) >= 2, 'choices side by side');
  await t.equal(() => demo.plain(), null, 'what it understood');
  await t.equal(() => demo.by('plan').count(), 0, 'plans');
  await t.equal(() => demo.robot(), before, 'where the robot stays');
  await demo.says(/Which do you mean\? 1: The robot is in the red room that has the block in it\. 2: The block is in the red room\./);
  await t.accessible('a question');
  await t.fits('a question');
  const focused = () => demo.page.evaluate(() => document.activeElement?.id);
  await t.equal(() => focused(), 'choice-1', 'the focus');
  await demo.page.keyboard.press('ArrowRight');
  await t.equal(() => focused(), 'choice-2', 'the focus after an arrow');
  await demo.page.keyboard.press('ArrowLeft');
  await demo.page.keyboard.press('1');
  await t.until('there is a plan', async () => (await demo.by('plan').count()) > 0);
  await t.equal(() => demo.by('question').count(), 0, 'questions');
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'red', 'where the robot ends');
  await demo.press('remember');
  await t.until('it is learned', async () => (await demo.by('lessons').count()) > 0);
  await t.check(async () => /walk to the red room with the block/.test(await demo.by('lessons').textContent()), 'the lesson');
  await t.equal(() => demo.by('remember').count(), 0, 'it is kept once');
  await demo.ask('go to the green room');
  await demo.planned();
  await t.equal(() => demo.by('question').count(), 0, 'questions where one reading alone can be meant');
  await demo.finish();
  await demo.ask('go to the blue room with the block');
  await demo.says(/^There is no blue room that has the block in it\. Name one thing that is in the room\.$/);
  await demo.ask('take the block to the blue room');
  await demo.planned();
  await demo.finish();
  await t.check(async () => /yellow block in the blue room/.test(await demo.world()), () => demo.world());
  await demo.ask('move to the red room with the block');
  await demo.by('question').waitFor();
  await demo.press('none-of-these');
  await t.equal(() => demo.by('lesson').inputValue(), 'move to the red room with the block', 'the words of the lesson');
});
