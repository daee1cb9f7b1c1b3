// Experiments on the workbench: runs are planned, shared out, compared, saved and repeated from their file; the paper's
// are one press each.

import { flow } from '../flow.mjs';
import { Demo, csv, openTrain, rows } from '../page.mjs';

flow('a cross-validation is run, saved, and repeated from its file to the same figures', async (t) => {
  const demo = await openTrain(t);
  await demo.part('run');
  await demo.passes(3);
  await demo.part('experiments');
  await demo.by('folds').fill('3');
  await demo.by('folds').blur();
  await t.accessible('experiments');
  await demo.press('run');
  await demo.by('runs').waitFor();
  await t.equal(() => demo.by('runs').locator('tbody tr').count(), 4, 'three runs, and all together');
  await t.accessible('results');
  await t.fits('results');
  await t.shot('bench-results');
  const first = await demo.saved('save-csv');
  const plan = await demo.saved('save-plan');
  await t.check(/"groundling runs"/.test(plan), 'the file says what it is');
  await demo.press('forget-result');
  await demo.by('runs-file').setInputFiles({ name: 'runs.json', mimeType: 'application/json', buffer: Buffer.from(plan) });
  await demo.by('runs').waitFor();
  await t.equal(() => demo.saved('save-csv'), first, 'the figures of the same runs');
  await demo.by('runs-file').setInputFiles({ name: 'none.json', mimeType: 'application/json', buffer: Buffer.from('{}') });
  await demo.by('experiment-notice').waitFor();
  await demo.by('experiment').selectOption({ label: 'Learning curve' });
  await demo.by('needs-held-out').waitFor();
  await t.check(() => demo.by('run').isDisabled(), 'nothing is held out');
});

flow('four engines find what one finds', async (t) => {
  const found = (cores) => t.elsewhere({ serviceWorkers: 'block', reducedMotion: 'reduce' }, async (page) => {
    await page.addInitScript((n) => {
      Object.defineProperty(Navigator.prototype, 'hardwareConcurrency', { get: () => n });
    }, cores);
    await page.goto(`${t.address}#train`);
    const demo = new Demo(t, page);
    await demo.by('row').first().waitFor();
    await demo.part('run');
    await demo.passes(2);
    await demo.part('experiments');
    // Who is at work is told until it is done, which may be at once.
    await page.evaluate(() => {
      globalThis.told = new Set();
      const tell = () => globalThis.told.add(document.querySelector('[data-testid=pool]')?.textContent ?? '');
      new MutationObserver(tell).observe(document.body, { subtree: true, childList: true, characterData: true });
    });
    await demo.press('run');
    await demo.by('runs').waitFor();
    const told = () => page.evaluate(() => [...globalThis.told].join('\n'));
    if (cores > 1) await t.check(async () => /by 4 engines/.test(await told()), 'four engines');
    return await demo.saved('save-csv');
  });
  const [several, one] = [await found(8), await found(1)];
  await t.equal(several, one, 'the figures');
});

flow('the paper’s experiments are one press each', async (t) => {
  const demo = await openTrain(t);
  await demo.part('experiments');
  await demo.press('six-sentences');
  await demo.by('six-found').waitFor();
  await t.check(async () => /Learned from 6 sentences; 6 of them/.test(await demo.by('six-found').textContent()), 'what was learned');
  await t.check(async () => /blue\(x\)[^]*carried out in \d+ steps/.test(await demo.by('six-found').textContent()), 'what was done');
  await demo.part('run');
  await demo.passes(1);
  await demo.part('experiments');
  await demo.by('paper-share').waitFor();
  await demo.press('table-2');
  await demo.by('runs').waitFor();
  await t.equal(() => demo.by('runs').locator('tbody th').allTextContents(), ['pruned, 3', 'pruned, 2', 'pruned, 1'], 'the rows');
  await t.check(async () => /0\.820/.test(await demo.by('runs').textContent()), 'the paper’s figure');
  await t.check(async () => /<svg[^]*pruned, 3[^]*<\/svg>/.test(await demo.saved('save-svg')), 'as a picture');
  await t.accessible('a table of the paper');
  await t.shot('bench-table-2');
});

flow('learning curves, ablations and seeds are run on what is held out', async (t) => {
  const demo = await openTrain(t);
  await demo.holdOut(33);
  await demo.part('run');
  await demo.passes(1);
  await demo.part('experiments');
  const names = async (experiment) => {
    const before = await demo.by('runs').count();
    await demo.by('experiment').selectOption({ label: experiment });
    await demo.press('run');
    await t.until(`${experiment} is done`, async () => (await demo.by('runs').count()) > before);
    return demo.by('runs').first().locator('tbody th').allTextContents();
  };
  const shares = await names('Learning curve');
  await t.equal(shares.at(-1), '100 %', 'the last share');
  const without = await names('Without each kind of features');
  await t.check(without[0] === 'all features' && without.length > 3 && without.slice(1).every((name) => /^without /.test(name)),
    `the runs: ${without.join(', ')}`);
  const fewer = await names('With 1, 2 and 3 demonstrations');
  await t.equal(fewer.length, 3, 'numbers of demonstrations');
  const seeds = await names('Several seeds');
  await t.equal(seeds.slice(0, 2), ['seed 0', 'seed 1'], 'the seeds');
  await t.equal(() => demo.by('results').locator('h3').count(), 4, 'beside one another');
  await t.check(async () => /seed 0, 1 passes/.test(await demo.by('result-settings').first().textContent()), 'with settings and seed');
  await t.accessible('several results');
  await t.fits('several results');
});

flow('several engines are asked about every row, to the same end', async (t) => {
  const many = csv(...Array.from({ length: 40 }, (_, time) => rows.slice(1).map(
    (row) => row.replace(/"([^"]*)"(?=,[^,]*,[^,]*$)/, `"$1 time${time}"`),
  )).flat());
  const found = (cores) => t.elsewhere({ serviceWorkers: 'block', reducedMotion: 'reduce' }, async (page) => {
    await page.addInitScript((n) => {
      Object.defineProperty(Navigator.prototype, 'hardwareConcurrency', { get: () => n });
      const Own = globalThis.Worker;
      globalThis.begun = 0;
      globalThis.Worker = class extends Own {
        constructor(...all) { super(...all); globalThis.begun += 1; }
      };
    }, cores);
    await page.goto(`${t.address}#train`);
    const demo = new Demo(t, page);
    await demo.by('row').first().waitFor();
    await demo.choose('many.csv', many);
    await t.until('the file is open', async () => (await demo.corpus()).name === 'many.csv');
    const before = await page.evaluate(() => globalThis.begun);
    await demo.press('audit');
    // There is something to choose once all rows are judged.
    await demo.by('filter-outcome').waitFor({ timeout: 120_000 });
    const engines = (await page.evaluate(() => globalThis.begun)) - before;
    const outcomes = await demo.by('filter-outcome').locator('option').allTextContents();
    await demo.part('lexicon');
    await t.check(async () => (await demo.by('errors').locator('table').count()) > 0, 'where it errs');
    return { engines, outcomes, errors: await demo.by('errors').textContent() };
  });
  const [several, one] = [await found(3), await found(1)];
  await t.equal([several.engines, one.engines], [3, 0], 'engines besides the one of the data');
  await t.equal(several.outcomes, one.outcomes, 'what it makes of the rows');
  await t.equal(several.errors, one.errors, 'where it errs');
});
