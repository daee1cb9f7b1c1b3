// Experiments on the workbench: runs are planned, run, compared, saved and repeated from their file; and stopped.

import { flow } from '../flow.mjs';
import { openTrain } from '../page.mjs';

flow('a cross-validation is run, saved, and repeated from its file to the same figures', async (t) => {
  const demo = await openTrain(t);
  await demo.part('run');
  await demo.by('setting-epochs').fill('3');
  await demo.by('setting-epochs').blur();
  await demo.part('experiments');
  await demo.by('folds').fill('3');
  await demo.by('folds').blur();
  await t.accessible('experiments');
  await demo.press('run');
  await demo.by('runs').waitFor({ timeout: 60_000 });
  await t.equal(() => demo.by('runs').locator('tbody tr').count(), 4, 'three runs, and all together');
  await t.accessible('results');
  await t.fits('results');
  await t.shot('bench-results');
  const first = await demo.saved('save-csv');
  const plan = await demo.saved('save-plan');
  await t.check(/"groundling runs"/.test(plan), 'the file says what it is');
  await demo.press('forget-result');
  await demo.by('runs-file').setInputFiles({ name: 'runs.json', mimeType: 'application/json', buffer: Buffer.from(plan) });
  await demo.by('runs').waitFor({ timeout: 60_000 });
  await t.equal(() => demo.saved('save-csv'), first, 'the figures of the same runs');
  await demo.by('runs-file').setInputFiles({ name: 'none.json', mimeType: 'application/json', buffer: Buffer.from('{}') });
  await demo.by('experiment-notice').waitFor();
  await demo.by('experiment').selectOption({ label: 'The paper\'s Table III' });
  await demo.by('needs-held-out').waitFor();
  await t.check(() => demo.by('run').isDisabled(), 'nothing is held out');
});
