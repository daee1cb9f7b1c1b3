// What was learned: entries are looked through and left out, errors are named, two models are held against each other.

import { flow } from '../flow.mjs';
import { openTrain } from '../page.mjs';

flow('the lexicon is looked through, an entry is left out, and two models are compared', async (t) => {
  const demo = await openTrain(t);
  await demo.train();
  const model = await demo.model();
  await demo.part('lexicon');
  const shown = () => demo.by('entries-shown').textContent();
  await t.check(async () => /of \d+ entries/.test(await shown()), 'the entries');
  await demo.by('search-entries').fill('xyzzy');
  await t.check(async () => (await shown()) === 'No entry holds this.', 'none');
  await demo.by('learned-only').check();
  await demo.by('search-entries').fill('room');
  await t.check(async () => (await demo.by('entries').locator('tbody tr').count()) >= 1, 'an entry of a word that was learned');
  await t.accessible('the lexicon');
  await t.fits('the lexicon');
  await t.shot('bench-lexicon');
  await demo.by('entries').getByRole('checkbox').first().check();
  await demo.press('leave-out');
  await demo.part('run');
  await t.check(async () => /without 1 entries/.test(await demo.by('trained').textContent()), 'the robot uses the model without it');
  await demo.part('lexicon');
  await demo.by('compare-file').setInputFiles({ name: 'whole.model', mimeType: 'text/plain', buffer: Buffer.from(model) });
  await demo.by('compared').waitFor();
  await t.check(async () => /1 entries of whole\.model alone/.test(await demo.by('compare').textContent()), 'what tells them apart');
  await t.accessible('two models');
  await demo.part('data');
  await demo.press('audit');
  await demo.says(/Every row is judged/);
  await demo.part('lexicon');
  await t.check(async () => (await demo.by('errors').locator('table').count()) > 0, 'where it errs');
  await t.accessible('errors');
  await t.shot('bench-errors');
  await demo.by('search-entries').fill('');
  await demo.by('learned-only').uncheck();
  await demo.page.getByRole('button', { name: 'Rows', exact: true }).click();
  await demo.page.getByRole('button', { name: 'Rows', exact: true }).click();
  await demo.by('sentence').first().waitFor();
  // Read and pressed at once: entries that come meanwhile put others in its place.
  const words = await demo.by('sentence').first().evaluate((sentence) => {
    sentence.click();
    return sentence.textContent;
  });
  await demo.by('open-row').waitFor();
  await t.check(async () => (await demo.by('open-row').textContent()).includes(words), 'the row that a sentence is of');
});
