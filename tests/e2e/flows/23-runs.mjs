// Corpora of runs in the workbench: a row shows its way and what is not meant, its readings are judged by both, training
// works to its end with the command line's bytes, and what is saved holds the runs again.

import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { openTrain } from '../page.mjs';

/** Four rooms in a ring. */
const START = {
  agent: { x: 2, y: 2, direction: 'west' },
  rooms: [['red', 0, 4, 6, 8], ['blue', 6, 4, 12, 8], ['green', 0, 0, 6, 4], ['yellow', 6, 0, 12, 4]].map(
    ([color, left, bottom, right, top], n) => ({ name: `room${n}`, color, left, bottom, right, top })),
  doors: [[6, 6], [3, 4], [9, 4], [6, 2]].map(([x, y], n) =>
    ({ name: `door${n}`, left: x, bottom: y, right: x, top: y, lock: 'unlocked' })),
  objects: [],
};
const BY_RED = 'ennnneeee';
const BY_YELLOW = 'eeeeeeennn';

const row = (id, command, actions, contrast) =>
  JSON.stringify({ id, command, note: 'kept', runs: [{ start: START, actions, contrast }] });
const CORPUS = [
  row('a', 'go to the blue room but avoid the red room', BY_YELLOW, [BY_RED]),
  row('b', 'go to the blue room but avoid the yellow room', BY_RED, [BY_YELLOW]),
  row('c', 'go through the yellow room to the blue room', BY_YELLOW, [BY_RED]),
  row('d', 'go to the red room then to the blue room', BY_RED, [BY_YELLOW]),
].join('\n') + '\n';

flow('a corpus of runs is looked at, learned from and saved', async (t) => {
  const demo = await openTrain(t);
  await demo.drop('runs.jsonl', CORPUS);
  await t.until('the corpus is open', async () => (await demo.by('row').count()) === 4);
  await demo.by('row').first().click();
  await demo.by('run').waitFor();
  await t.equal(() => demo.by('run-way').allTextContents(), ['The way, 10 actions: green room, yellow room and blue room'], 'the way');
  await t.equal(() => demo.by('run-contrast').allTextContents(), ['Not like this, 9 actions: green room, red room and blue room'], 'what is not meant');
  await t.equal(() => demo.page.locator('[data-testid="run"] polyline').count(), 2, 'both are drawn');
  await t.accessible('a row with a run');
  await t.shot('row-run');

  await demo.train();
  const model = await demo.model();
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  try {
    const [corpus, out] = ['runs.jsonl', 'runs.model'].map((name) => path.join(folder, name));
    await writeFile(corpus, CORPUS);
    const { status, stderr } = await t.groundling('train', '--corpus', corpus, '--out', out);
    await t.equal(status, 0, stderr);
    await t.check(async () => (await readFile(out, 'utf8')) === model, 'the same bytes as on the command line');
  } finally {
    await rm(folder, { recursive: true });
  }

  await demo.part('data');
  const saved = (await demo.saved('save-json')).trimEnd().split('\n').map((line) => JSON.parse(line));
  await t.equal(() => saved.map(({ id, note }) => `${id} ${note}`), ['a kept', 'b kept', 'c kept', 'd kept'], 'the rows');
  await t.equal(() => saved[0].runs[0].contrast, [BY_RED], 'with their contrasts');
  await t.equal(() => saved[3].runs[0].actions, BY_RED, 'and their ways');
  await t.check(async () => /Input\.run_1/.test(await demo.saved('save-corpus')), 'and as a table');
});
