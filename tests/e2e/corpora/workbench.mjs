// Every corpus of the folder on the workbench: dropped, learned to the end, and the model is the command line's, byte for
// byte. How long the page's own thread was busy at once is reported.

import { mkdtemp, readFile, readdir, rm } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { openTrain } from '../page.mjs';

const names = (await readdir(process.env.CORPORA)).filter((name) => name.endsWith('.csv'));

for (const name of names) {
  flow(`the workbench learns what the command line learns from ${name}`, async (t) => {
    const file = path.join(process.env.CORPORA, name);
    const demo = await openTrain(t);
    await demo.page.evaluate(() => {
      globalThis.long = [];
      new PerformanceObserver((list) => globalThis.long.push(...list.getEntries().map(({ duration }) => duration)))
        .observe({ type: 'longtask' });
    });
    await demo.drop(name, await readFile(file, 'utf8'));
    await t.until('the file is open', async () => (await demo.by('corpus-name').textContent()) === name, 60);
    await demo.part('run');
    await demo.by('setting-epochs').fill('2');
    await demo.by('setting-epochs').blur();
    const start = Date.now();
    await demo.press('train');
    await t.until('it has trained', async () => /trained here/.test(await demo.by('trained').textContent().catch(() => '')), 600);
    t.note(`2 passes: ${((Date.now() - start) / 1000).toFixed(1)} s by the clock`);
    const long = await demo.page.evaluate(() => globalThis.long);
    t.note(`tasks of more than 50 ms by the clock: ${long.length}, the longest ${Math.round(Math.max(0, ...long))} ms`);
    const there = await demo.model();
    const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
    try {
      const out = path.join(folder, 'a.model');
      const { status, stderr } = await t.groundling('train', '--corpus', file, '--epochs', '2', '--out', out);
      await t.equal(status, 0, stderr);
      await t.check((await readFile(out, 'utf8')) === there, 'the models are the same');
    } finally {
      await rm(folder, { recursive: true });
    }
  });
}
