// Trust: no program of the site reaches another origin or runs a text as code, on a host that sends no headers; and the
// service worker, which no policy of the page can hold, asks for nothing but its own files.

import { readFile } from 'node:fs/promises';
import http from 'node:http';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { root } from '../packages.mjs';
import { openPage } from '../page.mjs';
import { serve } from '../server.mjs';

/** What a file of www holds. */
const read = (name) => readFile(path.join(root, 'www', name), 'utf8');

/** The policy that a page has of its own. */
const policyOf = async (name) => /Content-Security-Policy" content="([^"]+)"/.exec(await read(name))[1];

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

/** What the page that drives a robot, and its engine, may do and not do. */
async function robotIsHeld(t, address, other) {
  const before = other.seen.visits;
  const page = await t.open(`${address}robot.html`);
  await page.getByTestId('link').click();
  await page.getByTestId('command').fill('go to the blue room');
  await t.until('the engine has come', () => page.getByTestId('ask').isEnabled());
  await t.equal(other.seen.visits, before, 'visits of another origin');
  await t.equal(() => page.workers().length, 1, 'engines');
  const programs = [page, ...page.workers()];
  for (const program of programs) {
    const seen = other.seen.visits;
    const comes = () => program.evaluate(attempts, [other.address, new URL('words.txt', address).href]);
    // What answers is no socket, but is asked.
    await t.equal(comes, HELD, 'what comes of leaving the site');
    await t.check(() => other.seen.visits > seen, 'a socket is asked for');
  }
}

flow('the page that drives a robot alone may open sockets, and opens none but to the address that was typed', async (t) => {
  t.expect(/content policy|Content Security Policy|another host is asked|ERR_BLOCKED_BY_CSP|request failed|WebSocket/i);
  const policies = await Promise.all(['robot.html', 'index.html', 'collect.html'].map(policyOf));
  await t.equal(policies.map((policy) => /\bwss?:/.test(policy)), [true, false, false], 'who may open sockets');
  const other = await stranger();
  try {
    await robotIsHeld(t, t.address, other);
  } finally {
    await other.close();
  }
});

/** The headers of every file, and of those that the guide names: what the guides tell a host to send. */
async function guided() {
  const blocks = (text) => [...text.matchAll(/\n```\n([^`]+)\n```\n/g)].map(([, block]) => block);
  const headers = (block) => Object.fromEntries(block.split('\n').map((line) => {
    const [, name, value] = /^([\w-]+): (.+)$/.exec(line);
    return [name, value];
  }));
  const all = headers(blocks(await read('guide/files.md')).find((block) => block.startsWith('Content-Security-Policy: ')));
  const own = async (name) => {
    const policy = blocks(await read(`guide/${name}.md`)).find((block) => block.startsWith('default-src'));
    return { ...all, 'Content-Security-Policy': `${policy}; frame-ancestors 'none'` };
  };
  return { 'index.html': all, 'robot.html': await own('robot'), 'collect.html': await own('collect') };
}

flow('every page works under the headers that the guides tell a host to send', { serviceWorkers: 'allow' }, async (t) => {
  t.expect(/content policy|Content Security Policy|another host is asked|ERR_BLOCKED_BY_CSP|request failed|WebSocket/i);
  const sent = await guided();
  for (const [name, { 'Content-Security-Policy': policy }] of Object.entries(sent)) {
    await t.equal(policy, `${await policyOf(name)}; frame-ancestors 'none'`, `the policy of ${name} in its guide`);
  }
  const other = await stranger();
  const site = await serve(process.env.SITE ?? path.join(root, 'target/site'), {
    under: '/sent/', headers: (name) => sent[name] ?? sent['index.html'],
  });
  try {
    const demo = await openPage(t, site.address);
    await demo.ask('put the yellow block in the biggest room');
    await demo.page.evaluate(() => navigator.serviceWorker.ready);
    await t.context.setOffline(true);
    await demo.page.reload();
    await demo.ready();
    await t.context.setOffline(false);
    await demo.workbench();
    await demo.train();
    await robotIsHeld(t, site.address, other);
    const collect = await t.open(`${site.address}collect.html`);
    await collect.locator('.collect[data-stage]').waitFor();
    await collect.evaluate(() => navigator.serviceWorker.ready);
    // Where a study's answers go is not known before the study is.
    await t.equal(() => collect.evaluate(attempts, [other.address, new URL('collect.js', site.address).href]),
      { ...HELD, fetch: 'done', blind: 'done' }, 'what the page that asks may do');
  } finally {
    await site.close();
    await other.close();
  }
});

for (const [worker, first, next, fetches] of [
  ['sw.js', 'index.html', 'robot.html', ['fetch(scope)', 'fetch(request)']],
  ['collect-sw.js', 'collect.html', 'collect.html', ['fetch(request)']],
]) {
  flow(`${worker} asks for nothing but the files of its site`, { serviceWorkers: 'allow' }, async (t) => {
    const asked = [];
    t.context.on('request', (request) => {
      if (request.serviceWorker()) asked.push(request.url());
    });
    const page = await t.open(`${t.address}${first}`);
    await page.evaluate(() => navigator.serviceWorker.ready);
    await page.goto(`${t.address}${next}`);
    await t.until('it has asked for the site', () => asked.some((url) => url.endsWith('boot.js')));
    await t.equal(asked.filter((url) => !url.startsWith(t.address)), [], 'what it asked for elsewhere');
    const code = (await read(worker)).replaceAll(/^\s*\/\/.*$/gm, '');
    await t.equal(code.match(/\bfetch\([^)]*\)/g), fetches, 'what it fetches');
    await t.check(!/\b(eval|Function|import|importScripts|WebSocket|EventSource|XMLHttpRequest|setTimeout|postMessage)\b/.test(code),
      'it has no other way to anywhere');
  });
}
