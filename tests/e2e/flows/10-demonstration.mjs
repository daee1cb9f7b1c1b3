// The paper's own demonstration: six sentences teach the words, and an unseen command moves the robot.

import { mkdtemp, readFile, rm } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { BLUE_ROOM, openPage, rows } from '../page.mjs';

flow('six sentences, then “go to the blue room”', async (t) => {
  t.check(!/blue/i.test(rows.map((row) => row.split('","').at(-3)).join()), 'blue is in no training command');
  const demo = await openPage(t);
  t.equal(await demo.corpus(), { name: 'six.csv', rows: 6 }, 'the corpus that is open');
  await t.accessible('the first view');
  await demo.train();
  await demo.ask('go to the blue room');
  const reading = await demo.reading();
  t.equal(reading.form, BLUE_ROOM, 'the form');
  t.check(reading.human.includes('blue') && reading.human.includes('in('), `for people: ${reading.human}`);
  t.check(reading.score > 0, `a score above nothing: ${reading.score}`);
  t.check(/blue/.test(reading.derivation), 'the derivation names the word');
  t.check((await demo.robot()).place !== 'the blue room', 'the robot starts elsewhere');
  const steps = await demo.played();
  t.equal((await demo.robot()).place, 'the blue room', 'where the robot ends');
  t.check(steps > 1, `a plan of ${steps} steps`);
  await t.until('it is said aloud', async () =>
    /Done in \d+ steps\. The robot is in the blue room/.test(await demo.by('announcement').textContent()));
  await t.accessible('an answered command');
  await t.shot('demonstration');
});

flow('the page learns the same model as the command line, byte for byte', async (t) => {
  const demo = await openPage(t);
  await demo.train();
  const there = await demo.model();
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  try {
    const out = path.join(folder, 'six.model');
    const { status, stderr } = await t.groundling('train', '--corpus', 'assets/corpus/six.csv',
      '--lexicon', 'assets/lexicon/demonstration.txt', '--out', out);
    t.equal(status, 0, stderr);
    const here = await readFile(out, 'utf8');
    t.check(here.length > 1000, 'a model is a longer text');
    t.check(here === there, `the models differ: ${here.length} and ${there.length} characters`);
  } finally {
    await rm(folder, { recursive: true });
  }
});

flow('a plan is paused, stepped, scrubbed and undone', async (t) => {
  const demo = await openPage(t);
  await demo.train();
  const start = await demo.robot();
  await demo.ask('go to the blue room');
  await t.until('the first step', async () => (await demo.by('plan').getAttribute('data-at')) !== '0');
  await demo.by('plan-play').click();
  await demo.by('plan-first').click();
  t.equal(await demo.robot(), start, 'back at the start');
  await demo.by('plan-forward').click();
  t.equal(await demo.by('plan').getAttribute('data-at'), '1', 'one step on');
  await demo.by('plan-scrub').fill(await demo.by('plan').getAttribute('data-steps'));
  t.equal((await demo.robot()).place, 'the blue room', 'scrubbed to the end');
  await demo.by('undo').click();
  t.equal(await demo.robot(), start, 'undone');
});

flow('a model that was saved is opened again', async (t) => {
  const demo = await openPage(t);
  await demo.train();
  const model = await demo.model();
  await demo.page.reload();
  await demo.by('row').first().waitFor();
  await demo.by('model-file').setInputFiles({ name: 'a.model', mimeType: 'text/plain', buffer: Buffer.from(model) });
  await demo.by('trained').waitFor();
  await demo.ask('go to the blue room');
  t.equal((await demo.reading()).form, BLUE_ROOM, 'the form');
  t.check((await demo.model()) === model, 'the model is saved as it was opened');
});
