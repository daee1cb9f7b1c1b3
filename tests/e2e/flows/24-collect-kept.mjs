// No answer is lost or doubled: reload, another tab, no network, no room, a clock that jumps, back, a page that is killed;
// and who withdraws leaves nothing.

import { mkdtemp } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { answersOf, host, makeStudy, Participant, receiver, startBrowser, takePart } from '../collect.mjs';
import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

const LINK = '?study=study.json&participant=anna';

flow('whoever comes back goes on where they were', async (t) => {
  await host(t, await makeStudy(t, { asked: 3 }));
  const person = await takePart(t, LINK);
  await person.begin();
  const first = await person.page.locator('.picture').first().getAttribute('aria-label');
  await person.page.reload();
  await person.at('turn');
  await t.equal(() => person.page.locator('.picture').first().getAttribute('aria-label'), first, 'the same is shown');
  await person.answer('one');
  const before = await person.notes();
  await person.by('command').fill('half of tw');
  await t.until('what was typed is kept', async () => (await person.notes()) > before);
  await person.page.reload();
  await person.at('turn');
  await t.equal(() => person.turn(), 'Task 2 of 3', 'the turn');
  await t.equal(() => person.by('command').inputValue(), 'half of tw', 'what stood in the box');
  await person.answer('two');
  // Away and back.
  await person.page.goto('about:blank');
  await person.page.goBack();
  await person.at('turn');
  await t.equal(() => person.turn(), 'Task 3 of 3', 'the third turn');
  // A clock that was set back by years.
  await person.page.evaluate(() => { Date.now = () => 1000; });
  await person.answer('three');
  const answers = answersOf(await person.saved('end'));
  await t.equal(answers.map(({ command }) => command), ['one', 'two', 'three'], 'each once');
  await t.check(answers.every(({ care }) => care.active_ms < 120_000), 'time is not the clock’s');
});

flow('a browser that is killed right after an answer has it', async (t) => {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  const study = await makeStudy(t, { asked: 3 });
  const come = async () => {
    const browser = await startBrowser(folder);
    await browser.context.route('**/study.json', (route) => route.fulfill({ contentType: 'application/json', body: study }));
    const page = await browser.context.newPage();
    await page.goto(`${t.address}collect.html${LINK}`);
    return { ...browser, person: new Participant(t, page) };
  };
  let { person, kill } = await come();
  try {
    await person.begin();
    for (const [at, words] of ['one', 'two'].entries()) {
      await person.answer(words);
      await kill();
      ({ person, kill } = await come());
      await person.at('turn');
      await t.equal(() => person.turn(), `Task ${at + 2} of 3`, 'the answer is there');
    }
    await person.answer('three');
    const answers = answersOf(await person.saved('end'));
    await t.equal(answers.map(({ command }) => command), ['one', 'two', 'three'], 'each once');
  } finally {
    await kill();
  }
});

flow('one tab has the sitting, and another can take it', async (t) => {
  await host(t, await makeStudy(t, { asked: 3 }));
  const one = await takePart(t, LINK);
  await one.begin();
  await one.answer('one');
  const other = await takePart(t, LINK);
  await other.at('elsewhere');
  await t.accessible('elsewhere');
  await other.press('take');
  await other.at('turn');
  await t.equal(() => other.turn(), 'Task 2 of 3', 'it goes on behind the first');
  await one.at('elsewhere');
  await other.answer('two');
  await one.press('take');
  await one.at('turn');
  await t.equal(() => one.turn(), 'Task 3 of 3', 'and back');
  await one.answer('three');
  const answers = answersOf(await one.saved('end'));
  await t.equal(answers.map(({ command }) => command), ['one', 'two', 'three'], 'each once');
});

flow('without a network what was answered waits, is shown, and is sent once', async (t) => {
  t.expect(/another host|ERR_|503|net::/);
  const there = await receiver();
  try {
    await host(t, await makeStudy(t, { asked: 2, hosts: [there.address], ends: [{ endpoint: { url: `${there.address}/in`, key: 'secret' } }, 'code'] }));
    const person = await takePart(t, LINK);
    await t.check(async () => (await person.by('hosts').textContent()).includes(there.address.slice(7)), 'the host is named before consent');
    await person.begin();
    there.status = 503;
    await person.answer('one');
    await person.answer('two');
    await person.by('outbox').waitFor();
    await t.check(async () => /not sent yet \(503/.test(await person.by('outbox').textContent()), 'why');
    await t.accessible('an outbox');
    await person.page.reload();
    await person.by('outbox').waitFor();
    await t.equal(there.posts.length, 0, 'nothing arrived');
    await t.context.setOffline(true);
    await person.press('again');
    await person.by('outbox').waitFor();
    there.status = 200;
    await t.context.setOffline(false);
    await person.by('code').waitFor();
    await t.equal(there.posts.length, 1, 'it arrived once');
    const post = JSON.parse(there.posts[0].body);
    await t.equal([post.key, post.answers.map(({ command }) => command), post.code], ['secret', ['one', 'two'], await person.by('code').textContent()], 'what arrived');
  } finally {
    await there.close();
  }
});

flow('where nothing can be kept the person is told, and can go on', async (t) => {
  await t.context.addInitScript(() => {
    IDBObjectStore.prototype.add = function add() {
      this.transaction.abort();
      throw new DOMException('full', 'QuotaExceededError');
    };
  });
  await host(t, await makeStudy(t, { asked: 2 }));
  const person = await takePart(t, LINK);
  await person.at('welcome');
  await person.press('agree');
  await person.at('instructions');
  await t.check(async () => /no room/.test(await person.by('fault').textContent()), 'why');
  await person.press('ready');
  for (const words of ['one', 'two']) {
    await person.at('turn');
    await person.by('command').fill(words);
    await person.press('next');
    await t.until('it goes on', async () => (await person.page.locator('#command').count()) === 0 || (await person.by('command').inputValue()) === '');
  }
  const answers = answersOf(await person.saved('end'));
  await t.equal(answers.map(({ command }) => command), ['one', 'two'], 'nothing is lost');
});

flow('who withdraws leaves nothing; who may not come back is told', async (t) => {
  await host(t, await makeStudy(t, { asked: 2, again: 'refuse' }));
  const person = await takePart(t, LINK);
  await person.begin();
  await person.answer('one');
  await person.press('withdraw');
  await person.press('withdraw-no');
  await person.press('withdraw');
  await person.press('withdraw-yes');
  await person.by('withdrawn').waitFor();
  await t.accessible('withdrawn');
  await person.page.reload();
  await person.begin();
  await person.page.reload();
  await person.at('refused');
});

flow('the page that asks comes back without a network', { serviceWorkers: 'allow' }, async (t) => {
  t.expect(/ERR_INTERNET_DISCONNECTED|ERR_FAILED/);
  const study = JSON.parse(await makeStudy(t, { asked: 2 }));
  study.items = study.items.slice(0, 2);
  const person = await takePart(t, `?participant=a#study=${deflateRawSync(JSON.stringify(study)).toString('base64url')}`);
  await person.begin();
  await person.answer('one');
  await person.page.evaluate(() => navigator.serviceWorker.ready);
  await t.context.setOffline(true);
  await person.page.reload();
  await person.at('turn');
  await t.equal(() => person.turn(), 'Task 2 of 2', 'it goes on');
});

flow('what somebody answered is listed with all that is kept, saved and deleted', async (t) => {
  await host(t, await makeStudy(t, { asked: 2 }));
  const person = await takePart(t, LINK);
  await person.begin();
  await person.answer('one');
  const demo = await openPage(t);
  await demo.press('view-kept');
  const row = demo.by('kept-item').filter({ hasText: 'What you answered in a study' });
  await row.waitFor();
  const notes = await demo.saved('export');
  await t.check(() => notes.includes('"text":"one"'), 'the notes are saved');
  await row.getByTestId('delete').click();
  await demo.by('nothing-kept').waitFor();
  await person.page.reload();
  await person.at('welcome');
});
