// Every corpus of the folder on the workbench: dropped, learned to the end, and the model is the command line's, byte for
// byte; so are the figures of a cross-validation, which the command line repeats from the page's file. Of a corpus of runs
// the ways of its first rows are told and drawn. No task of the
// page's own thread takes 50 ms of CPU, and the engine holds less than 500 MB. PASSES=2 where there is little time.

import { mkdtemp, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { openTrain } from '../page.mjs';
import { engineMemory, mainThreads, trace } from '../trace.mjs';

const names = (await readdir(process.env.CORPORA)).filter((name) => /\.(csv|jsonl)$/.test(name));
const PASSES = process.env.PASSES ?? '15';
/** Passes and parts of the cross-validation. */
const [CROSS, FOLDS] = ['2', '3'];

/** Lets go of a corpus, and waits until it is open. */
async function opened(demo, name, carried) {
  await demo.let(carried);
  await demo.t.until('the file is open', async () => (await demo.by('corpus-name').textContent()) === name, 90);
}

/** The ways of the first rows are told, and drawn with what is not meant. */
async function showsRuns(demo, text) {
  const rows = text.split('\n', 3).map((line) => JSON.parse(line));
  for (const [at, { runs }] of rows.entries()) {
    await demo.by('row').nth(at).click();
    await demo.t.equal(() => demo.by('run').count(), runs.length, `the runs of row ${at + 1}`);
    const ways = runs.reduce((n, { contrast }) => n + 1 + (contrast ?? []).length, 0);
    await demo.t.equal(() => demo.page.locator('[data-testid="run"] polyline').count(), ways, 'their ways');
    await demo.t.equal(async () => (await demo.by('run-way').allTextContents()).map((way) => parseInt(/\d+/.exec(way))),
      runs.map(({ actions }) => actions.length), 'and their lengths');
    await demo.by('row').nth(at).click();
  }
}

/** Sets the passes of the next run. */
async function passes(demo, count) {
  await demo.part('run');
  await demo.passes(count);
}

/** The figures that the page finds by cross-validation, and the file that repeats it. */
async function crossed(demo) {
  await passes(demo, CROSS);
  await demo.part('experiments');
  await demo.by('folds').fill(FOLDS);
  await demo.by('folds').blur();
  await demo.press('run');
  await demo.by('runs').waitFor({ timeout: 600_000 });
  return { figures: await demo.saved('save-csv'), plan: await demo.saved('save-plan') };
}

/** What the command line writes to its standard output. */
async function commandLine(t, ...args) {
  const { status, stdout, stderr } = await t.groundling(...args);
  await t.equal(status, 0, stderr);
  return stdout;
}

/** Does something with a folder that is gone afterwards. */
async function within(body) {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  try {
    await body(folder);
  } finally {
    await rm(folder, { recursive: true });
  }
}

for (const name of names) {
  flow(`the workbench learns what the command line learns from ${name}`, { seconds: 2400 }, async (t) => {
    const demo = await openTrain(t);
    const text = await readFile(path.join(process.env.CORPORA, name), 'utf8');
    const carried = await demo.carried([[name, text]]);
    const start = Date.now();
    const events = await trace(demo.page, async () => {
      await opened(demo, name, carried);
      await passes(demo, PASSES);
      await demo.press('train');
      await demo.by('progress').waitFor();
      await demo.page.waitForTimeout(6_000);
    });
    if (name.endsWith('.jsonl')) {
      await demo.part('data');
      await showsRuns(demo, text);
      await demo.part('run');
    }
    const { tasks: [...tasks] } = mainThreads(events)[0];
    const longest = tasks.reduce((a, b) => (a.cpu > b.cpu ? a : b));
    t.note(`the page's longest task: ${longest.cpu.toFixed(1)} ms of CPU (${longest.clock.toFixed(1)} by the clock)`);
    await t.check(longest.cpu < 50, `a task of ${longest.cpu} ms of CPU`);
    await t.until('it has trained', async () => /trained here/.test(await demo.by('trained').textContent().catch(() => '')), 900);
    t.note(`${PASSES} passes: ${((Date.now() - start) / 1000).toFixed(1)} s by the clock`);
    const memory = await engineMemory(demo.page, t.address);
    t.note(`the engine holds ${memory.toFixed(0)} MB`);
    await t.check(memory > 0 && memory < 500, 'its memory');
    const there = await demo.model();
    const file = path.join(process.env.CORPORA, name);
    await within(async (folder) => {
      const [model, runs] = ['a.model', 'runs.json'].map((one) => path.join(folder, one));
      await commandLine(t, 'train', '--corpus', file, '--epochs', PASSES, '--out', model);
      await t.check((await readFile(model, 'utf8')) === there, 'the models are the same');
      const { figures, plan } = await crossed(demo);
      await writeFile(runs, plan);
      const repeated = await commandLine(t, 'experiment', 'run', '--plan', runs, '--corpus', file, '--csv');
      await t.equal(repeated, figures, 'the figures of a cross-validation');
    });
  });
}
