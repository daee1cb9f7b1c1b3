// The driver itself: that it sees what goes wrong in a page. A flow of a broken page must collect each problem.

import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { compare } from '../golden.mjs';
import { flow } from '../flow.mjs';
import { PNG } from '../packages.mjs';
import { serve } from '../server.mjs';

const BROKEN = `<!doctype html><html lang="en"><title>Broken</title>
<meta http-equiv="Content-Security-Policy" content="default-src 'self'">
<h1 style="color: red">Broken</h1><img src="missing.png" alt=""><img src="http://127.0.0.2:9/a.png" alt="">
<script src="broken.js"></script>`;
const SCRIPT = `console.error('said aloud'); setTimeout(() => { throw new Error('thrown away'); });`;

flow('the driver sees every kind of trouble', async (t) => {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  await writeFile(path.join(folder, 'index.html'), BROKEN);
  await writeFile(path.join(folder, 'broken.js'), SCRIPT);
  const site = await serve(folder, { under: '/below/' });
  try {
    await t.open(site.address);
    const kinds = [/content policy: style-src/, /status 404/, /another host/, /said aloud/, /thrown away/];
    await t.until('each kind of trouble', () =>
      kinds.every((kind) => t.problems.some((problem) => kind.test(problem))));
    t.expect(/./);
    await t.equal(t.unexpected(), [], 'expected trouble passes');
    const outside = await t.page.request.get(new URL('/index.html', site.address).href);
    await t.equal(outside.status(), 404, 'nothing is served beside the sub-path');
    const escaped = await t.page.request.get(`${site.address}%2e%2e%2f%2e%2e%2fetc/passwd`);
    await t.equal(escaped.status(), 404, 'nothing is served from outside the folder');
  } finally {
    await site.close();
    await rm(folder, { recursive: true });
  }
});

flow('pictures that differ are told apart', async (t) => {
  const picture = (side) => {
    const png = new PNG({ width: 20, height: 20 });
    png.data.fill(255);
    for (let i = 0; i < side; i += 1) png.data.fill(0, i * 80, i * 80 + 4 * side - 1);
    return PNG.sync.write(png);
  };
  await t.equal(compare(picture(5), picture(5)).wrong, null, 'the same picture');
  await t.check(compare(picture(5), picture(9)).wrong, 'another picture passed');
  await t.equal(compare(picture(5), picture(9), { share: 0.5 }).wrong, null, 'within the tolerance');
});
