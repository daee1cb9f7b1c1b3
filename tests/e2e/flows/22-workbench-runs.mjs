// Experiments on the workbench: runs are planned, shared out, compared, saved and repeated from their file; the paper's
// are one press each.

import { flow } from '../flow.mjs';
import { Demo, openTrain } from '../page.mjs';

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
  await demo.by('experiment').selectOption({ label: 'Learning curve' });
  await demo.by('needs-held-out').waitFor();
  await t.check(() => demo.by('run').isDisabled(), 'nothing is held out');
});

flow('four engines find what one finds', async (t) => {
  const found = async (cores) => {
    const context = await t.context.browser().newContext({ serviceWorkers: 'block', reducedMotion: 'reduce' });
    try {
      const page = await context.newPage();
      await page.addInitScript((n) => {
        Object.defineProperty(Navigator.prototype, 'hardwareConcurrency', { get: () => n });
      }, cores);
      await page.goto(`${t.address}#train`);
      const demo = new Demo(t, page);
      await demo.by('row').first().waitFor();
      await demo.part('run');
      await demo.by('setting-epochs').fill('2');
      await demo.by('setting-epochs').blur();
      await demo.part('experiments');
      await demo.press('run');
      if (cores > 1) await t.check(async () => /by 4 engines/.test(await demo.by('pool').textContent()), 'four engines');
      await demo.by('runs').waitFor({ timeout: 60_000 });
      return await demo.saved('save-csv');
    } finally {
      await context.close();
    }
  };
  const [several, one] = [await found(8), await found(1)];
  await t.equal(several, one, 'the figures');
});

flow('the paper’s experiments are one press each', async (t) => {
  const demo = await openTrain(t);
  await demo.part('experiments');
  await demo.press('six-sentences');
  await demo.by('six-found').waitFor({ timeout: 60_000 });
  await t.check(async () => /Learned from 6 sentences; 6 of them/.test(await demo.by('six-found').textContent()), 'what was learned');
  await t.check(async () => /blue\(x\)[^]*carried out in \d+ steps/.test(await demo.by('six-found').textContent()), 'what was done');
  await demo.part('run');
  await demo.by('setting-epochs').fill('1');
  await demo.by('setting-epochs').blur();
  await demo.part('experiments');
  await demo.by('paper-share').waitFor();
  await demo.press('table-2');
  await demo.by('runs').waitFor({ timeout: 60_000 });
  await t.equal(() => demo.by('runs').locator('tbody th').allTextContents(), ['pruned, 3', 'pruned, 2', 'pruned, 1'], 'the rows');
  await t.check(async () => /0\.820/.test(await demo.by('runs').textContent()), 'the paper’s figure');
  await t.check(async () => /<svg[^]*pruned, 3[^]*<\/svg>/.test(await demo.saved('save-svg')), 'as a picture');
  await t.accessible('a table of the paper');
  await t.shot('bench-table-2');
});
