// The requester's side: a study is drawn in the page, answers are reviewed, and the whole loop runs once with participants
// that are simulated in the real page: people who say what the crowd said, and careless ones who say what was rejected.

import { readFile } from 'node:fs/promises';
import { answersOf, crowd, host, makeStudy, Participant, receiver, takePart } from '../collect.mjs';
import { flow } from '../flow.mjs';
import { Demo, openTrain } from '../page.mjs';

/** How many take part. */
const PEOPLE = 12;

const study = 'task to-bag\nsays Go to the bag.\ngoal (near:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> bag:<e,t>))\nthing any bag\n';

/** What a study's notice says, once it says something like this. */
const told = (t, demo, pattern) => t.until(`${pattern} is said`, async () =>
  (await demo.by('study-notice').count()) > 0 && pattern.test(await demo.by('study-notice').textContent()));

flow('a study is drawn in the page, saved, and opened by who takes part', async (t) => {
  const demo = await openTrain(t);
  await demo.part('study');
  for (const place of [0, 1, 2]) await demo.page.locator('summary').nth(place).click();
  await demo.by('study-welcome').fill('Good day, and thank you for coming.');
  await demo.by('study-order').selectOption({ label: 'as they stand in the file' });
  await demo.by('study-tasks').fill(study);
  await demo.by('study-name').fill('Bags');
  await demo.by('study-pairs').fill('4');
  // Something else draws the page anew while the number is typed; it stays what it is.
  await demo.by('study-pairs').evaluate(() => document.querySelector('[data-testid="study-welcome"]')
    .dispatchEvent(new InputEvent('input', { bubbles: true })));
  await t.equal(() => demo.by('study-pairs').inputValue(), '4', 'what is typed');
  await demo.by('check-0').selectOption({ label: 'to-bag' });
  await demo.by('must-0').fill('bag/sack');
  await demo.by('check-1').waitFor();
  await demo.press('study-make');
  await told(t, demo, /has 1 tasks/);
  await t.accessible('a study in the workbench');
  const file = await demo.saved('study-save');
  const { name, items, order } = JSON.parse(file);
  await t.equal([name, items.length, items[0].shows.length, order], ['Bags', 1, 4, 'fixed'], 'the file');
  await t.equal(items[0].must, [['bag', 'sack']], 'the check');
  const preview = await demo.by('study-preview').getAttribute('href');
  const seen = new Participant(t, await t.open(`${t.address}${preview}`));
  await seen.by('mark').waitFor();
  await t.check(async () => /Good day, and thank you/.test(await seen.page.locator('.collect').textContent()), 'the words of the study');
  await seen.begin();
  await host(t, file);
  const person = await takePart(t);
  await person.begin();
  await t.equal(() => person.by('showing').count(), 3, 'three of four pairs');
  await demo.by('study-ways').check();
  await demo.press('study-make');
  await t.until('it is drawn anew', async () => JSON.parse(await demo.saved('study-save')).items[0].shows.every((shown) => shown.actions));
});

for (const width of [320, 390, 1440, 1920]) {
  for (const colorScheme of ['light', 'dark']) {
    flow(`studies in the workbench fit, ${width} pixels and ${colorScheme}`, { viewport: { width, height: 900 }, colorScheme }, async (t) => {
      const demo = await openTrain(t);
      await demo.part('study');
      const all = await demo.page.locator('#workbench summary').count();
      for (let place = 0; place < all; place += 1) await demo.page.locator('#workbench summary').nth(place).click();
      await demo.by('check-0').selectOption({ index: 1 });
      await demo.by('must-0').fill('red/crimson room');
      await t.fits('studies');
      await t.accessible('studies');
      await t.shot(`studies-${width}-${colorScheme}`);
    });
  }
}

flow(`${PEOPLE} simulated participants, and what a reviewer makes of them`, async (t) => {
  t.expect(/another host is asked/);
  const there = await receiver();
  try {
    const { said } = await crowd(12);
    const made = await makeStudy(t, { asked: 3, hosts: [there.address], ends: [{ endpoint: { url: `${there.address}/in`, key: 'k' } }] }, ['--from', said, '--rehearsed']);
    await host(t, made);
    for (let seed = 0; seed < PEOPLE; seed += 1) {
      const person = await takePart(t, `?study=study.json&simulate=${seed}`);
      await person.by('mark').waitFor();
      await person.at('over');
      await person.page.close();
    }
    await t.equal(there.posts.length, PEOPLE, 'posts');
    const posts = there.posts.map(({ body }) => body);
    const answers = posts.flatMap((body) => JSON.parse(body).answers);
    await t.equal(answers.length, 3 * PEOPLE, 'answers');
    const careless = answers.filter(({ simulated }) => simulated).length;
    await t.check(answers.every(({ simulated, care }) => simulated !== undefined && care.active_ms >= 4000), 'they are marked');
    const demo = new Demo(t, await t.open(`${t.address}#train`));
    t.page = demo.page;
    await demo.by('row').first().waitFor();
    await demo.part('study');
    await demo.by('study-file').setInputFiles({ name: 'study.json', mimeType: 'application/json', buffer: Buffer.from(made) });
    // In any order, and one of them twice.
    await demo.by('answers-file').setInputFiles([...posts.reverse(), posts[0]].map((body, at) => (
      { name: `${at}.json`, mimeType: 'application/json', buffer: Buffer.from(body) })));
    await t.check(async () => new RegExp(`^${3 * PEOPLE} answers: ${3 * PEOPLE} open.*3 came again`).test(await demo.by('answer-counts').textContent()), 'merged');
    const model = await readFile('assets/model/cleanup.model');
    await demo.by('judge-file').setInputFiles({ name: 'a.model', mimeType: 'text/plain', buffer: model });
    await told(t, demo, new RegExp(`has read ${3 * PEOPLE} answers`));
    await t.accessible('answers under review');
    await t.shot('collect-review');
    await demo.by('look').first().click();
    await t.equal(() => demo.by('answer-pairs').locator('.picture').count(), 6, 'its pairs');
    await demo.by('why').fill('=not what was asked');
    await demo.by('reject').first().click();
    await demo.press('decide');
    await t.check(async () => /0 open/.test(await demo.by('answer-counts').textContent()), 'all is decided');
    const table = await demo.saved('save-table');
    await t.check(table.includes('"\'=not what was asked"'), 'no formula');
    const lines = answersOf(await demo.saved('save-lines'));
    await t.equal(lines.filter(({ Reject }) => Reject === '=not what was asked').length, 1, 'the reason');
    await demo.press('train-on-answers');
    await t.check(async () => (await demo.by('tab-data').getAttribute('aria-selected')) === 'true', 'into training');
    await t.until('the answers are the corpus', async () => /study-answers/.test(await demo.page.locator('main').textContent()));
    await demo.train();
    t.note(`${PEOPLE} participants, ${answers.length} answers, ${careless} of them careless`);
  } finally {
    await there.close();
  }
});
