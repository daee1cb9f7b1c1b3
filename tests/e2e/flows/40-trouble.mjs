// Trouble below the page: long work is cancelled, the engine dies, the GPU goes away. Nothing loaded is lost.

import { flow } from '../flow.mjs';
import { BLUE_ROOM, csv, openPage, rows } from '../page.mjs';

/** A corpus that takes long to learn: the six, many times over, and never in the same words. */
const LONG = csv(...Array.from({ length: 400 }, (_, time) => rows.slice(1).map(
  (row) => row.replace(/"([^"]*)"(?=,[^,]*,[^,]*$)/, `"$1 time${time}"`),
)).flat());

flow('training is cancelled, and answers at once', async (t) => {
  const demo = await openPage(t);
  await demo.train();
  const model = await demo.model();
  await demo.choose('long.csv', LONG);
  await t.until('the file is open', async () => (await demo.corpus()).name === 'long.csv');
  await demo.by('train').click();
  await demo.by('progress').waitFor();
  const first = await demo.by('progress').textContent();
  await t.until('progress goes on', async () => (await demo.by('progress').textContent()) !== first);
  await demo.by('cancel').click();
  await demo.by('model-notice').waitFor();
  t.check(/stopped/.test(await demo.by('model-notice').textContent()), 'it says so');
  t.check((await demo.model()) === model, 'the model of before is kept');
  await demo.ask('go to the blue room');
  t.equal((await demo.reading()).form, BLUE_ROOM, 'and answers');
  await demo.by('train').click();
  await demo.by('progress').waitFor();
  await t.accessible('training');
});

flow('the engine is killed and started again', async (t) => {
  const demo = await openPage(t);
  await demo.train();
  const model = await demo.model();
  await demo.page.evaluate(() => globalThis.flowWorkers.forEach((worker) => worker.terminate()));
  await demo.by('command').fill('go to the blue room');
  await demo.by('ask').click();
  await demo.by('engine-stopped').waitFor({ timeout: 30_000 });
  await t.accessible('an engine that has stopped');
  await t.shot('engine-stopped');
  await demo.by('restart-engine').click();
  await t.until('the engine is back', async () => (await demo.by('engine-stopped').count()) === 0);
  t.equal(await demo.corpus(), { name: 'six.csv', rows: 6 }, 'the corpus is kept');
  t.check((await demo.model()) === model, 'the model is kept');
  await t.until('it can be asked', () => demo.by('ask').isEnabled());
  await demo.ask('go to the blue room');
  t.equal((await demo.reading()).form, BLUE_ROOM, 'and answers');
});
