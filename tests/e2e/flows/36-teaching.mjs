// Teaching: a phrase is shown and said, used, saved as a corpus that the command line reads, and forgotten.

import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

flow('a phrase is taught by dragging, used, saved and forgotten', async (t) => {
  const demo = await openPage(t);
  await demo.mode('teach');
  await demo.press('teach');
  await t.check(async () => /Nothing is shown yet/.test(await demo.by('missing').textContent()), 'what is missing');
  await demo.drag([6, 2], [2, 6]);
  await demo.by('lesson').fill('flump to the blue room');
  const start = Date.now();
  await demo.press('teach');
  await demo.by('learned').waitFor();
  t.note(`taught, model loaded and all: ${Date.now() - start} ms`);
  await t.check(async () => (await demo.by('told').count()) > 0, 'what was learned is told');
  await t.equal(async () => (await demo.robot()).room, 'green', 'the room is as it was');
  await demo.press('ask');
  await demo.answered('the lesson');
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'the lesson is done');
  await demo.ask('flump to the red room');
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'red', 'and what was never shown');
  await t.accessible('a lesson');
  await t.shot('taught');

  const corpus = await demo.saved('save-lessons');
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  try {
    const file = path.join(folder, 'taught.jsonl');
    await writeFile(file, corpus);
    const { status, stderr } = await t.groundling('train', '--corpus', file, '--out', path.join(folder, 'a.model'));
    await t.equal(status, 0, stderr);
  } finally {
    await rm(folder, { recursive: true });
  }

  await demo.press('unteach');
  await t.until('nothing is taught', async () => (await demo.by('lessons').count()) === 0);
  await demo.ask('flump to the blue room');
  await t.check(async () => (await demo.why()).includes('unknown_words'), async () => `forgotten: ${await demo.why()}`);
  await demo.press('undo');
  await demo.press('undo');
  await demo.by('lessons').waitFor();
});

flow('a phrase is taught with the arrow keys', async (t) => {
  const demo = await openPage(t);
  await demo.mode('teach');
  await demo.keys('ArrowUp', 'ArrowRight', 'ArrowUp');
  await demo.says(/doorway/);
  await demo.keys('ArrowUp', 'r');
  await t.equal(async () => (await demo.robot()).room, 'red', 'driven');
  await demo.by('lesson').fill('hop over to the red room');
  await demo.by('lesson').press('Enter');
  await demo.by('learned').waitFor();
  await demo.ask('hop over to the blue room');
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'what was never shown');
});
