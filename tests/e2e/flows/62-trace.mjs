// What the page costs its main thread, by Chromium's own trace: while one types, while it plans, while a plan is
// played over a value map and arrows. Reported, never asserted. The rasteriser and the GPU's process are other threads
// and not counted; CPU time is told beside time by the clock, since other programs may be at work.

import { flow } from '../flow.mjs';
import { detached } from '../heap.mjs';
import { openPage } from '../page.mjs';
import { isTask, mainThreads, trace } from '../trace.mjs';

/**
 * Runs `body` under Chromium's trace; returns the tasks of the page's main thread, of these what drew a frame, and the
 * milliseconds of CPU that its main thread and its workers spent from each key press to the next.
 */
async function traced(page, body) {
  const events = await trace(page, body);
  // There may be other renderers; ours is at work.
  const [{ pid, tid, own, tasks }] = mainThreads(events);
  const isKey = ({ name, args }) => name === 'EventDispatch' && args.data?.type === 'keydown';
  const keys = own.filter(isKey).map(({ ts }) => ts);
  const isWorker = (event) => event.name === 'thread_name' && event.pid === pid && /Worker/.test(event.args.name);
  const ours = new Set([tid, ...events.filter(isWorker).map((event) => event.tid)]);
  const all = events.filter((event) => event.pid === pid && ours.has(event.tid) && isTask(event));
  const pressed = keys.map((key, place) => {
    const next = keys[place + 1] ?? Infinity;
    return cpu(all.filter(({ ts }) => key <= ts && ts < next).map(({ dur, tdur }) => ({ cpu: (tdur ?? dur) / 1000 })));
  });
  return { tasks, frames: tasks.filter(({ frame }) => frame), pressed };
}

const cpu = (tasks) => tasks.reduce((all, task) => all + task.cpu, 0);

/** The longest task and those over 50 ms, in words. */
function told({ tasks }) {
  const longest = tasks.reduce((a, b) => (a.clock > b.clock ? a : b), { clock: 0, cpu: 0 });
  const long = tasks.filter(({ cpu }) => cpu > 50).length;
  return `longest task ${longest.clock.toFixed(1)} ms (CPU ${longest.cpu.toFixed(1)} ms), ${long} over 50 ms`;
}

/** From now on the page notes how long after each key press the words in the box stand there read. */
function watchReadings(page) {
  return page.evaluate(() => {
    const by = (id) => [...document.querySelectorAll(`[data-testid="${id}"]`)];
    globalThis.readings = [];
    globalThis.planned = null;
    let pressed = null;
    let sent = null;
    const own = (word) => [...word.childNodes].find((node) => node.nodeType === Node.TEXT_NODE).data.trim();
    addEventListener('keydown', (event) => {
      if (event.key === 'Enter') sent = event.timeStamp; else pressed = event.timeStamp;
    }, true);
    new MutationObserver(() => {
      const read = by('word').map(own).join(' ');
      if (pressed !== null && read === by('command')[0].value.trim()) {
        globalThis.readings.push(performance.now() - pressed);
        pressed = null;
      }
      if (sent !== null && by('plan').length > 0) globalThis.planned ??= performance.now() - sent;
    }).observe(document.body, { subtree: true, childList: true, characterData: true });
  });
}

flow('what the page costs its main thread', { gpu: true, reducedMotion: 'no-preference' }, async (t) => {
  const demo = await openPage(t, `${t.address}#talk`);
  const { page } = demo;
  // The browser makes a program faster while it runs: what comes after the first minute is told.
  await demo.ask('go to the red room');
  await demo.played();
  await demo.press('reset-world');
  const type = async () => {
    await demo.by('command').fill('');
    await demo.by('command').focus();
    await page.keyboard.type('put the yellow block in the biggest room', { delay: 80 });
  };
  const key = ({ pressed }) => {
    const spent = pressed.toSorted((a, b) => a - b);
    return `${spent[Math.floor(spent.length / 2)].toFixed(1)} ms of CPU (median of ${spent.length}; main thread and workers)`;
  };
  t.note(`a key press, as the page opens: ${key(await traced(page, type))}`);
  await demo.deepen('see');
  const typing = await traced(page, type);
  // To look for readings costs something, too: not while what typing costs is counted.
  await watchReadings(page);
  await type();
  const readings = (await page.evaluate(() => globalThis.readings)).sort((a, b) => a - b);
  await t.check(readings.length > 5, `${readings.length} readings while typing`);
  const [median, most] = [readings[Math.floor(readings.length / 2)], readings.at(-1)];
  t.note(`key press to reading: ${median.toFixed(0)} ms (median), ${most.toFixed(0)} ms (longest of ${readings.length})`);
  await t.check(typing.pressed.length >= readings.length, `${typing.pressed.length} keys in the trace`);
  t.note(`a key press, at the depth “see”: ${key(typing)}`);
  t.note(`typing: ${told(typing)}`);
  const planning = await traced(page, async () => {
    await page.keyboard.press('Enter');
    await demo.by('legend').waitFor();
  });
  t.note(`Enter to plan: ${(await page.evaluate(() => globalThis.planned)).toFixed(0)} ms`);
  t.note(`planning: ${told(planning)}`);
  await demo.seek(0);
  await demo.by('plan-speed').selectOption('1×');
  const playing = await traced(page, () => page.evaluate(() => new Promise((resolve) => {
    const plan = document.querySelector('[data-testid="plan"]');
    document.querySelector('[data-testid="plan-play"]').click();
    new MutationObserver(() => plan.dataset.at === plan.dataset.steps && plan.dataset.playing === 'false' && resolve())
      .observe(plan, { attributes: true });
  })));
  const { frames } = playing;
  await t.check(frames.length > 0, 'frames were drawn');
  t.note(`playing with values and arrows: a frame ${(cpu(frames) / frames.length).toFixed(1)} ms of CPU, at most `
    + `${Math.max(...frames.map((frame) => frame.cpu)).toFixed(1)} ms (${frames.length} frames)`);
  t.note(`playing: ${cpu(playing.tasks).toFixed(0)} ms of CPU in all; ${told(playing)}`);
});

flow('a command leaves no element behind', { gpu: true }, async (t) => {
  const demo = await openPage(t);
  const around = async () => {
    for (const room of ['blue', 'red', 'green']) {
      await demo.ask(`go to the ${room} room`);
      await demo.finish();
    }
  };
  // The framework keeps one of each tag that was ever shown.
  await around();
  const before = await detached(demo.page);
  await around();
  await around();
  await t.check(async () => (await detached(demo.page)) <= before, 'detached elements');
  const now = await detached(demo.page);
  await demo.page.evaluate(() => { globalThis.kept = document.createElement('output'); });
  await t.equal(() => detached(demo.page), now + 1, 'and one that is kept is counted');
});
