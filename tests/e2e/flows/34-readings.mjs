// The depths of an answer: another reading is chosen, words and things point at each other, a meaning is reduced
// step by step, a policy is tried many times.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

flow('another reading is chosen, played, and taken back', async (t) => {
  const demo = await openPage(t);
  await demo.deepen('see');
  await demo.ask('take the block to the green room');
  await demo.finish();
  await t.check(async () => (await demo.by('reading').count()) > 2, 'several readings');
  await t.equal(() => demo.plain(), 'I will bring the block into the green room.', 'the first');
  const other = demo.reading('The object is in');
  await other.click();
  await t.until('it is planned for', async () => (await demo.plain()) === 'I will bring the object into the green room.');
  await t.check(async () => /less; differs in/.test(await other.textContent()), 'what tells it from the first');
  await demo.finish();
  await t.check(async () => /yellow block in the green room/.test(await demo.world()), 'the block is the object');
  await demo.press('undo');
  await t.equal(() => demo.plain(), 'I will bring the block into the green room.', 'taken back');
});

flow('words point at nodes, and a meaning is reduced step by step', async (t) => {
  const demo = await openPage(t);
  await demo.deepen('study');
  await demo.ask('go to the blue room');
  await demo.by('features').waitFor();
  await demo.by('word').nth(3).hover();
  await t.check(async () => (await demo.page.locator('.proof-node.linked').count()) > 0, 'the word’s node');
  await demo.page.locator('.proof-node').last().click();
  await demo.press('reduce');
  await t.equal(() => demo.by('reduction').locator('li').count(), 2, 'one step on');
  await demo.press('reduce-all');
  await t.check(() => demo.by('reduce').isDisabled(), 'all steps are shown');
  await t.check(async () => /^[\d.]+$/.test(await demo.by('study-score').textContent()), 'the score');
  await demo.page.locator('.proof-node').last().focus();
  await demo.page.keyboard.press('ArrowUp');
  await t.check(() => demo.page.evaluate(() => document.activeElement.getAttribute('role') === 'treeitem'), 'keys walk the tree');
  await t.shot('study');
});

flow('with doors that may lock, the policy is tried many times', async (t) => {
  const demo = await openPage(t);
  await demo.deepen('see');
  await demo.by('rule-slip').fill('0.3');
  await demo.ask('go to the blue room');
  await demo.finish();
  await demo.press('try-many');
  await t.until('all runs', async () => (await demo.by('runs').getAttribute('data-runs')) === '500');
  await t.check(async () => /of 500 runs got there/.test(await demo.by('runs').textContent()), 'in words');
  await t.check(async () => /LRTDP|Value iteration/.test(await demo.by('solver-name').textContent()), 'the solver');
});
