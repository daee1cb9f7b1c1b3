// Trouble below the page: long work is cancelled, an engine dies. Nothing loaded, said or shown is lost.

import { flow } from '../flow.mjs';
import { csv, openPage, openTrain, rows } from '../page.mjs';

/** A corpus that takes long to learn: the six, many times over, and never in the same words. */
const LONG = csv(...Array.from({ length: 400 }, (_, time) => rows.slice(1).map(
  (row) => row.replace(/"([^"]*)"(?=,[^,]*,[^,]*$)/, `"$1 time${time}"`),
)).flat());

flow('training is cancelled, and answers at once', async (t) => {
  const demo = await openTrain(t);
  await demo.train();
  const model = await demo.model();
  await demo.choose('long.csv', LONG);
  await t.until('the file is open', async () => (await demo.corpus()).name === 'long.csv');
  await demo.part('run');
  await demo.press('train');
  await demo.by('progress').waitFor();
  const first = await demo.by('progress').textContent();
  await t.until('progress goes on', async () => (await demo.by('progress').textContent()) !== first);
  await demo.press('stop');
  await demo.by('model-notice').waitFor();
  await t.check(async () => /stopped/.test(await demo.by('model-notice').textContent()), 'it says so');
  await t.check(async () => (await demo.model()) === model, 'the model of before is kept');
  await demo.press('train');
  await demo.by('progress').waitFor();
  await t.accessible('training');
  await demo.talk();
  await demo.ask('go to the blue room');
  await t.equal(() => demo.plain(), 'I will go to the blue room.', 'it answers while it trains');
});

flow('the engine is killed while it plans, and started again', async (t) => {
  const demo = await openPage(t);
  await demo.mode('edit');
  await demo.drag([8, 6], [8, 2]);
  const world = await demo.world();
  await demo.by('command').fill('put the block in the blue room');
  // A click and the end of the worker in one go: the plan cannot have come.
  await demo.by('ask').evaluate((button) => {
    button.click();
    globalThis.flowWorkers.forEach((worker) => worker.terminate());
  });
  await demo.by('engine-stopped').waitFor();
  await t.accessible('an engine that has stopped');
  await t.shot('engine-stopped');
  await t.equal(() => demo.world(), world, 'the room');
  await t.equal(() => demo.by('command').inputValue(), 'put the block in the blue room', 'the command');
  await demo.press('restart-engine');
  await demo.ready();
  await t.equal(() => demo.by('engine-stopped').count(), 0, 'messages');
  await demo.press('ask');
  await demo.answered('the command');
  await demo.finish();
  await t.check(async () => /yellow block in the blue room/.test(await demo.world()), 'and it is done');
  await demo.press('undo');
  await t.equal(() => demo.world(), world, 'the command is undone');
  await demo.press('undo');
  await t.check(async () => await demo.world() !== world, 'what was changed before is undone, too');
});

flow('the engine that learns is killed while it is taught', async (t) => {
  const demo = await openPage(t);
  await demo.mode('teach');
  await demo.drag([6, 2], [2, 6]);
  await demo.by('lesson').fill('scurry to the blue room');
  await demo.by('teach').evaluate((button) => {
    button.click();
    const learner = globalThis.flowWorkers.at(-1);
    learner.terminate();
    learner.dispatchEvent(new ErrorEvent('error', { message: 'an invented end' }));
  });
  await demo.by('engine-stopped').waitFor();
  await t.check(async () => /an invented end/.test(await demo.by('engine-report').textContent()), 'how it ended');
  await t.equal(() => demo.by('lesson').inputValue(), 'scurry to the blue room', 'the words');
  await t.equal(async () => (await demo.robot()).room, 'blue', 'what was shown');
  await demo.press('restart-engine');
  await t.until('the engine is back', async () => (await demo.by('engine-stopped').count()) === 0);
  await demo.press('teach');
  await demo.by('learned').waitFor();
  await t.equal(async () => (await demo.robot()).room, 'green', 'the room is as it was before the demonstration');
});
