// Trust: no program of the site reaches another origin or runs a text as code, on a host that sends no headers; and the
// service worker, which no policy of the page can hold, asks for nothing but its own files.

import { readFile } from 'node:fs/promises';
import http from 'node:http';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { root } from '../packages.mjs';
import { openPage } from '../page.mjs';

/** A server of another origin that counts who comes, whatever they want. */
async function stranger() {
  const seen = { visits: 0 };
  const server = http.createServer((_, response) => {
    response.writeHead(200, { 'Access-Control-Allow-Origin': '*', 'Content-Type': 'text/javascript' });
    response.end('export default 1;');
  });
  server.on('connection', () => { seen.visits += 1; });
  await new Promise((resolve) => { server.listen(0, '127.0.0.1', resolve); });
  const address = `http://127.0.0.1:${server.address().port}/`;
  return { seen, address, close: () => new Promise((resolve) => { server.close(resolve); server.closeAllConnections(); }) };
}

/** What comes of leaving the site and of running texts, tried from inside a program; and of what it needs. */
async function attempts([elsewhere, own]) {
  const comes = async (attempt) => {
    try {
      await attempt();
      return 'done';
    } catch {
      return 'refused';
    }
  };
  const socket = (address) => new Promise((resolve, reject) => {
    const opened = new WebSocket(address);
    opened.onopen = resolve;
    opened.onerror = reject;
  });
  return {
    fetch: await comes(() => fetch(elsewhere)),
    blind: await comes(() => fetch(elsewhere, { mode: 'no-cors' })),
    socket: await comes(() => socket(elsewhere.replace('http', 'ws'))),
    eval: await comes(() => (0, eval)('1')),
    function: await comes(() => new Function('return 1')()),
    own: await comes(() => fetch(own)),
    wasm: await comes(() => WebAssembly.compile(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]))),
  };
}

const HELD = {
  fetch: 'refused', blind: 'refused', socket: 'refused', eval: 'refused', function: 'refused', own: 'done', wasm: 'done',
};

flow('no program of the page reaches another origin or runs a text as code', async (t) => {
  t.expect(/content policy|Content Security Policy|another host is asked|ERR_BLOCKED_BY_CSP|request failed: .*csp/i);
  const [page, guide] = await Promise.all(['www/index.html', 'www/guide/files.md'].map((name) =>
    readFile(path.join(root, name), 'utf8')));
  const [, policy] = /Content-Security-Policy" content="([^"]+)"/.exec(page);
  await t.check(guide.includes(`\nContent-Security-Policy: ${policy}; frame-ancestors 'none'\n`), 'the guide gives the same policy');
  const other = await stranger();
  try {
    const demo = await openPage(t);
    const own = new URL('words.txt', t.address).href;
    await t.until('the renderer draws', async () => (await demo.by('stage').getAttribute('data-backend')) === 'webgl2');
    await t.equal(() => demo.page.evaluate(attempts, [other.address, own]), HELD, 'the page, with the renderer in it');
    await demo.workbench();
    await demo.train();
    await t.until('both engines run', () => demo.page.workers().length === 2);
    const programs = await Promise.all(demo.page.workers().map((worker) => worker.evaluate(() =>
      (performance.getEntriesByType('resource').some(({ name }) => name.endsWith('learner_bg.wasm')) ? 'learner' : 'talker'))));
    await t.equal(programs.sort(), ['learner', 'talker'], 'who they are');
    for (const worker of demo.page.workers()) {
      await t.check(worker.url().startsWith('blob:'), `${worker.url()} has the page's policy`);
      await t.equal(() => worker.evaluate(attempts, [other.address, own]), HELD, 'an engine');
    }
    await t.equal(other.seen.visits, 0, 'visits of another origin');
    await fetch(other.address);
    await t.equal(() => other.seen.visits, 1, 'a visit would have been seen');
  } finally {
    await other.close();
  }
});

flow('the page that drives a robot alone may open sockets, and opens none but to the address that was typed', async (t) => {
  t.expect(/content policy|Content Security Policy|another host is asked|ERR_BLOCKED_BY_CSP|request failed|WebSocket/i);
  const read = (name) => readFile(path.join(root, 'www', name), 'utf8');
  const policies = await Promise.all(['robot.html', 'index.html', 'collect.html'].map(async (name) =>
    /Content-Security-Policy" content="([^"]+)"/.exec(await read(name))[1]));
  const guide = await read('guide/robot.md');
  await t.check(guide.includes(`\n${policies[0]}\n`), 'the guide gives the same policy');
  await t.equal(policies.map((policy) => /\bwss?:/.test(policy)), [true, false, false], 'who may open sockets');
  const other = await stranger();
  try {
    const page = await t.open(`${t.address}robot.html`);
    await page.getByTestId('link').click();
    await page.getByTestId('command').fill('go to the blue room');
    await t.until('the engine has come', () => page.getByTestId('ask').isEnabled());
    await t.equal(other.seen.visits, 0, 'visits of another origin');
    const comes = () => page.evaluate(attempts, [other.address, new URL('words.txt', t.address).href]);
    // What answers is no socket, but is asked.
    await t.equal(comes, HELD, 'what comes of leaving the site');
    await t.check(() => other.seen.visits > 0, 'a socket is asked for');
  } finally {
    await other.close();
  }
});

flow('the service worker asks for nothing but the files of its site', { serviceWorkers: 'allow' }, async (t) => {
  const asked = [];
  t.context.on('request', (request) => {
    if (request.serviceWorker()) asked.push(request.url());
  });
  const demo = await openPage(t);
  await demo.page.evaluate(() => navigator.serviceWorker.ready);
  await demo.page.reload();
  await demo.ready();
  await demo.workbench();
  await t.until('it has asked for the site', () => asked.some((url) => url.endsWith('learner_bg.wasm')));
  await t.equal(asked.filter((url) => !url.startsWith(t.address)), [], 'what it asked for elsewhere');
  const code = (await readFile(path.join(root, 'www/sw.js'), 'utf8')).replaceAll(/^\s*\/\/.*$/gm, '');
  await t.equal(code.match(/\bfetch\([^)]*\)/g), ['fetch(scope)', 'fetch(request)'], 'what it fetches');
  await t.check(!/\b(eval|Function|import|importScripts|WebSocket|EventSource|XMLHttpRequest|setTimeout|postMessage)\b/.test(code),
    'it has no other way to anywhere');
});
