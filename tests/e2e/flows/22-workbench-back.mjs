// What comes back to the workbench behind a reload: a run that is over with its rows, what was decided of them since, and
// what was learned; and what experiments found, which is listed, opened, saved and deleted like a run.

import { flow } from '../flow.mjs';
import { csv, openTrain, rows, six } from '../page.mjs';

/** How many rows are learned from, held out and rejected, as the page says it. */
const count = (demo) => demo.by('corpus-count').textContent();

/** Whether anything that is kept holds these words. */
const isKept = (page, words) => page.evaluate(async (sought) => {
  const name = (await indexedDB.databases()).map((one) => one.name).find((one) => one.startsWith('groundling'));
  const database = await new Promise((resolve) => {
    indexedDB.open(name).onsuccess = ({ target }) => resolve(target.result);
  });
  const all = await new Promise((resolve) => {
    database.transaction('texts').objectStore('texts').getAll().onsuccess = ({ target }) => resolve(target.result);
  });
  database.close();
  return all.some((one) => (typeof one === 'string' ? one : new TextDecoder().decode(one)).includes(sought));
}, words);

/** The lexicon's lines as the page shows them: words, category, meaning, weight, and what each came from. */
const learned = async (demo) => {
  await demo.part('lexicon');
  await demo.by('learned-only').check();
  await demo.by('search-entries').fill('room');
  // Known before, too, are many more.
  await demo.t.check(async () => /^1 to \d of \d entries/.test(await demo.by('entries-shown').textContent()), 'entries that were learned');
  return demo.by('entries').locator('tbody tr').allTextContents();
};

flow('a run that is over is there again behind a reload, with its rows and what was learned', async (t) => {
  const demo = await openTrain(t);
  // The bytes of the six are learned from with the lexicon that knows no nouns.
  await demo.choose('mine.csv', six);
  await t.until('the file is open', async () => (await demo.corpus()).name === 'mine.csv');
  await demo.page.locator('#row-4').getByRole('checkbox').check();
  await demo.press('put-held-out');
  await t.check(async () => /1 held out/.test(await count(demo)), 'a row is held out');
  await demo.train();
  const model = await demo.model();
  const curves = await demo.by('curves').locator('figure').count();
  const entries = await learned(demo);
  await demo.part('data');
  await demo.page.locator('#row-4').getByRole('checkbox').uncheck();
  await demo.page.locator('#row-0').getByRole('checkbox').check();
  await demo.by('reason').fill('decided since');
  await demo.press('reject');
  await t.check(async () => /1 rejected/.test(await count(demo)), 'a row is rejected since');
  const rest = await count(demo);
  await t.until('what was decided is kept', () => isKept(demo.page, 'decided since'));
  await demo.page.reload();
  await demo.by('row').first().waitFor();
  await t.until('the corpus is there again', async () => (await demo.corpus()).name === 'mine.csv');
  await t.equal(() => count(demo), rest, 'what was decided');
  await t.check(async () => /rejected/i.test(await demo.page.locator('#row-0').textContent()), 'the row that was rejected');
  await t.until('what was learned is there, and where it came from', async () =>
    JSON.stringify(await learned(demo)) === JSON.stringify(entries));
  await demo.part('run');
  await t.check(async () => /trained here on mine\.csv/.test(await demo.by('trained').textContent()), 'the model');
  await t.equal(() => demo.by('curves').locator('figure').count(), curves, 'its curves');
  await t.equal(() => demo.by('run-came-back').count(), 0, 'that a run goes on');
  await t.check(async () => (await demo.model()) === model, 'the model, byte for byte');
  await t.accessible('a run that came back');
});

flow('a run whose corpus did not stay says so behind a reload', async (t) => {
  const demo = await openTrain(t);
  await demo.choose('mine.csv', csv(...rows.slice(1, 4)));
  await t.until('the file is open', async () => (await demo.corpus()).name === 'mine.csv');
  await demo.train();
  await demo.part('kept');
  await t.until('the run and its corpus are kept', async () => (await demo.by('shelf-item').count()) === 2);
  await demo.page.locator('[data-testid="shelf-item"][data-kind="corpus"]').getByTestId('shelf-delete').click();
  await t.until('one less', async () => (await demo.by('shelf-item').count()) === 1);
  await demo.page.reload();
  await demo.by('row').first().waitFor();
  await demo.says(/mine\.csv[^]*is not kept any more/);
  await demo.part('run');
  await demo.by('run-came-back').waitFor();
  await t.check(async () => (await demo.by('curves').locator('figure').count()) > 0, 'its curves are there');
});

flow('the robot’s lexicon is to be seen where nothing was trained', async (t) => {
  const demo = await openTrain(t);
  await demo.part('lexicon');
  await t.check(async () => /of \d{3,} entries/.test(await demo.by('entries-shown').textContent()), 'the entries of the model that the page opens with');
});

flow('what an experiment found is kept behind a reload, saved, and deleted', async (t) => {
  const demo = await openTrain(t);
  await demo.part('run');
  await demo.passes(2);
  await demo.part('experiments');
  await demo.by('folds').fill('2');
  await demo.by('folds').blur();
  await demo.press('run');
  await demo.by('runs').waitFor();
  await demo.says(/“2 folds by command, 1” is kept/);
  await t.check(async () => /seed 0, 2 passes/.test(await demo.by('result-settings').textContent()), 'its settings and seed');
  const found = await demo.saved('save-csv');
  const plan = await demo.saved('save-plan');
  await demo.page.reload();
  await demo.by('row').first().waitFor();
  await demo.part('experiments');
  await demo.by('runs').waitFor();
  await t.equal(() => demo.saved('save-csv'), found, 'the figures');
  await t.equal(() => demo.saved('save-plan'), plan, 'the runs, to repeat them');
  await demo.part('kept');
  const item = demo.page.locator('[data-testid="shelf-item"][data-kind="experiment"]');
  await t.equal(() => item.count(), 1, 'it is listed');
  await t.accessible('an experiment that is kept');
  const [download] = await Promise.all([demo.page.waitForEvent('download'), item.getByTestId('shelf-save').click()]);
  await t.equal(download.suggestedFilename(), '2 folds by command, 1.json', 'as a file');
  await item.getByTestId('shelf-open').click();
  await demo.by('runs').waitFor();
  await demo.press('forget-result');
  await t.until('it is gone', async () => (await demo.by('runs').count()) === 0);
  await demo.part('kept');
  await t.until('from the list, too', async () => (await item.count()) === 0);
});
