// Taking part in a study: by mouse and by keyboard, in English and in German, from a file beside the page and from the
// link itself, with and without somewhere to send the answers.

import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { answersOf, host, makeStudy, takePart } from '../collect.mjs';
import { flow } from '../flow.mjs';
import { root } from '../packages.mjs';

flow('people take part in a study, and give their answers as a file', async (t) => {
  await host(t, await makeStudy(t, { ends: ['code', 'file'] }));
  const person = await takePart(t, '?study=study.json&PROLIFIC_PID=a=b%3D&SESSION_ID=s1');
  await person.at('welcome');
  await t.check(async () => /Nothing is sent/.test(await person.by('hosts').textContent()), 'where answers go is said');
  await t.accessible('consent');
  await person.press('agree');
  await person.at('instructions');
  await person.press('ready');
  await person.at('turn');
  await t.equal(() => person.turn(), 'Task 1 of 2', 'the first turn');
  await t.equal(() => person.by('showing').count(), 3, 'pairs');
  await t.equal(() => person.page.locator('.picture').count(), 6, 'pictures');
  await t.accessible('a turn');
  await t.fits('a turn');
  await t.check(() => person.by('next').isDisabled(), 'nothing to hand in yet');
  await person.press('change-2');
  await t.check(async () => /robot|block|chair|basket/.test(await person.page.locator('.changed').nth(1).textContent()), 'what changed is said');
  await t.shot('collect-turn');
  await person.answer('=go to the "red" room\nnow, \u202eplease');
  await t.equal(() => person.turn(), 'Task 2 of 2', 'the second turn');
  await person.by('command').fill('step');
  await person.page.keyboard.press('Enter');
  await person.at('end');
  const code = await person.by('code').textContent();
  await t.check(/^[0-9A-Z]{8}$/.test(code), 'a code of eight signs');
  await t.accessible('the code');
  await person.press('ended');
  const answers = answersOf(await person.saved('end'));
  await t.equal(answers.map(({ command, worker, assignment, turn }) => [command, worker, assignment, turn]), [
    ['=go to the "red" room\nnow, \u202eplease', 'a=b=', 's1', [1, 2]],
    ['step', 'a=b=', 's1', [2, 2]],
  ], 'the answers');
  await t.check(answers[0].care.keys > 0 && answers[0].care.changes === 1 && answers[0].pairs.length === 3, 'how carefully');
  await person.press('ended');
  await person.at('over');
  await t.equal(() => person.by('code').textContent(), code, 'the code stays');
  await person.page.reload();
  await person.at('over');
  await t.equal(() => person.by('code').textContent(), code, 'and is there again');
  const kept = await person.page.evaluate(async () => {
    const [{ name }] = await indexedDB.databases();
    const database = await new Promise((resolve) => { const r = indexedDB.open(name); r.onsuccess = () => resolve(r.result); });
    const request = database.transaction('notes').objectStore('notes').getAllKeys();
    return new Promise((resolve) => { request.onsuccess = () => resolve(request.result.map((key) => key.split('/')[0])); });
  });
  await t.equal(kept.sort(), ['me', 'over'], 'nothing else is kept');
});

flow('a study in German, by keyboard on a phone', { viewport: { width: 390, height: 780 }, locale: 'de-DE' }, async (t) => {
  await host(t, await makeStudy(t, { language: 'de', asked: 1 }));
  const person = await takePart(t);
  await person.at('welcome');
  await t.equal(() => person.page.evaluate(() => document.documentElement.lang), 'de', 'the language');
  await t.fits('consent');
  const reach = async (id) => {
    for (let n = 0; n < 40; n += 1) {
      if (await person.page.evaluate((wanted) => document.activeElement?.dataset.testid === wanted, id)) return;
      await person.page.keyboard.press('Tab');
    }
    throw new Error(`Tab never reaches ${id}`);
  };
  await reach('agree');
  await person.page.keyboard.press('Enter');
  await person.at('instructions');
  await t.fits('instructions');
  await reach('ready');
  await person.page.keyboard.press('Enter');
  await person.at('turn');
  await t.fits('a turn');
  await t.accessible('a turn in German');
  await t.shot('collect-turn-phone');
  await reach('change-1');
  await person.page.keyboard.press('Space');
  await reach('command');
  await person.page.keyboard.type('geh in den roten raum');
  await person.page.keyboard.press('Enter');
  await person.at('end');
  await t.check(async () => /Datei/.test(await person.by('end').textContent()), 'in German');
  await t.accessible('the end in German');
});

flow('a study inside its link is taken part in, and sends nothing', async (t) => {
  const study = JSON.parse(await makeStudy(t, { asked: 1, ends: ['file'] }));
  study.items = study.items.slice(0, 2);
  study.hosts = ['https://elsewhere.example'];
  study.ends = [{ endpoint: { url: 'https://elsewhere.example/in', key: 'k' } }];
  const packed = deflateRawSync(JSON.stringify(study)).toString('base64url');
  const person = await takePart(t, `#study=${packed}`);
  await person.at('welcome');
  await t.check(async () => /Nothing is sent/.test(await person.by('hosts').textContent()), 'it names no host');
  await person.press('agree');
  await person.press('ready');
  await person.at('turn');
  await person.answer('go');
  await person.at('end');
  await t.check(async () => /may send nothing/.test(await person.by('refusal').textContent()), 'why not');
  await t.equal(answersOf(await person.saved('save-answers')).length, 1, 'the file has the answer');
});

flow('a link without a study, or with a bad one, says so', async (t) => {
  t.expect(/404/);
  await host(t, '{"format":"groundling study"', 'broken.json');
  for (const [query, words] of [
    ['', /names no study/],
    ['?study=https%3A%2F%2Felsewhere.example%2Fa.json', /another site/],
    ['?study=nowhere.json', /could not be loaded \(404\)/],
    ['?study=broken.json', /cannot be used: .*JSON/],
    ['#study=AAAA', /cannot be used: it is damaged/],
  ]) {
    const person = await takePart(t, query);
    t.page = person.page;
    await person.at('trouble');
    await t.check(async () => words.test(await person.by('trouble').textContent()), () => person.by('trouble').textContent());
    await t.accessible('trouble');
    await person.page.close();
  }
});

flow('a preview records and sends nothing', async (t) => {
  await host(t, await makeStudy(t, { asked: 1, ends: ['code', 'file'] }));
  const person = await takePart(t, '?study=study.json&assignmentId=ASSIGNMENT_ID_NOT_AVAILABLE&hitId=h');
  await person.at('welcome');
  await t.check(async () => /preview/.test(await person.by('mark').textContent()), 'it says so');
  await person.begin();
  await person.by('command').fill('go');
  await person.press('next');
  await person.at('end');
  await person.press('end');
  await person.press('end');
  await person.at('over');
  await t.equal(() => person.page.evaluate(async () => (await indexedDB.databases()).length), 0, 'nothing is kept');
  await person.page.reload();
  await person.at('welcome');
});

flow('the page that asks runs no text as code', async (t) => {
  t.expect(/content policy|Content Security Policy|another host is asked|request failed: .*csp/i);
  await host(t, await makeStudy(t, { asked: 1 }));
  const person = await takePart(t);
  await person.at('welcome');
  const comes = await person.page.evaluate(async () => {
    const tried = async (attempt) => {
      try {
        await attempt();
        return 'done';
      } catch {
        return 'refused';
      }
    };
    // The driver lets its own words pass; what follows a wait is the page's.
    await new Promise((done) => { setTimeout(done, 10); });
    return {
      eval: await tried(() => (0, eval)('1')),
      plain: await tried(() => fetch('http://elsewhere.example/')),
      socket: await tried(() => new Promise((resolve, reject) => { const s = new WebSocket('wss://elsewhere.example/'); s.onopen = resolve; s.onerror = reject; })),
      frame: await tried(() => new Promise((resolve, reject) => { document.addEventListener('securitypolicyviolation', reject, { once: true }); const f = document.createElement('iframe'); f.src = 'https://elsewhere.example/'; document.body.append(f); setTimeout(resolve, 500); })),
    };
  });
  await t.equal(comes, { eval: 'refused', plain: 'refused', socket: 'refused', frame: 'refused' }, 'what comes of it');
});
