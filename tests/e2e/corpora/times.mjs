// How long the page's worker takes to learn the paper's larger corpora, and to answer with what it learned: reported,
// never asserted. Files that are not in the folder are passed over.

import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { openTrain } from '../page.mjs';

const CORPORA = ['amt-50-train.csv', 'amt-pruned-train.csv'];

for (const name of CORPORA) {
  flow(`the worker's time on ${name}`, async (t) => {
    const text = await readFile(path.join(process.env.CORPORA, name), 'utf8').catch(() => null);
    if (text === null) return t.note('not in the folder');
    const demo = await openTrain(t);
    await demo.drop(name, text);
    await t.until('the file is open', async () =>
      (await demo.by('corpus-name').textContent()) === name, 120);
    const start = Date.now();
    await demo.part('run');
    await demo.press('train');
    await t.until('it has trained', async () =>
      /trained here/.test(await demo.by('trained').textContent().catch(() => '')), 600);
    t.note(`15 epochs: ${((Date.now() - start) / 1000).toFixed(1)} s by the clock`);
    await demo.talk();
    const taken = [];
    for (const command of ['go to the blue room', 'move next to the red chair', 'put the chair in the red room',
      'walk into the biggest room', 'stand to the left of the chair']) {
      const asked = Date.now();
      await demo.ask(command);
      taken.push(Date.now() - asked);
    }
    t.note(`commands answered after ${taken.join(', ')} ms, planning and the driver's own time included`);
  });
}
