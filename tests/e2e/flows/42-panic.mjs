// Errors in the program itself, in page and engine: told in words, the first of them kept, with a way on.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

flow('a page that panics says so, once, and starts again', async (t) => {
  const demo = await openPage(t);
  await demo.page.evaluate(() => {
    const tell = (detail) => dispatchEvent(new CustomEvent('groundling:crashed', { detail }));
    tell('panicked at src/ui/state.rs: the first');
    tell('panicked at src/ui/state.rs: the second');
    const error = new WebAssembly.RuntimeError('unreachable');
    dispatchEvent(new ErrorEvent('error', { error }));
  });
  await demo.by('crash').waitFor();
  await t.check(async () => /^[^]*the first(?![^]*(the second|unreachable))/.test(await demo.by('crash-report').textContent()),
    'the first is the one kept');
  await t.check(() => demo.by('crash-restart').evaluate((button) => button === document.activeElement), 'the way on has the focus');
  await t.accessible('a page that has stopped');
  await t.shot('crash');
  await demo.press('crash-restart');
  await demo.ready();
  await t.equal(() => demo.by('crash').isVisible(), false, 'the page is back');
});

flow('an engine that panics says so, and goes on with what was loaded', async (t) => {
  const demo = await openPage(t);
  const said = 'panicked at src/ccg/chart.rs: an invented reason';
  await demo.page.evaluate((data) => {
    globalThis.flowWorkers[0].dispatchEvent(new MessageEvent('message', { data }));
  }, said);
  await demo.by('engine-stopped').waitFor();
  await t.check(async () => (await demo.by('engine-report').textContent()).includes(said), 'its words are shown');
  await demo.press('restart-engine');
  await t.until('the engine is back', async () => (await demo.by('engine-stopped').count()) === 0);
  await demo.ready();
  await demo.ask('go to the blue room');
  await t.equal(() => demo.plain(), 'I will go to the blue room.', 'and answers');
});

flow('a page without its model says so, and can train one', async (t) => {
  t.expect(/cleanup\.model/);
  t.expect(/404/);
  await t.context.route(/cleanup\.model/, (route) => route.fulfill({ status: 404, body: '' }));
  await t.open();
  const notice = t.page.getByTestId('model-notice');
  await notice.waitFor();
  await t.check(async () => /404/.test(await notice.textContent()), 'why');
  await t.accessible('a page without its model');
  await t.context.unroute(/cleanup\.model/);
  await t.page.getByTestId('fetch-model').click();
  await t.until('it came', () => t.page.locator('form.say.main[aria-busy=false]').count());
});

flow('what comes late comes when it is wanted, though it did not come by itself', async (t) => {
  await t.context.addInitScript(() => {
    const own = fetch;
    globalThis.fetch = (what, how) => (/_late\./.test(what) ? Promise.reject(new Error('away')) : own(what, how));
  });
  const demo = await openPage(t);
  await demo.ask('go to the blue room');
  await demo.press('ask-why');
  await demo.by('planner').waitFor();
  await t.equal(() => demo.plain(), 'I will go to the blue room.', 'and the page goes on');
});

flow('what comes late and cannot be fetched is told in words', async (t) => {
  t.expect(/_late\.|A part of the (page|talker) could not be fetched|Failed to load resource: net::ERR_FAILED/);
  await t.context.route(/_late\./, (route) => route.abort());
  const demo = await openPage(t);
  await demo.by('command').fill('go to the blue room');
  await demo.page.keyboard.press('Enter');
  await demo.by('crash').waitFor();
  await t.check(async () => /could not be fetched/.test(await demo.by('crash-report').textContent()), 'why');
  await t.context.unroute(/_late\./);
  await demo.press('crash-restart');
  await demo.ready();
  await demo.ask('go to the blue room');
  await t.equal(() => demo.plain(), 'I will go to the blue room.', 'with it, the page goes on');
});
