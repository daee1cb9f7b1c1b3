// Drives the built site in Chromium: `node run.mjs [--folder flows] [WORD…]` runs the flow files of a folder
// one after another (those whose title or file holds a WORD), under a sub-path as any static host may
// serve it. With AGAIN=1 those that failed are run once more after all others, and named: a flow that needs two tries
// counts as passed, and is to be mended all the same. Ends with what failed and "N passed, N failed".
// Screenshots and diffs: target/e2e.

import { readdir, readFile } from 'node:fs/promises';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { Flow, PATIENCE, flows } from './flow.mjs';
import { chromium, root } from './packages.mjs';
import { serve } from './server.mjs';

/** Longest time for one flow, unless it says otherwise. */
const SECONDS = 600;

const words = process.argv.slice(2);
const at = words.indexOf('--folder');
const folder = at < 0 ? 'flows' : words.splice(at, 2)[1];
const here = path.join(root, 'tests/e2e', folder);
for (const name of (await readdir(here)).filter((name) => name.endsWith('.mjs')).sort()) {
  const before = flows.length;
  await import(pathToFileURL(path.join(here, name)));
  for (const flow of flows.slice(before)) flow.file = name;
}
const chosen = flows.filter(({ title, file }) =>
  words.length === 0 || words.some((word) => `${file} ${title}`.includes(word)));

const options = JSON.parse(await readFile(path.join(root, 'tests/browser/webdriver.json'), 'utf8'));
const { binary, args } = options['goog:chromeOptions'];
const browser = await chromium.launch({ executablePath: binary, args, headless: true });
const site = await serve(process.env.SITE ?? path.join(root, 'target/site'), { under: '/some/sub-path/' });

/** Runs one flow; returns what went wrong (or null) and what it has to tell. */
async function run({ title, settings, body }) {
  // Files come from the server, steps jump, and what moves is drawn plainly, as it is without a GPU, which takes a
  // rasteriser in software half the time; flows about these ask for more.
  const usual = { viewport: { width: 1024, height: 720 }, serviceWorkers: 'block', reducedMotion: 'reduce' };
  const { gpu = false, seconds = SECONDS, ...own } = settings;
  const context = await browser.newContext({ ...usual, ...own });
  context.setDefaultTimeout(PATIENCE * 1000);
  const flow = new Flow(context, site.address);
  if (gpu) await flow.pretendGpu();
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`not done in ${seconds} s`)), seconds * 1000);
  });
  try {
    await Promise.race([body(flow), late]);
    const problems = flow.unexpected();
    if (problems.length > 0) throw new Error(`the page had problems:\n${problems.join('\n')}`);
    return { wrong: null, notes: flow.notes };
  } catch (error) {
    const name = title.replaceAll(/[^a-z0-9]+/gi, '-');
    await flow.page?.screenshot({ path: path.join(root, `target/e2e/failed-${name}.png`) }).catch(() => {});
    const problems = flow.unexpected().filter((problem) => !error.message.includes(problem));
    return { wrong: [error.stack ?? error, ...problems].join('\n'), notes: flow.notes };
  } finally {
    clearTimeout(timer);
    // A page that hangs may not even be closed.
    await Promise.race([context.close(), new Promise((resolve) => { setTimeout(resolve, 20_000); })]);
  }
}

/** Runs flows one after another; returns those that failed. */
async function runAll(some) {
  const failed = [];
  for (const flow of some) {
    const start = Date.now();
    const { wrong, notes } = await run(flow);
    const seconds = ((Date.now() - start) / 1000).toFixed(1);
    console.log(`${wrong ? 'FAILED' : 'ok    '} ${flow.file}: ${flow.title} (${seconds} s)`);
    for (const note of notes) console.log(`       ${note}`);
    if (wrong) {
      console.log(indented(wrong));
      failed.push({ flow, wrong });
    }
  }
  return failed;
}

const indented = (text) => text.replaceAll(/^/gm, '       ');

let failed = await runAll(chosen);
if (process.env.AGAIN && failed.length > 0) {
  console.log('Those that failed, again:');
  const first = failed;
  failed = await runAll(first.map(({ flow }) => flow));
  for (const { flow, wrong } of first) {
    if (failed.some((again) => again.flow === flow)) continue;
    console.log(`needed two tries: ${flow.file}: ${flow.title}\n${indented(wrong)}`);
  }
}
await browser.close();
await site.close();
// Again at the end, where one who reads the last lines of a long log finds it.
for (const { flow, wrong } of failed) console.log(`FAILED ${flow.file}: ${flow.title}\n${indented(wrong)}`);
const bad = chosen.length === 0 ? 1 : failed.length;
console.log(`${Math.max(chosen.length - bad, 0)} passed, ${bad} failed`);
process.exitCode = bad === 0 ? 0 : 1;
