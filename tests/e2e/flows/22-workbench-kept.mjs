// What the workbench keeps: a run goes on where it was after a reload and after a closed tab, to the bytes of a run that
// nothing stopped; a full store is told and loses nothing; corpora and models are kept, listed, opened, saved, deleted.

import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { OUT, flow } from '../flow.mjs';
import { Demo, csv, openTrain, rows } from '../page.mjs';

/** The six, many times over and never in the same words: it takes a while to learn them. */
const many = (times) => csv(...Array.from({ length: times }, (_, time) => rows.slice(1).map(
  (row) => row.replace(/"([^"]*)"(?=,[^,]*,[^,]*$)/, `"$1 time${time}"`),
)).flat());

/** Has the engines rest between the parts of their work, so that a run outlasts what is done to it. */
async function slowed(demo) {
  await Promise.all(demo.page.workers().map((worker) => worker.evaluate(() => {
    const own = MessagePort.prototype.postMessage;
    MessagePort.prototype.postMessage = function postMessage(...all) {
      setTimeout(() => own.apply(this, all), 50);
    };
  })));
}

/** Trains on a corpus of this text in so many passes, slowly, and waits until the run is kept. */
async function keptRun(demo, name, text, passes) {
  const { t } = demo;
  await demo.choose(name, text);
  await t.until('the file is open', async () => (await demo.corpus()).name === name);
  await slowed(demo);
  await demo.part('run');
  await demo.passes(passes);
  await demo.press('train');
  await demo.by('progress').waitFor();
  await demo.part('kept');
  await t.until('the run and its corpus are kept', async () =>
    (await demo.page.locator('[data-testid="shelf-item"][data-kind="run"]').count()) === 1
    && (await demo.page.locator('[data-testid="shelf-item"][data-kind="corpus"]').count()) === 1);
  await demo.part('run');
}

/** Passes of a run that is seen to its end. */
const PASSES = 300;

/** How far the run is: the pass and the command. */
async function reached(demo) {
  const words = await demo.by('progress').textContent();
  const [, pass, command] = /Pass (\d+) of \d+, command (\d+)/.exec(words);
  return Number(pass) * 1e6 + Number(command);
}

flow('a run goes on after a reload and after a closed tab, to the same bytes', async (t) => {
  const corpus = many(200);
  const demo = await openTrain(t);
  await keptRun(demo, 'mine.csv', corpus, PASSES);
  await t.until('it is in its second pass', async () => (await reached(demo)) > 2e6, 120);
  const before = await reached(demo);
  await demo.page.reload();
  await demo.by('run-came-back').waitFor();
  await slowed(demo);
  await t.check(async () => (await reached(demo)) > before - 1e6, 'it did not begin anew');
  await demo.page.close();
  const second = new Demo(t, await t.open(`${t.address}#train`));
  await second.by('run-came-back').waitFor();
  await second.page.screenshot({ path: path.join(OUT, 'bench-came-back.png') });
  await second.part('run');
  await t.until('it has trained', async () =>
    (await second.by('trained').count()) > 0 && /trained here on mine\.csv/.test(await second.by('trained').textContent()), 200);
  await t.equal(() => second.by('run-came-back').count(), 0, 'that it goes on is not told once it is over');
  const model = await second.model();
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  try {
    const [file, out] = ['mine.csv', 'a.model'].map((name) => path.join(folder, name));
    await writeFile(file, corpus);
    const { status, stderr } = await t.groundling('train', '--corpus', file, '--epochs', `${PASSES}`, '--out', out);
    await t.equal(status, 0, stderr);
    await t.check(async () => (await readFile(out, 'utf8')) === model, 'the model is that of a run that nothing stopped');
  } finally {
    await rm(folder, { recursive: true });
  }
});

flow('a store that fills up while it learns is told, and the run goes on', async (t) => {
  // The browser's own answer where there is no room; to have it really run out of room would take the machine's.
  await t.context.addInitScript(() => {
    const own = IDBTransaction.prototype.commit;
    IDBTransaction.prototype.commit = function commit() {
      if (globalThis.isFull && this.mode === 'readwrite') this.abort();
      else own.call(this);
    };
  });
  const demo = await openTrain(t);
  await keptRun(demo, 'mine.csv', many(400), 1000);
  await demo.page.evaluate(() => { globalThis.isFull = true; });
  await demo.by('run-not-kept').waitFor();
  await t.equal(() => demo.by('run-not-kept').getAttribute('data-fault'), 'full', 'the fault');
  await t.check(async () => /goes on[^]*kept as it was at pass/.test(await demo.by('run-not-kept').textContent()),
    async () => demo.by('run-not-kept').textContent());
  await t.accessible('a full store');
  await t.shot('bench-full');
  const at = await reached(demo);
  await t.check(async () => (await reached(demo)) > at, 'it goes on');
  await demo.part('kept');
  await t.equal(() => demo.by('shelf-item').count(), 2, 'what was kept is there');
  await demo.page.evaluate(() => { globalThis.isFull = false; });
  await demo.part('run');
  await t.until('it is kept again', async () => (await demo.by('run-not-kept').count()) === 0);
  await demo.press('stop');
});

flow('corpora and models are kept under a name, opened again, saved and deleted', async (t) => {
  const demo = await openTrain(t);
  await demo.choose('mine.csv', csv(...rows.slice(1, 4)));
  await t.until('the file is open', async () => (await demo.corpus()).name === 'mine.csv');
  await demo.by('row').nth(1).getByRole('checkbox').check();
  await demo.press('approve');
  await demo.train();
  const model = await demo.model();
  await demo.part('kept');
  await demo.by('kept-name').fill('three of six');
  await demo.press('keep-corpus');
  await demo.says(/“three of six” is kept/);
  await demo.by('kept-name').fill('the first model');
  await demo.press('keep-model');
  await demo.says(/“the first model” is kept/);
  await t.accessible('what is kept');
  await t.fits('what is kept');
  await t.shot('bench-kept');
  await demo.page.reload();
  await demo.by('row').first().waitFor();
  await t.until('what was trained on is open after a reload', async () => (await demo.corpus()).name === 'mine.csv');
  await demo.press('open-demo');
  await t.until('the six are open', async () => (await demo.corpus()).name === 'six.csv');
  await demo.part('kept');
  const of = (name) => demo.page.locator('[data-testid="shelf-item"]', { hasText: name });
  await of('three of six').getByTestId('shelf-open').click();
  await t.until('the corpus is open', async () => (await demo.corpus()).name === 'mine.csv');
  await t.check(async () => /approved/i.test(await demo.by('row').nth(1).textContent()), 'with what was decided');
  await demo.part('kept');
  await of('the first model').getByTestId('shelf-open').press('Enter');
  await t.check(async () => (await demo.model()) === model, 'the robot uses the model');
  await demo.part('kept');
  const [download] = await Promise.all([
    demo.page.waitForEvent('download'), of('three of six').getByTestId('shelf-save').click()]);
  await t.equal(download.suggestedFilename(), 'mine.csv', 'the file that was given');
  while ((await demo.by('shelf-delete').count()) > 0) {
    const left = await demo.by('shelf-delete').count();
    await demo.by('shelf-delete').first().press('Enter');
    await t.until('one less', async () => (await demo.by('shelf-delete').count()) < left);
  }
  await demo.by('shelf-empty').waitFor();
});

flow('a workbench without a store says so, and one in a second tab that the first keeps the runs', async (t) => {
  await t.elsewhere({ serviceWorkers: 'block' }, async (page) => {
    await page.addInitScript(() => Object.defineProperty(globalThis, 'indexedDB', { value: undefined }));
    await page.goto(`${t.address}#train`);
    const demo = new Demo(t, page);
    await demo.by('row').first().waitFor();
    await demo.train();
    await demo.part('kept');
    await t.equal(() => demo.by('shelf-fault').getAttribute('data-fault'), 'none', 'the fault');
  });
  const first = await openTrain(t);
  await first.train();
  const second = new Demo(t, await t.open(`${t.address}#train`));
  await second.by('row').first().waitFor();
  await second.part('kept');
  await t.equal(() => second.by('shelf-fault').getAttribute('data-fault'), 'elsewhere', 'the fault');
  await second.press('keep-runs-here');
  await t.until('it keeps them now', async () => (await second.by('shelf-fault').count()) === 0);
});
