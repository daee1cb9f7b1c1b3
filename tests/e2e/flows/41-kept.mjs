// What is kept: after a reload, a closed tab or a crash the session is back; a link is opened beside it; whatever is
// wrong with the store is told apart in words; what is kept is listed, saved and deleted.

import path from 'node:path';
import { OUT, flow } from '../flow.mjs';
import { Demo, csv, openElsewhere, openPage, openTrain, rows } from '../page.mjs';

/** Waits until what was done last is kept: the text in the store holds these words. */
async function kept(demo, words) {
  await demo.t.until(`“${words}” is kept`, () => demo.page.evaluate(async (wanted) => {
    const name = (await indexedDB.databases()).map((one) => one.name).find((one) => one.startsWith('groundling'));
    if (!name) return false;
    const database = await new Promise((resolve) => {
      indexedDB.open(name).onsuccess = ({ target }) => resolve(target.result);
    });
    const texts = await new Promise((resolve) => {
      database.transaction('texts').objectStore('texts').getAll().onsuccess = ({ target }) => resolve(target.result);
    });
    database.close();
    return texts.some((text) => text.includes(wanted));
  }, words));
}

/** Loads the page anew and waits until it says where its session came from. */
async function reloaded(demo, origin) {
  await demo.page.reload();
  await demo.ready();
  await demo.t.until(`the session is ${origin}`, async () =>
    (await demo.by('resumed').count()) > 0 && (await demo.by('resumed').getAttribute('data-origin')) === origin);
}

flow('a reload brings the whole session back, and it can be begun afresh', async (t) => {
  const demo = await openPage(t);
  await t.equal(() => demo.by('resumed').count(), 0, 'nothing is said of a first visit');
  await demo.mode('teach');
  await demo.drag([6, 2], [2, 6]);
  await demo.by('lesson').fill('flump to the blue room');
  await demo.press('teach');
  await demo.by('learned').waitFor();
  await demo.ask('flump to the red room');
  await demo.finish();
  await demo.deepen('see');
  await demo.by('language').selectOption('de');
  const world = await demo.world();
  // Packed, the language is two letters and their number.
  await kept(demo, '\\u0002de');
  await reloaded(demo, 'Last');
  await t.until('the room is as it was', async () => (await demo.world()) === world);
  await t.equal(() => demo.by('command').inputValue(), 'flump to the red room', 'the command');
  await t.equal(() => demo.by('lesson-try').allTextContents(), ['flump to the blue room'], 'the lessons');
  await t.equal(() => demo.by('depth-see').getAttribute('aria-pressed'), 'true', 'the depth');
  await t.equal(() => demo.page.locator('html').getAttribute('lang'), 'de', 'the language');
  await t.equal(() => demo.by('again').allTextContents(), ['flump to the red room'], 'what was said');
  await t.accessible('a session that came back');
  await t.shot('kept-resumed-de');
  await demo.press('afresh');
  await t.until('nothing is taught', async () => (await demo.by('lesson-try').count()) === 0);
  await t.equal(() => demo.by('command').inputValue(), '', 'the box');
  await t.equal(async () => (await demo.robot()).room, 'green', 'the room is as it began');
  await demo.press('undo');
  await demo.by('lesson-try').waitFor();
});

flow('a model that was trained here comes back', async (t) => {
  const demo = await openTrain(t);
  await demo.choose('mine.csv', csv(...rows.slice(1, 4)));
  await t.until('the file is open', async () => (await demo.corpus()).name === 'mine.csv');
  await demo.train();
  const model = await demo.model();
  await kept(demo, 'mine.csv');
  await demo.page.reload();
  await demo.part('run');
  await t.check(async () => /trained here/.test(await demo.by('trained').textContent()), 'the model is back');
  await t.check(async () => (await demo.model()) === model, 'it is the same');
});

flow('a tab that was closed comes back in a new one, and two tabs do not keep the same', async (t) => {
  const first = await openPage(t);
  await first.ask('go to the blue room');
  await first.finish();
  await kept(first, '"command":"go to the blue room"');
  const second = new Demo(t, await t.open());
  await second.ready();
  await second.by('not-kept').waitFor();
  await t.equal(() => second.by('not-kept').getAttribute('data-fault'), 'elsewhere', 'the second tab');
  await second.press('keep-here');
  await t.until('the first tab is told', async () =>
    (await first.by('not-kept').count()) > 0 && (await first.by('not-kept').getAttribute('data-fault')) === 'elsewhere');
  await t.until('the second tab keeps it now', async () => (await second.by('not-kept').count()) === 0);
  await second.ask('go to the red room');
  await kept(second, '"command":"go to the red room"');
  await first.page.close();
  await second.page.close();
  const third = new Demo(t, await t.open());
  await third.ready();
  await third.by('resumed').waitFor();
  await t.until('what was said last', async () => (await third.by('command').inputValue()) === 'go to the red room');
});

flow('a page that dies comes back with what was said', async (t) => {
  t.expect(/crashed/);
  const demo = await openPage(t);
  await demo.ask('go to the blue room');
  await demo.finish();
  await kept(demo, '"command":"go to the blue room"');
  const died = demo.page.waitForEvent('crash');
  const session = await t.context.newCDPSession(demo.page);
  session.send('Page.crash').catch(() => {});
  await died;
  const again = new Demo(t, await t.open());
  await again.ready();
  await t.equal(() => again.by('resumed').getAttribute('data-origin'), 'Last', 'where it came from');
  await t.equal(() => again.by('command').inputValue(), 'go to the blue room', 'what was said');
  await t.equal(async () => (await again.robot()).room, 'blue', 'where the robot is');
});

flow('on a phone a saved file is opened, too', { viewport: { width: 390, height: 844 }, hasTouch: true }, async (t) => {
  const demo = await openPage(t);
  await demo.ask('go to the red room');
  await demo.finish();
  await demo.press('share');
  const file = await demo.saved('save-session');
  await demo.press('undo');
  await demo.by('view-kept').tap();
  await t.fits('what is kept on a phone');
  await demo.by('session-file').setInputFiles({ name: 'groundling.json', mimeType: 'application/json', buffer: Buffer.from(file) });
  await t.equal(() => demo.by('command').inputValue(), 'go to the red room', 'what it holds');
});

flow('a link is opened beside the session that is kept, and never over it', async (t) => {
  const link = await openElsewhere(t, t.address, async (other) => {
    await other.ask('walk next to the yellow block');
    return other.link();
  });

  const demo = await openPage(t);
  await demo.ask('go to the blue room');
  await kept(demo, '"command":"go to the blue room"');
  await demo.page.close();
  const guest = new Demo(t, await t.open(link));
  await guest.ready();
  await t.until('it is the link’s', async () =>
    (await guest.by('resumed').count()) > 0 && (await guest.by('resumed').getAttribute('data-origin')) === 'Link');
  await t.until('its command', async () => (await guest.by('command').inputValue()) === 'walk next to the yellow block');
  await guest.ask('enter the red room');
  await kept(guest, '"command":"enter the red room"');
  await guest.page.screenshot({ path: path.join(OUT, 'kept-link.png') });
  await reloaded(guest, 'Left');
  await t.until('as it was left', async () => (await guest.by('command').inputValue()) === 'enter the red room');
  await guest.press('go-back');
  await t.until('one’s own', async () => (await guest.by('command').inputValue()) === 'go to the blue room');
});

flow('a tab that takes a moment to close does not cost its session', async (t) => {
  const demo = await openPage(t);
  await demo.ask('go to the blue room');
  await kept(demo, '"command":"go to the blue room"');
  const names = await demo.page.evaluate(async () => (await navigator.locks.query()).held.map(({ name }) => name));
  await t.equal(names.length, 1, 'the session is claimed');
  await demo.page.close();
  // What the browser does of itself where the machine is busy: the lock is let go of after the next page has opened.
  const slow = await t.context.newPage();
  await slow.goto(`${t.address}help.en.html`);
  await slow.evaluate(([name]) => new Promise((held) => {
    navigator.locks.request(name, async () => {
      held();
      // Without a timer, which a page behind another has seldom.
      for (let waiting = 0; waiting === 0;) waiting = (await navigator.locks.query()).pending.length;
      globalThis.hasLetGo = true;
    });
  }), names);
  const again = new Demo(t, await t.open());
  await t.until('the session is there', async () => (await again.by('resumed').count()) > 0);
  await t.until('it is this tab’s', async () => {
    if (!await slow.evaluate(() => globalThis.hasLetGo === true)) return false;
    if (await again.by('not-kept').count() > 0) {
      // So busy a machine took longer than is waited for, and it is told: whoever loads the page anew has it.
      await again.page.reload();
      await again.ready();
    }
    const held = await again.page.evaluate(async () => (await navigator.locks.query()).held.length);
    return held === 1 && (await again.by('not-kept').count()) === 0;
  });
  await again.ask('go to the red room');
  await kept(again, '"command":"go to the red room"');
});

flow('a damaged copy gives way to the one before it', async (t) => {
  const demo = await openPage(t);
  await demo.ask('go to the blue room');
  await kept(demo, '"command":"go to the blue room"');
  await demo.ask('go to the red room');
  await kept(demo, '"command":"go to the red room"');
  await demo.page.evaluate(async () => {
    const name = (await indexedDB.databases()).map((one) => one.name).find((one) => one.startsWith('groundling'));
    const database = await new Promise((resolve) => {
      indexedDB.open(name).onsuccess = ({ target }) => resolve(target.result);
    });
    const change = database.transaction(['index', 'texts'], 'readwrite');
    change.objectStore('index').getAll().onsuccess = ({ target }) => {
      const entries = target.result.map((text) => JSON.parse(text));
      const newest = entries.sort((a, b) => b.number - a.number)[0];
      change.objectStore('texts').put('{"groundling-session":1,"wor', `${newest.kind}/${newest.name}#${newest.copy}`);
    };
    await new Promise((resolve) => { change.oncomplete = resolve; });
    database.close();
  });
  await reloaded(demo, 'Before');
});

flow('no store, a newer store and an older page are told apart', async (t) => {
  const told = (setUp, fault, words) => t.elsewhere({ serviceWorkers: 'block' }, async (page) => {
    await setUp(page);
    await page.goto(t.address);
    const demo = new Demo(t, page);
    await demo.ready();
    await demo.by('not-kept').waitFor();
    await t.equal(() => demo.by('not-kept').getAttribute('data-fault'), fault, 'the fault');
    await t.check(async () => words.test(await demo.by('not-kept').textContent()), () => demo.by('not-kept').textContent());
    await demo.ask('go to the blue room');
    await t.check(async () => (await demo.plain()) !== null, 'all else works');
  });
  const made = (version) => async (page) => {
    await page.goto(`${t.address}help.en.html`);
    await page.evaluate(([name, number]) => new Promise((resolve) => {
      indexedDB.open(name, number).onsuccess = ({ target }) => { globalThis.held = target.result; resolve(); };
    }), [`groundling ${t.address} `, version]);
  };
  await told((page) => page.addInitScript(() => {
    Object.defineProperty(globalThis, 'indexedDB', { value: undefined });
  }), 'none', /keeps nothing/);
  await told(async (page) => {
    await made(99)(page);
    await page.evaluate(() => globalThis.held.close());
  }, 'newer', /newer build/);
  await told(async (page) => {
    const old = await page.context().newPage();
    await made(1)(old);
  }, 'older', /older build/);
});

flow('what is kept is listed, saved, deleted and opened again by keyboard', async (t) => {
  const demo = await openPage(t);
  await demo.ask('go to the blue room');
  // What it does moves the foot of the page, and who presses there would miss.
  await demo.finish();
  await kept(demo, '"command":"go to the blue room"');
  await demo.press('view-kept');
  await demo.by('kept-item').waitFor();
  await t.accessible('what is kept');
  await t.shot('kept-list');
  const file = await demo.saved('export');
  await demo.press('delete-all');
  await demo.by('nothing-kept').waitFor();
  await demo.by('session-file').focus();
  await demo.by('session-file').setInputFiles({ name: 'groundling.json', mimeType: 'application/json', buffer: Buffer.from(file) });
  await t.until('it is open', async () => (await demo.by('command').count()) > 0
    && (await demo.by('command').inputValue()) === 'go to the blue room');
  await demo.page.goBack();
  await demo.by('command').waitFor();
});
