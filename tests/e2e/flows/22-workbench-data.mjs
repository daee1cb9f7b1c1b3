// The corpus on the workbench: many rows are looked through quickly, columns mapped by hand, rows decided of and parted;
// all of it can be undone, and is written back into the file's form.

import { gzipSync } from 'node:zlib';
import { flow } from '../flow.mjs';
import { csv, openTrain, rows, six } from '../page.mjs';

/** A room with a robot in it, as JSON. */
const room = (x) => JSON.stringify({
  agent: { x, y: 1, direction: 'south' },
  rooms: [
    { name: 'room0', color: 'green', left: 0, bottom: 0, right: 3, top: 3 },
    { name: 'room1', color: 'red', left: 3, bottom: 0, right: 6, top: 3 },
  ],
  doors: [{ name: 'door0', left: 3, bottom: 1, right: 3, top: 1, lock: 'unlocked' }],
  objects: [],
});

/** A row of JSON lines. */
const said = (command, task, worker) =>
  `{"command":${JSON.stringify(command)},"task":"${task}","worker":"${worker}","pairs":[{"pre":${room(1)},"post":${room(4)}}]}\n`;

/** The six under column names of one's own. */
const ODD = six.replace('"Answer.command"', '"what was said"').replaceAll('Input.pre_', 'first ').replaceAll('Input.post_', 'then ')
  .replace('"Input.task"', '"kind"');

flow('twenty thousand rows are looked through, and few are in the page', async (t) => {
  const demo = await openTrain(t);
  const head = said('walk over to the red room please', 'rare', 'w2');
  await demo.dropAll([['many.jsonl', head, said('go to the red room', 'usual', 'w1'), 20_000]]);
  await t.until('the file is open', async () => (await demo.by('corpus-name').textContent()) === 'many.jsonl');
  await t.check(async () => /20001 rows/.test(await demo.by('rows-seen').textContent()), 'all rows are seen');
  await t.check(async () => (await demo.by('row').count()) < 80, 'few rows are in the page');
  const grid = demo.by('rows');
  const last = () => demo.page.locator('#row-20000');
  await t.until('the last row is shown', async () => {
    await grid.evaluate((it) => { it.scrollTop = it.scrollHeight; });
    return last().isVisible();
  });
  await t.check(async () => (await demo.by('row').count()) < 80, 'few rows are in the page at the end');
  await grid.focus();
  await demo.page.keyboard.press('Home');
  await demo.page.locator('#row-0').waitFor();
  await demo.page.keyboard.press('End');
  await last().waitFor();
  const start = Date.now();
  await demo.by('search').fill('please');
  await t.check(async () => /1 of 20001/.test(await demo.by('rows-seen').textContent()), 'the one row is found');
  t.note(`a search through 20,001 rows: ${Date.now() - start} ms`);
  await demo.press('show-all');
  await demo.by('filter-task').selectOption({ label: 'rare (1)' });
  await t.check(async () => /1 of 20001/.test(await demo.by('rows-seen').textContent()), 'the one row of its task');
  await t.accessible('many rows');
  await t.shot('bench-many');
});

flow('a packed file is read, and one that is cut off is refused', async (t) => {
  const demo = await openTrain(t);
  const packed = Buffer.concat([gzipSync(csv(rows[1], rows[2])), gzipSync(`${rows[3]}\n`)]);
  await demo.choose('three.csv.gz', packed);
  await t.equal(() => demo.corpus(), { name: 'three.csv.gz', rows: 3 }, 'all members are read');
  await demo.choose('cut.csv.gz', packed.subarray(0, packed.length - 40));
  await demo.by('file-notice').waitFor();
  t.note(await demo.by('file-notice').textContent());
  await t.equal(() => demo.corpus(), { name: 'three.csv.gz', rows: 3 }, 'what stays open');
});

flow('columns are mapped by hand, and the mapping holds for the next file', async (t) => {
  const demo = await openTrain(t);
  await demo.choose('odd.csv', ODD);
  await demo.by('file-notice').waitFor();
  await demo.press('map');
  await demo.by('mapping').waitFor();
  await t.accessible('columns that are mapped');
  await t.shot('bench-mapping');
  const columns = demo.by('mapping').getByRole('combobox');
  const choose = async (column, as) => {
    await demo.by('mapping').getByRole('combobox', { name: `${column} is`, exact: true }).selectOption({ label: as });
  };
  await t.check(async () => (await columns.count()) > 10, 'every column can be mapped');
  await choose('what was said', 'command');
  for (const n of [1, 2, 3]) {
    await choose(`first ${n}`, `before, ${n}`);
    await choose(`then ${n}`, `after, ${n}`);
  }
  const mapping = await demo.saved('map-save');
  await t.equal(JSON.parse(mapping).columns.command, 'what was said', 'the mapping that is saved');
  await demo.press('map-use');
  await t.equal(() => demo.corpus(), { name: 'odd.csv', rows: 6 }, 'what is open');
  await demo.press('open-demo');
  await t.equal(() => demo.corpus(), { name: 'six.csv', rows: 6 }, 'the six');
  await demo.dropAll([['again.csv', ODD], ['mapping.json', mapping]]);
  await t.equal(() => demo.corpus(), { name: 'again.csv', rows: 6 }, 'dropped with its mapping');
});

flow('rows are decided of, parted, and all of it is undone and saved', async (t) => {
  const demo = await openTrain(t);
  const line = (n) => demo.page.locator(`#row-${n}`);
  const count = () => demo.by('corpus-count').textContent();
  await line(1).getByRole('checkbox').check();
  await demo.by('rows').focus();
  await demo.page.keyboard.press('ArrowDown');
  await demo.page.keyboard.press('ArrowDown');
  await demo.page.keyboard.press('Space');
  await t.check(async () => /2 picked/.test(await demo.by('with-rows').textContent()), 'two rows are picked');
  await demo.by('reason').fill('too vague');
  await demo.press('reject');
  await t.check(async () => /2 rejected/.test(await count()), 'they are rejected');
  await demo.says(/2 rows rejected/);
  await demo.press('pick-none');
  const saved = await demo.saved('save-corpus');
  await t.equal(saved.match(/too vague/g)?.length, 2, 'the reason is written back');
  await demo.press('undo-care');
  await t.check(async () => !/rejected/.test(await count()), 'undone');
  await demo.press('redo-care');
  await t.check(async () => /2 rejected/.test(await count()), 'done again');
  await demo.by('split-percent').fill('50');
  await demo.by('split-percent').blur();
  await demo.press('split-share');
  await t.check(async () => /held out/.test(await count()), 'a share is held out');
  await demo.press('undo-care');
  await demo.by('filter-task').selectOption({ index: 1 });
  await demo.press('split-view');
  await t.check(async () => /, 1 held out/.test(await count()), 'a task is held out, but for what is rejected');
  await demo.press('show-all');
  await demo.press('find');
  await line(0).locator('.said').click();
  await demo.by('open-row').waitFor();
  await t.equal(() => demo.by('pairs').locator('svg.picture').count(), 6, 'pictures of three demonstrations');
  await t.accessible('an open row');
  await t.shot('bench-row');
  await demo.choose('saved.csv', saved);
  await t.check(async () => /2 rejected/.test(await count()), 'what was saved is read with its decisions');
});

flow('the robot\'s model is asked about every row', async (t) => {
  const demo = await openTrain(t);
  await demo.press('audit');
  await demo.says(/Every row is judged/);
  await demo.by('filter-outcome').waitFor();
  await demo.page.locator('#row-0 .said').click();
  await demo.by('row-readings').waitFor();
  await t.check(async () => (await demo.by('row-readings').getByRole('img').count()) >= 3, 'each demonstration is judged');
  await t.accessible('judged rows');
  await t.fits('judged rows');
  await t.shot('bench-judged');
});

flow('the bad rows are a file that is mended and dropped again', async (t) => {
  const demo = await openTrain(t);
  // The state before is cut off, in a row between two good ones.
  const broken = rows[2].replace(/"{""agent""/, '"{""agen');
  await demo.choose('mine.csv', csv(rows[1], broken, rows[3]));
  await t.check(async () => /1 bad row left out/.test(await demo.by('corpus-count').textContent()), 'a row is left out');
  await t.check(async () => /line 3[^]*Input\.pre_1/i.test(await demo.by('problems').textContent()), 'with line and column');
  const bad = await demo.saved('save-bad-rows');
  await t.equal(bad.trimEnd().split(/\r?\n/).length, 2, 'the header and the bad row');
  const mended = bad.replace('"{""agen', '"{""agent""');
  await demo.dropAll([['mine.csv', csv(rows[1], broken, rows[3])], ['mended.csv', mended]]);
  await t.equal(() => demo.corpus(), { name: 'mine.csv, mended.csv', rows: 3 }, 'the good rows and the one that was mended');
});

flow('rows are told apart by worker, status, part and what the model makes of them', async (t) => {
  const demo = await openTrain(t);
  await demo.choose('people.jsonl', said('go to the red room', 'red', 'ann') + said('go to the green room', 'red', 'ben')
    + said('flumph', 'odd', 'ben'));
  await t.until('the file is open', async () => (await demo.corpus()).name === 'people.jsonl');
  const seen = (count) => t.check(async () => new RegExp(`${count} of 3`).test(await demo.by('rows-seen').textContent()),
    async () => `${count} of 3: ${await demo.by('rows-seen').textContent()}`);
  const choose = (filter, label) => demo.by(filter).selectOption({ label });
  await choose('filter-worker', 'ben (2)');
  await seen(2);
  await demo.press('show-all');
  await demo.page.locator('#row-1').getByRole('checkbox').check();
  await demo.press('reject');
  await choose('filter-status', 'rejected (1)');
  await seen(1);
  await demo.press('show-all');
  await demo.press('pick-none');
  await demo.press('audit');
  await demo.says(/Every row is judged/);
  await demo.by('filter-outcome').selectOption({ index: 1 });
  await seen(1);
  await demo.press('show-all');
  await demo.press('sort-command');
  await t.check(async () => /flumph/.test(await demo.by('row').first().textContent()), 'sorted by command');
  await t.accessible('rows that are told apart');
});
