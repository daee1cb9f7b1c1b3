// The paper's own demonstration: six sentences teach the words, and an unseen command moves the robot.

import { mkdtemp, readFile, rm } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { BLUE_ROOM, openTrain, rows } from '../page.mjs';

flow('six sentences, then “go to the blue room”', async (t) => {
  await t.check(!/blue/i.test(rows.map((row) => row.split('","').at(-3)).join()), 'blue is in no training command');
  const demo = await openTrain(t);
  await t.equal(() => demo.corpus(), { name: 'six.csv', rows: 6 }, 'the corpus that is open');
  await t.accessible('the workbench');
  await demo.train();
  await t.accessible('a trained parser');
  await demo.talk();
  // Before it is asked: it may be under way as soon as it has been.
  await t.check(async () => (await demo.robot()).room !== 'blue', 'the robot starts elsewhere');
  await demo.ask('go to the blue room');
  await t.equal(() => demo.plain(), 'I will go to the blue room.', 'in plain words');
  const steps = await demo.played();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'where the robot ends');
  await t.check(steps > 1, `a plan of ${steps} steps`);
  await demo.says(/Done in \d+ steps\. The robot is in the blue room/);
  await t.equal(() => demo.form(), BLUE_ROOM, 'the form');
});

flow('the page learns the same model as the command line, byte for byte', async (t) => {
  const demo = await openTrain(t);
  await demo.train();
  const there = await demo.model();
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  try {
    const out = path.join(folder, 'six.model');
    const { status, stderr } = await t.groundling('train', '--corpus', 'assets/corpus/six.csv',
      '--lexicon', 'assets/lexicon/demonstration.txt', '--out', out);
    await t.equal(status, 0, stderr);
    const here = await readFile(out, 'utf8');
    await t.check(here.length > 1000, 'a model is a longer text');
    await t.check(here === there, `the models differ: ${here.length} and ${there.length} characters`);
  } finally {
    await rm(folder, { recursive: true });
  }
});

flow('a model that was saved is opened again', async (t) => {
  const demo = await openTrain(t);
  await demo.train();
  const model = await demo.model();
  await demo.page.reload();
  await demo.by('row').first().waitFor();
  await demo.part('run');
  await demo.by('model-file').setInputFiles({ name: 'a.model', mimeType: 'text/plain', buffer: Buffer.from(model) });
  await t.until('the model is open', async () => /from a file/.test(await demo.by('trained').textContent()));
  await t.check(async () => (await demo.model()) === model, 'the model is saved as it was opened');
  await demo.talk();
  await demo.ask('go to the blue room');
  await t.equal(() => demo.plain(), 'I will go to the blue room.', 'in plain words');
});
