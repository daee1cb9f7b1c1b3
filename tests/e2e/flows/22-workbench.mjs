// The workbench is a program of its own: it comes when its page is opened first, says so when it cannot come, and works on
// while the person talks.

import { flow } from '../flow.mjs';
import { csv, openPage, openTrain, rows, six } from '../page.mjs';

/** A corpus that takes long to learn: the six, many times over, and never in the same words. */
const LONG = csv(...Array.from({ length: 400 }, (_, time) => rows.slice(1).map(
  (row) => row.replace(/"([^"]*)"(?=,[^,]*,[^,]*$)/, `"$1 time${time}"`),
)).flat());

/** The files that the page has loaded for its workbench. */
const loaded = (page) => page.evaluate(() => performance.getEntriesByType('resource')
  .map(({ name }) => name.replace(/^.*\//, '')).filter((name) => /workbench/.test(name)).sort());

flow('the workbench is loaded when it is wanted, and stays', async (t) => {
  const demo = await openPage(t);
  await t.equal(() => loaded(demo.page), [], 'what the first view loads of it');
  await demo.workbench();
  await t.equal(() => loaded(demo.page), ['workbench.css', 'workbench.js', 'workbench_bg.wasm'], 'what it is made of');
  await t.accessible('the workbench');
  await demo.choose('long.csv', LONG);
  await t.until('the file is open', async () => (await demo.corpus()).name === 'long.csv');
  await demo.part('run');
  await demo.press('train');
  await demo.by('progress').waitFor();
  const before = await demo.by('progress').textContent();
  await demo.talk();
  await t.equal(() => demo.by('row').count(), 0, 'rows to be seen while one talks');
  await demo.ask('go to the blue room');
  await t.equal(() => demo.plain(), 'I will go to the blue room.', 'it answers while it trains');
  await demo.press('view-train');
  const now = () => demo.page.getByTestId('progress').or(demo.by('trained').filter({ hasText: 'long.csv' })).first().textContent();
  await t.check(async () => (await now()) !== before, 'training has gone on, to its end perhaps');
  await demo.by('language').selectOption('de');
  await t.check(async () => /Einstellungen/.test(await demo.page.locator('main').textContent()), 'it speaks the page\'s language');
});

flow('a workbench that does not come says so, and comes when asked again', async (t) => {
  t.expect(/workbench|Failed to fetch|ERR_FAILED/);
  const demo = await openPage(t);
  await t.context.route(/workbench\.js/, (route) => route.abort());
  await demo.press('view-train');
  await demo.by('no-workbench').waitFor();
  await t.accessible('a workbench that did not come');
  await t.context.unroute(/workbench\.js/);
  await demo.press('load-workbench');
  await demo.by('row').first().waitFor();
  await t.equal(() => demo.corpus(), { name: 'six.csv', rows: 6 }, 'what is open');
});

flow('files that are dropped while one talks go where they belong', async (t) => {
  const demo = await openTrain(t);
  await demo.train();
  const model = await demo.model();
  await demo.page.reload();
  await demo.by('row').first().waitFor();
  await demo.talk();
  await demo.dropAll([['a.model', model], ['three.csv', csv(...rows.slice(1, 4))]]);
  await t.equal(() => demo.corpus(), { name: 'three.csv', rows: 3 }, 'the corpus is open');
  await demo.part('run');
  await t.check(async () => /from a file/.test(await demo.by('trained').textContent()), 'the robot has the model');
  await demo.talk();
  await demo.drop('b.model', 'groundling model 99\n');
  await demo.by('model-notice').waitFor();
  await t.check(() => demo.by('command').isVisible(), 'one goes on talking');
  await demo.drop('none.csv', '');
  await t.check(async () => /none\.csv is empty/.test(await demo.by('file-notice').textContent()), 'what is wrong is said there');
  await demo.part('run');
  await demo.drop('six.csv', six);
  await t.equal(() => demo.corpus(), { name: 'six.csv', rows: 6 }, 'dropped on the workbench itself');
});
