// The page that asks people, as one of them uses it; and what stands around it: a study's file beside the page, a receiver
// of answers, a page with a frame as on Mechanical Turk.

import { execFile, spawn } from 'node:child_process';
import { mkdtemp, readFile, writeFile } from 'node:fs/promises';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import { promisify } from 'node:util';
import { Opened } from './opened.mjs';
import { chromium, root } from './packages.mjs';

/** A study of the six sentences' pairs, or of another corpus, with settings of its own, made by the command line. */
export async function makeStudy(t, settings = {}, more = ['--from', 'assets/corpus/six.csv']) {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  const file = path.join(folder, 'settings.json');
  await writeFile(file, JSON.stringify({ asked: 2, ...settings }));
  const { status, stdout, stderr } = await t.groundling('generate', '--study', 'Six', ...more, '--settings', file);
  if (status !== 0) throw new Error(stderr);
  return stdout;
}

/** Puts a study beside the page. */
export function host(t, study, name = 'study.json') {
  return t.context.route(`**/${name}`, (route) => route.fulfill({ contentType: 'application/json', body: study }));
}

/** Opens the page that asks with a query. */
export async function takePart(t, query = '?study=study.json') {
  return new Participant(t, await t.open(`${t.address}collect.html${query}`));
}

/** Somebody who takes part. */
export class Participant extends Opened {
  /** Waits for a stage: `welcome`, `instructions`, `turn`, `end`, `over`, `trouble`, `elsewhere`, `refused`. */
  async at(stage) {
    await this.page.locator(`.collect[data-stage="${stage}"]`).waitFor();
  }

  /** How many notes are kept. */
  async notes() {
    return Number(await this.page.locator('.collect').getAttribute('data-sitting'));
  }

  /** Agrees and reads on to the first turn. */
  async begin() {
    await this.at('welcome');
    await this.press('agree');
    await this.at('instructions');
    await this.press('ready');
    await this.at('turn');
  }

  /** Which turn is on view, as the page says it. */
  turn() {
    return this.page.locator('.progress span').textContent();
  }

  /** Answers the turn on view, and waits until the answer is kept. */
  async answer(words) {
    const before = await this.notes();
    await this.by('command').fill(words);
    await this.press('next');
    await this.t.until(`“${words.slice(0, 30)}” is kept`, async () =>
      (await this.notes()) > before && this.page.evaluate(() => !document.getElementById('command')?.value));
  }

  /** The lines of the file that a button saves. */
  async saved(id) {
    const [download] = await Promise.all([this.page.waitForEvent('download'), this.press(id)]);
    return readFile(await download.path(), 'utf8');
  }
}

/** The answers in a file of lines. */
export const answersOf = (text) => text.trim().split('\n').map((line) => JSON.parse(line));

/**
 * A receiver on loopback that takes what is posted, when it is told to: `posts` holds it. A page at `/frame?…` embeds
 * the address behind its `src`.
 */
export async function receiver() {
  const state = { posts: [], status: 200 };
  const server = http.createServer((request, response) => {
    const cors = { 'Access-Control-Allow-Origin': '*', 'Access-Control-Allow-Headers': 'Content-Type' };
    if (request.method === 'OPTIONS') return response.writeHead(204, cors).end();
    if (request.method === 'GET') {
      const source = new URL(request.url, 'http://x').searchParams.get('src') ?? '';
      const escaped = source.replaceAll('&', '&amp;').replaceAll('"', '&quot;');
      response.writeHead(200, { 'Content-Type': 'text/html' });
      return response.end(source ? `<!DOCTYPE html><title>A platform</title><h1>A platform</h1><iframe title="study" name="study" width="1000" height="640" src="${escaped}"></iframe>` : '<!DOCTYPE html><title>Thanks</title><h1>Thanks</h1>');
    }
    let body = '';
    request.setEncoding('utf8');
    request.on('data', (part) => { body += part; });
    request.on('end', () => {
      if (state.status === 200) state.posts.push({ path: request.url, type: request.headers['content-type'], body });
      response.writeHead(state.status, { 'Content-Type': 'text/html', ...cors });
      response.end('<!DOCTYPE html><title>Taken</title><h1>Taken</h1>');
    });
  });
  await new Promise((resolve) => { server.listen(0, '127.0.0.1', resolve); });
  const address = `http://127.0.0.1:${server.address().port}`;
  return Object.assign(state, {
    address,
    close: () => new Promise((resolve) => { server.close(resolve); server.closeAllConnections(); }),
  });
}

/** A browser of its own with this profile, and how to kill all of it at once, as a power cut does. */
export async function startBrowser(profile) {
  const options = JSON.parse(await readFile(path.join(root, 'tests/browser/webdriver.json'), 'utf8'));
  const { binary, args } = options['goog:chromeOptions'];
  const own = [`--user-data-dir=${profile}`, '--remote-debugging-port=0', 'about:blank'];
  const child = spawn(binary, [...args, ...own], { detached: true, stdio: ['ignore', 'ignore', 'pipe'] });
  const ended = new Promise((resolve) => { child.once('exit', resolve); });
  const address = await new Promise((resolve, reject) => {
    let said = '';
    child.stderr.on('data', (part) => {
      said += part;
      const found = /DevTools listening on (ws:\S+)/.exec(said);
      if (found) resolve(found[1]);
    });
    child.once('exit', () => reject(new Error(`the browser ended: ${said.slice(-500)}`)));
  });
  const browser = await chromium.connectOverCDP(address);
  const kill = async () => {
    try {
      process.kill(-child.pid, 'SIGKILL');
    } catch {
      // It has ended already.
    }
    await ended;
  };
  return { context: browser.contexts()[0], kill };
}

/** The records of a table whose cells may be quoted. */
function records(text) {
  const rows = [[]];
  for (const [, quoted, plain, end] of text.matchAll(/(?:"((?:[^"]|"")*)"|([^",\r\n]*))(,|\r?\n|$)/g)) {
    rows.at(-1).push(quoted?.replaceAll('""', '"') ?? plain);
    if (end !== ',') rows.push([]);
    if (end === '') break;
  }
  return rows.filter((row) => row.length > 1);
}

/**
 * The crowd's commands in two files: those of some of its workers, to be said again in a rehearsal, and those of all
 * others, to be learned from. Rejected rows are among both.
 */
export async function crowd(share = 4) {
  const packed = path.join(root, 'assets/corpus/crowd.csv.xz');
  const { stdout } = await promisify(execFile)('xz', ['--decompress', '--stdout', packed], { maxBuffer: 1 << 28 });
  const [header, ...rows] = records(stdout);
  const worker = header.indexOf('WorkerId');
  const is = (row) => Number(row[worker].replace(/\D/g, '')) % share === 0;
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  const write = async (name, some) => {
    const file = path.join(folder, name);
    const line = (row) => row.map((cell) => `"${cell.replaceAll('"', '""')}"`).join(',');
    await writeFile(file, `${[header, ...some].map(line).join('\n')}\n`);
    return file;
  };
  return {
    folder,
    said: await write('said.csv', rows.filter(is)),
    others: await write('others.csv', rows.filter((row) => !is(row))),
  };
}
