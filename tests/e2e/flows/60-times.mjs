// How long things take in the page, from the press to what it changes. Reported, never asserted: frames are
// drawn in software here, and other programs may be at work.

import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';
import { NEWS, decode, encode } from '../wire.mjs';
import { root } from '../packages.mjs';

/** Milliseconds from a click on `press` until an element `awaited` is there and says `words`, and until it was drawn. */
function taken(page, press, awaited, words = '') {
  return page.evaluate(([from, to, text]) => new Promise((resolve) => {
    const by = (id) => document.querySelector(`[data-testid="${id}"]`);
    const start = performance.now();
    const look = () => {
      const there = performance.now() - start;
      if (by(to)?.textContent.includes(text)) {
        requestAnimationFrame(() => resolve([there, performance.now() - start].map(Math.round)));
      } else setTimeout(look);
    };
    by(from).click();
    look();
  }), [press, awaited, words]);
}

flow('times', { gpu: true }, async (t) => {
  const demo = await openPage(t);
  const [loaded, bytes] = await demo.page.evaluate(() => {
    const resources = performance.getEntriesByType('resource');
    return [performance.getEntriesByType('navigation')[0].duration,
      resources.reduce((sum, entry) => sum + entry.decodedBodySize, 0)];
  });
  t.note(`the page: ${loaded.toFixed(0)} ms, ${(bytes / 1e6).toFixed(1)} MB before compression so far`);
  await demo.by('command').fill('go to the blue room');
  // The page comes to rest before it is asked.
  await new Promise((resolve) => setTimeout(resolve, 1000));
  const [answered, drawn] = await taken(demo.page, 'ask', 'plan');
  t.note(`a command parsed, grounded and planned: ${answered} ms; on the screen: ${drawn} ms`);
  await demo.workbench();
  await demo.part('run');
  const [trained] = await taken(demo.page, 'train', 'trained', 'trained here');
  t.note(`six sentences, 15 epochs: ${trained} ms`);
});

/** Plans in a worker of its own: milliseconds to each answer, and how it begins. */
async function answers(page, requests) {
  const all = await page.evaluate(async ([messages, news]) => {
    const engine = new Worker(new URL('engine.js', document.baseURI), { type: 'module' });
    // The page's own program, as the page sends it.
    const [script, program] = ['script', 'program'].map((kind) => document.querySelector(`link[data-app=${kind}]`).href);
    engine.postMessage({ script, program: await WebAssembly.compileStreaming(fetch(program)) });
    const heard = [];
    let wake = () => {};
    engine.onmessage = (event) => { heard.push(event.data); wake(); };
    const next = async () => {
      while (heard.length === 0) await new Promise((resolve) => { wake = resolve; });
      return heard.shift();
    };
    await next();
    const all = [];
    // The third byte is the kind.
    const isNews = (said) => news.includes(said[2]);
    for (const message of messages) {
      const start = performance.now();
      engine.postMessage(Uint8Array.from(message));
      let said;
      do said = await next(); while (isNews(said));
      all.push({ taken: performance.now() - start, said: [...said.slice(0, 32)] });
    }
    engine.terminate();
    return all;
  }, [requests.map(encode), NEWS]);
  return all.map(({ taken, said }) => ({ taken, said: decode(said) }));
}

flow('times of planning', { gpu: true }, async (t) => {
  const text = await readFile(path.join(root, 'tests/benches/worlds/nine.json'), 'utf8');
  const world = (objects, lock) => {
    const state = JSON.parse(text);
    state.objects.length = objects;
    for (const door of state.doors) door.lock = lock;
    return state;
  };
  const the = (...predicates) => `(the:<<e,t>,e> (lambda $0:e (and:<t*,t> ${predicates.map((p) => `(${p}:<e,t> $0)`).join(' ')})))`;
  const brought = ['red', 'blue', 'green'].map((room, i) => {
    const { shape, color } = world(3, 'unlocked').objects[i];
    return `(in:<e,<e,t>> ${the(shape, color)} ${the('room', room)})`;
  });
  const rules = { pull: true, robot: false, landmarks_stay: false, slip: 0, lock: 0, loss: 0, luck: 0 };
  const all = `(and:<t*,t> ${brought.join(' ')})`;
  const requests = [
    { plan: { form: all, state: world(3, 'unlocked'), rules } },
    { values: { state: world(3, 'unlocked') } },
    { plan: { form: all, state: world(3, 'unknown'), rules: { ...rules, lock: 0.5 } } },
    { roll_out: { runs: 1000, seed: 0 } },
  ];
  // The browser makes a program faster while it runs: what a visitor meets first, and what the tenth time takes.
  const rounds = await answers((await openPage(t)).page, Array(10).fill(requests).flat());
  const [shortest, sure, chancy, runs] = rounds;
  const taken = (nth) => [rounds[nth], rounds.at(nth - 4)].map((one) => `${one.taken.toFixed(0)} ms`).join(', then ');
  await t.equal([shortest.said.kind, shortest.said.first], ['planned', 29], 'the plan and its length');
  t.note(`three objects to three rooms: ${taken(0)}`);
  await t.check(sure.said.kind === 'values' && sure.said.first > 0, 'cells are worth something');
  t.note(`what the cells are worth: ${taken(1)}`);
  await t.equal(chancy.said.kind, 'planned', 'a plan for what may happen');
  t.note(`the same behind doors that lock: ${taken(2)}`);
  const { kind, first, second } = runs.said;
  await t.equal([kind, first], ['rolled_out', 1000], 'all runs');
  await t.check(second > 200 && second < 300, `both doors open in one of four worlds, not ${second} of 1,000`);
  t.note(`a thousand runs of that policy: ${taken(3)}`);
});
