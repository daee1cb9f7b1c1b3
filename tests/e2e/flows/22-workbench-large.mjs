// Files that are large, and files that are damaged in every way: all told in words within seconds, the page alive.

import zlib from 'node:zlib';
import { flow } from '../flow.mjs';
import { csv, openTrain, rows } from '../page.mjs';
import { engineMemory, mainThreads, trace } from '../trace.mjs';

/** A row of JSON lines with one short pair. */
const SHORT = (() => {
  const state = (x) => ({
    agent: { x, y: 1, direction: 'west' },
    rooms: [{ name: 'room0', color: 'red', left: 0, bottom: 0, right: 4, top: 4 }],
    doors: [],
    objects: [],
  });
  return `${JSON.stringify({ command: 'go to the red room', pairs: [{ pre: state(1), post: state(2) }] })}\n`;
})();

/** Most seconds until a damaged file is told; generous to a busy machine. */
const SECONDS = 20;

/** Whether the page still answers: a search is answered. */
async function isAlive(demo) {
  await demo.part('data');
  await demo.by('search').fill('room');
  await demo.t.check(async () => /\d/.test(await demo.by('corpus-count').textContent()), 'the page is alive');
  await demo.by('search').fill('');
}

flow('a hundred thousand rows are opened, looked through and searched', async (t) => {
  const demo = await openTrain(t);
  const carried = await demo.carried([['large.jsonl', SHORT, SHORT, 99_999]]);
  const start = Date.now();
  const events = await trace(demo.page, async () => {
    await demo.let(carried);
    await t.until('it is open', async () => (await demo.by('corpus-name').textContent()) === 'large.jsonl', 90);
  });
  t.note(`open after ${((Date.now() - start) / 1000).toFixed(1)} s by the clock`);
  const [{ tasks }] = mainThreads(events);
  const longest = tasks.reduce((a, b) => (a.cpu > b.cpu ? a : b));
  t.note(`the page's longest task: ${longest.cpu.toFixed(1)} ms of CPU`);
  await t.check(async () => /100,?000/.test(await demo.by('corpus-count').textContent()), async () => demo.by('corpus-count').textContent());
  await t.check(async () => (await demo.by('row').count()) > 10, 'its rows are drawn');
  await demo.by('rows').focus();
  await demo.page.keyboard.press('End');
  await demo.page.locator('#row-99999').waitFor();
  await t.check(async () => (await demo.by('row').count()) < 80, 'only what is in sight is drawn');
  const memory = await engineMemory(demo.page, t.address);
  t.note(`the engine holds ${memory.toFixed(0)} MB`);
  await t.check(memory > 0 && memory < 500, 'its memory');
  await isAlive(demo);
});

flow('every kind of damage is told within seconds', async (t) => {
  const demo = await openTrain(t);
  const good = csv(...rows.slice(1, 4));
  const long = 50_000_000;
  const files = [
    ['cut off', Buffer.from(good.slice(0, good.length - 60)), /line 4/],
    ['UTF-16 that is cut in the middle of a letter', Buffer.from(`\ufeff${good}`, 'utf16le').subarray(0, 5_001), /./],
    ['bytes that are no letters', Buffer.concat([Buffer.from(rows[0]), Buffer.from([0x0a, 0xff, 0xfe, 0x00, 0x80])]), /text/],
    ['quotes that are broken', Buffer.from(good.replace('{""agent""', '{"agent"')), /line 2/],
    ['JSON that is broken', Buffer.from(good.replace('""rooms"":[', '""rooms"":[[')), /line 2[^]*Input\.pre_1/],
    ['a small file that unpacks to 300 MB', zlib.gzipSync(Buffer.alloc(300_000_000, 'x')), /64|larger|unpack/i],
    ['a packed file that is cut off', zlib.gzipSync(good).subarray(0, 900), /./],
  ];
  const told = async (name, what, pattern) => {
    const start = Date.now();
    const words = async () => (await Promise.all(['file-notice', 'problems'].map((id) =>
      demo.by(id).first().textContent({ timeout: 100 }).catch(() => '')))).join(' ');
    await t.until(`${what} is told`, async () => {
      const said = await words();
      return said.trim() !== '' && pattern.test(said)
        && (said.includes(name) || (await demo.by('corpus-name').textContent()) === name);
    }, SECONDS);
    t.note(`${what}: told after ${((Date.now() - start) / 1000).toFixed(1)} s`);
    await isAlive(demo);
  };
  for (const [at, [what, bytes, pattern]] of files.entries()) {
    const name = `file-${at}.csv`;
    await demo.choose(name, bytes);
    await told(name, what, pattern);
  }
  await demo.dropAll([['cell.csv', `${good}"${'x'.repeat(100)}`, 'x'.repeat(1_000_000), long / 1_000_000]]);
  await told('cell.csv', 'a cell of 50 MB', /./);
});
