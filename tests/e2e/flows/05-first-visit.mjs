// The first minute: the page opens with a model, an example is pressed, the robot does it; a command is read while
// it is typed.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

flow('a visitor presses an example, and the robot does it', async (t) => {
  const demo = await openPage(t);
  await t.accessible('the first view');
  await t.equal(() => demo.by('plan').count(), 0, 'plans before anything was said');
  await demo.press('example-1');
  await demo.answered('the example');
  await t.equal(() => demo.by('command').inputValue(), 'put the yellow block in the biggest room', 'the command');
  await t.equal(() => demo.plain(), 'I will bring the yellow block into the biggest room.', 'in plain words');
  await demo.says(/^I will bring the yellow block into the biggest room\. The plan has \d+ steps\.$/);
  const steps = await demo.played();
  await t.check(steps > 4, `a plan of ${steps} steps`);
  await t.check(async () => /yellow block in the blue room/.test(await demo.world()), () => demo.world());
  await demo.says(/^Done in \d+ steps\. The robot is in/);
  await t.equal(() => demo.by('done').textContent(), `Done in ${steps} steps.`, 'what was to be done is done');
  await t.equal(() => demo.page.evaluate(() => document.activeElement.id), 'command', 'who presses on types on');
  await t.accessible('an example that was done');
});

flow('a command is read while it is typed, and planned for when it is sent', async (t) => {
  const demo = await openPage(t);
  const answer = demo.by('answer');
  await demo.by('command').pressSequentially('go to the red room', { delay: 20 });
  await t.until('it is read', async () => (await demo.plain()) === 'I would go to the red room.');
  await t.equal(() => answer.getAttribute('data-live'), 'true', 'it was not sent');
  await t.equal(() => demo.by('plan').count(), 0, 'plans');
  await demo.by('command').press('Enter');
  await demo.played();
  await t.equal(() => answer.getAttribute('data-live'), 'false', 'it was sent');
  await t.equal(async () => (await demo.robot()).room, 'red', 'where the robot ends');
});

flow('a plan is paused, stepped, scrubbed and undone', async (t) => {
  const demo = await openPage(t);
  const plan = demo.by('plan');
  const start = await demo.robot();
  await demo.ask('go to the blue room');
  await t.until('the first step', async () => (await plan.getAttribute('data-at')) !== '0');
  await demo.press('plan-play');
  await demo.press('plan-first');
  await t.equal(() => demo.robot(), start, 'back at the start');
  await demo.press('plan-forward');
  await t.equal(() => plan.getAttribute('data-at'), '1', 'one step on');
  await demo.by('plan-scrub').fill(await plan.getAttribute('data-steps'));
  await t.equal(async () => (await demo.robot()).room, 'blue', 'scrubbed to the end');
  await demo.press('undo');
  await t.equal(() => demo.robot(), start, 'undone');
});
