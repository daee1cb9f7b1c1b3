// Without a network, and without a server: after one visit the page opens, answers and learns as before.

import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { root } from '../packages.mjs';
import { openPage } from '../page.mjs';
import { serve } from '../server.mjs';

const built = process.env.SITE ?? path.join(root, 'target/site');

flow('the page works offline after one visit', { gpu: true, serviceWorkers: 'allow' }, async (t) => {
  const site = await serve(built, { under: '/below/' });
  const demo = await openPage(t, site.address);
  const stores = await demo.page.evaluate(async () => {
    await navigator.serviceWorker.ready;
    return caches.keys();
  });
  await t.equal(stores, [`groundling ${site.address}`], 'what is kept');
  // All that an engine wants has come to it: what it lacks when the network goes it can only say.
  await demo.ask('go to the red room');
  await demo.finish();
  await site.close();
  await t.context.setOffline(true);
  await demo.page.reload();
  await demo.ready();
  await demo.ask('go to the blue room');
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'where the robot ends');
  await demo.ask('go to the violet room');
  await t.equal(() => demo.why(), ['taken', 'already_true'], 'what is said of a shade');
  await t.until('the picture is drawn by the GPU', async () =>
    (await demo.by('stage').getAttribute('data-backend')) === 'webgl2');
  await demo.workbench();
  await demo.train();
});

flow('a new site takes the place of the one that was kept', { serviceWorkers: 'allow' }, async (t) => {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  await cp(built, folder, { recursive: true });
  const site = await serve(folder, { under: '/below/' });
  try {
    const demo = await openPage(t, site.address);
    const kept = (name) => demo.page.evaluate(async (file) => {
      await navigator.serviceWorker.ready;
      return await caches.match(new URL(file, document.baseURI)) !== undefined;
    }, name);
    await t.check(() => kept('icon.svg'), 'the first icon is kept');
    const index = path.join(folder, 'index.html');
    await cp(path.join(folder, 'icon.svg'), path.join(folder, 'icon-2.svg'));
    await writeFile(index, (await readFile(index, 'utf8')).replace(/icon\.svg/g, 'icon-2.svg'));
    await demo.page.reload();
    await t.until('the second icon is kept, and the first is not', async () =>
      await kept('icon-2.svg') && !await kept('icon.svg'));
    await t.check(() => kept('learner_bg.wasm'), 'and what is wanted later');
  } finally {
    await site.close();
    await rm(folder, { recursive: true });
  }
});
