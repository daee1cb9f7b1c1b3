// Where a model errs: the commands that fail most, the words that it does not know and the features that decided wrongly,
// each with its rows; and what wrong answers to what is held out did instead.

import { flow } from '../flow.mjs';
import { openTrain } from '../page.mjs';

/** A green room to the left, a red one to the right, a robot and a chair, as JSON. */
const world = (agent, chair) => ({
  agent: { x: agent[0], y: agent[1], direction: 'south' },
  rooms: [
    { name: 'room0', color: 'green', left: 0, bottom: 0, right: 4, top: 4 },
    { name: 'room1', color: 'red', left: 4, bottom: 0, right: 8, top: 4 },
  ],
  doors: [{ name: 'door0', left: 4, bottom: 2, right: 4, top: 2, lock: 'unlocked' }],
  objects: [{ name: 'chair0', x: chair[0], y: chair[1], shape: 'chair', color: 'blue' }],
});

const GREEN = world([2, 2], [6, 1]);
const RED = world([5, 2], [6, 1]);

/** A row of JSON lines. */
const said = (command, task, pre, post) => JSON.stringify({ command, task, pairs: [{ pre, post }] });

const toRed = (command, task = 'red') => said(command, task, GREEN, RED);
const toGreen = (command, task = 'green') => said(command, task, RED, GREEN);

flow('the worst commands, unknown words and features that decided wrongly are named with their rows', async (t) => {
  const demo = await openTrain(t);
  await demo.choose('errors.jsonl', [
    toRed('go to the red room'),
    toGreen('go to the red room'),
    toGreen('go to the red room'),
    toRed('go to the red flumph'),
    // Two readings: the chair goes into the room, or the robot to the chair that is there. Each row shows another.
    said('move next to the chair in the red room', 'chair', world([1, 2], [2, 2]), world([4, 2], [5, 2])),
    said('move next to the chair in the red room', 'chair', world([2, 2], [6, 2]), world([5, 2], [6, 2])),
  ].join('\n'));
  await t.until('the file is open', async () => (await demo.corpus()).name === 'errors.jsonl');
  await demo.press('audit');
  await demo.says(/Every row is judged/);
  await demo.part('lexicon');
  const table = (name) => demo.by('errors').getByRole('region', { name, exact: true }).locator('tbody tr');
  await t.check(async () => /^go to the red room3.*#1#2#31/.test(await table('Commands that fail most').first().textContent()),
    'the command of three rows, of which one is right');
  await t.check(async () => /^flumph1#4/.test(await table('Unknown words').first().textContent()), 'the word, and its row');
  await t.check(async () => (await table('Features that decided wrongly').count()) > 0, 'features');
  await t.check(async () => /#[56]/.test(await table('Features that decided wrongly').first().textContent()), 'of the row with the other reading');
  await t.accessible('errors of every kind');
  await table('Unknown words').first().getByTestId('open-row-of').press('Enter');
  await t.check(async () => /flumph/.test(await demo.by('open-row').textContent()), 'a row is opened from there');
});

flow('what wrong answers did instead is told task by task', async (t) => {
  const demo = await openTrain(t);
  await demo.choose('tasks.jsonl', [
    toRed('go to the red room'), toRed('walk to the red room'), toGreen('go to the green room'), toGreen('walk to the green room'),
    toRed('go to the red room'), toGreen('go to the green room'), toGreen('go to the red room'),
  ].join('\n'));
  await t.until('the file is open', async () => (await demo.corpus()).name === 'tasks.jsonl');
  for (const row of [4, 5, 6]) await demo.page.locator(`#row-${row}`).getByRole('checkbox').check();
  await demo.press('put-held-out');
  await t.check(async () => /3 held out/.test(await demo.by('corpus-count').textContent()), 'three rows are held out');
  await demo.part('run');
  await demo.passes(3);
  await demo.train();
  await demo.part('lexicon');
  const confusion = demo.by('errors').getByRole('region', { name: 'What wrong answers did instead, on what is held out', exact: true });
  await t.equal(() => confusion.locator('tbody tr').allTextContents(), ['greenred1'], 'a command of one task that did the other');
  await t.accessible('what wrong answers did');
});
