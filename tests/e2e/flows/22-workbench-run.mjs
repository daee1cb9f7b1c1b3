// Training on the workbench: settings, pause, steps, stop and going on; curves on what is held out; an engine that is
// killed loses nothing but some seconds.

import { flow } from '../flow.mjs';
import { csv, openTrain, rows } from '../page.mjs';

/** A corpus that takes long to learn: the six, many times over, and never in the same words. */
const LONG = csv(...Array.from({ length: 400 }, (_, time) => rows.slice(1).map(
  (row) => row.replace(/"([^"]*)"(?=,[^,]*,[^,]*$)/, `"$1 time${time}"`),
)).flat());

/** The page with a long corpus, at its training. */
async function long(t) {
  const demo = await openTrain(t);
  await demo.choose('long.csv', LONG);
  await t.until('the file is open', async () => (await demo.corpus()).name === 'long.csv');
  await demo.part('run');
  return demo;
}

flow('training rests, goes on step by step, is stopped and gone on with', async (t) => {
  const demo = await long(t);
  const at = () => demo.by('progress').textContent();
  await demo.press('step-example');
  await t.check(async () => /command 1 of 2400/.test(await at()), 'one example');
  await demo.by('go-on').waitFor();
  await demo.press('step-example');
  await t.check(async () => /command 2 of 2400/.test(await at()), 'one more');
  await t.check(async () => (await demo.by('now-command').textContent()).length > 0, 'what was learned is shown');
  await t.accessible('a run that rests');
  await t.shot('bench-rests');
  await demo.by('go-on').waitFor();
  await demo.press('go-on');
  await t.check(async () => !/command 2 of/.test(await at()), 'it goes on');
  await demo.press('pause');
  await demo.by('go-on').waitFor();
  await demo.press('stop');
  await demo.by('resume').waitFor();
  await t.accessible('a run that was stopped');
  await demo.press('resume');
  await demo.by('pause').waitFor();
  await demo.press('stop');
});

flow('curves show how the model does on what is held out', async (t) => {
  const demo = await openTrain(t);
  await demo.holdOut(33);
  await demo.part('run');
  await demo.passes(6);
  await demo.by('paper').waitFor();
  await demo.train();
  await t.check(async () => (await demo.by('curves').locator('figure').count()) === 4, 'four charts');
  await demo.page.locator('[data-testid="curves"] summary').click();
  await t.check(async () => (await demo.by('curves-table').locator('tbody tr').count()) >= 6, 'a row a pass');
  await t.accessible('curves');
  await t.shot('bench-curves');
  await demo.press('paper');
  await t.equal(() => demo.by('setting-epochs').inputValue(), '15', 'the paper\'s settings');
});

flow('an engine that is killed while it learns goes on where it was', async (t) => {
  const demo = await long(t);
  await demo.passes(1000);
  await demo.press('train');
  await demo.by('progress').waitFor();
  await t.until('some seconds of work', async () => /[5-9] s so far|\d\d s so far/.test(await demo.by('progress').textContent()));
  await demo.page.evaluate(() => {
    const learner = globalThis.flowWorkers.at(-1);
    learner.terminate();
    learner.dispatchEvent(new ErrorEvent('error', { message: 'an invented end' }));
  });
  await t.check(async () => (await demo.by('engine-stopped').count()) === 0, 'nobody is asked to start it again');
  const at = await demo.by('progress').textContent();
  await t.until('it goes on', async () => (await demo.by('progress').textContent()) !== at);
  await t.check(() => demo.page.evaluate(() => globalThis.flowWorkers.length >= 3), 'in a new engine');
  await demo.press('stop');
});

flow('training goes on while another tab is to be seen', async (t) => {
  const demo = await long(t);
  await demo.passes(1000);
  await demo.press('train');
  await demo.by('progress').waitFor();
  const other = await t.context.newPage();
  await other.bringToFront();
  await demo.page.evaluate(() => {
    Object.defineProperty(document, 'hidden', { configurable: true, get: () => true });
    Object.defineProperty(document, 'visibilityState', { configurable: true, get: () => 'hidden' });
    document.dispatchEvent(new Event('visibilitychange'));
  });
  const at = await demo.by('progress').textContent();
  await t.until('it goes on', async () => (await demo.by('progress').textContent()) !== at);
  await demo.page.bringToFront();
  await other.close();
  await demo.press('stop');
});

flow('the workbench on a phone, in the dark and in German', { viewport: { width: 390, height: 844 }, colorScheme: 'dark', locale: 'de-DE' }, async (t) => {
  const demo = await openTrain(t);
  await t.fits('the corpus on a phone');
  const cut = () => demo.by('row').locator('.said .clip').evaluateAll((all) =>
    all.filter((one) => one.scrollHeight > one.clientHeight + 1 || one.scrollWidth > one.clientWidth + 1).map((one) => one.textContent));
  await t.equal(cut, [], 'commands of the six that are cut short');
  await t.accessible('the corpus on a phone');
  await t.shot('bench-phone-data');
  await demo.part('run');
  await demo.press('train');
  await demo.by('curves').waitFor();
  await t.until('it has trained', async () => /hier auf six\.csv/.test(await demo.by('trained').textContent()));
  await t.fits('training on a phone');
  await t.accessible('training on a phone');
  await t.shot('bench-phone-run');
});
