// What people bring: files of other programs, several at once, one that never ends its first line. Each is read as the
// command line reads it, or refused in words at once.

import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { csv, openTrain, rows } from '../page.mjs';

/** A row of the six with these words for its command. */
const saying = (row, words) => row.replace(/"[^"]*"(?=,[^,]*,[^,]*$)/, `"${words}"`);

/** Three good rows whose Reject says NA, as R writes it. */
const NA = csv(...rows.slice(1, 4).map((row) => row.replace(/,[^,]*$/, ',NA')));

/** Three rows of which the second says its command in Latin-1. */
const LATIN = Buffer.concat([
  Buffer.from(csv(rows[1])), Buffer.from(saying(rows[2], 'go to the caf\u00e9'), 'latin1'), Buffer.from(`\n${rows[3]}\n`),
]);

/** Three rows, all rejected. */
const REJECTED = csv(...rows.slice(1, 4).map((row) => row.replace(/,[^,]*$/, ',"too vague"')));

/** The page's count of a file, and the command line's rows, rejected and left_out. */
async function both(t, demo, name, content) {
  await demo.choose(name, content);
  await t.until(`${name} is open`, async () => (await demo.corpus()).name === name);
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  try {
    const file = path.join(folder, name);
    await writeFile(file, content);
    const { stdout, stderr } = await t.groundling('train', '--corpus', file, '--epochs', '1', '--json',
      '--lexicon', 'assets/lexicon/demonstration.txt', '--out', path.join(folder, 'a.model'));
    const { rows: all, rejected, left_out: left, examples } = JSON.parse(stdout || '{}');
    await t.check(stdout, stderr);
    await t.equal(all, examples + rejected + left, 'the rows add up');
    return { examples, rejected, left };
  } finally {
    await rm(folder, { recursive: true });
  }
}

flow('files of other programs are read as the command line reads them', async (t) => {
  const demo = await openTrain(t);
  const count = () => demo.by('corpus-count').textContent();
  for (const [name, content, wanted, words] of [
    ['r.csv', NA, { examples: 3, rejected: 0, left: 0 }, /^3 commands\. /],
    ['latin.csv', LATIN, { examples: 2, rejected: 0, left: 1 }, /^2 commands, 1 bad row left out, 1 problem\b/],
    ['mark.csv', `\ufeff${csv(...rows.slice(1))}`, { examples: 6, rejected: 0, left: 0 }, /^6 commands\. /],
    ['twice.csv', csv(...rows.slice(1, 4)) + csv(...rows.slice(4)), { examples: 6, rejected: 0, left: 0 }, /^6 commands\. /],
    ['utf-16.txt', Buffer.from(`\ufeff${csv(...rows.slice(1))}`, 'utf16le'), { examples: 6, rejected: 0, left: 0 }, /^6 /],
  ]) {
    const found = await both(t, demo, name, content);
    await t.equal(found, wanted, name);
    await t.check(async () => words.test(await count()), async () => `${name}: ${await count()}`);
  }
});

flow('two files dropped at once are one corpus, and rejected rows are used when asked for', async (t) => {
  const demo = await openTrain(t);
  await demo.dropAll([['a.csv', csv(rows[1], rows[2])], ['b.csv', csv(rows[3])]]);
  await t.equal(() => demo.corpus(), { name: 'a.csv, b.csv', rows: 3 }, 'what is open');
  await demo.train();
  await demo.choose('rejected.csv', REJECTED);
  await t.equal(() => demo.corpus(), { name: 'rejected.csv', rows: 3 }, 'what is open then');
  await t.check(async () => /3 rejected/.test(await demo.by('corpus-count').textContent()), 'its rows are rejected');
  await t.accessible('a file of rejected rows');
  await demo.part('run');
  await t.check(() => demo.by('train').isDisabled(), 'there is nothing to learn from');
  await demo.part('data');
  await demo.press('use-rejected');
  await demo.part('run');
  await t.check(() => demo.by('train').isEnabled(), 'they are used when asked for');
});

flow('a line that does not end is refused in a second, and reading can be stopped', async (t) => {
  const demo = await openTrain(t);
  const start = Date.now();
  await demo.choose('wide.csv', Array.from({ length: 80_000 }, (_, n) => `0.${n}`).join(','));
  await demo.by('file-notice').waitFor();
  t.note(`80,000 columns are refused after ${Date.now() - start} ms`);
  await t.check(async () => /more than 16384 cells/.test(await demo.by('file-notice').textContent()), 'in words');
  await demo.part('run');
  await t.check(() => demo.by('train').isEnabled(), 'what is open can be trained on');
  // Pressed as soon as it is there: a quick machine reads the file before the driver has aimed.
  const pressed = demo.page.evaluate(() => new Promise((done) => {
    const watch = new MutationObserver(() => {
      const button = document.querySelector('[data-testid="stop-reading"]');
      if (!button) return;
      watch.disconnect();
      button.click();
      done();
    });
    watch.observe(document.body, { childList: true, subtree: true });
  }));
  await demo.dropAll([['long.csv', csv(), `${rows.slice(1).join('\n')}\n`, 1600]]);
  await pressed;
  await t.check(async () => /Reading was stopped/.test(await demo.by('file-notice').textContent()), 'it says so');
  await t.equal(() => demo.corpus(), { name: 'six.csv', rows: 6 }, 'what stays open');
  await demo.train();
});
