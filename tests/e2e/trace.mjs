// Chromium's own trace of a page: the tasks of its main thread and of its workers, by the clock and by CPU time. CPU time
// is what counts, since other programs may be at work.

/** A task of a thread. */
export const isTask = ({ name, dur }) => name === 'RunTask' && dur;

/** Runs `body` under the trace; returns its events. */
export async function trace(page, body) {
  const browser = page.context().browser();
  const categories = ['-*', 'devtools.timeline', 'disabled-by-default-devtools.timeline', 'toplevel', '__metadata'];
  await browser.startTracing(page, { categories });
  let events;
  try {
    await body();
  } finally {
    ({ traceEvents: events } = JSON.parse(await browser.stopTracing()));
  }
  return events;
}

/** The main threads of renderers, each with its tasks, in ms. */
export function mainThreads(events) {
  const isMain = ({ name, args }) => name === 'thread_name' && args.name === 'CrRendererMain';
  return events.filter(isMain).map(({ pid, tid }) => {
    const own = events.filter((event) => event.pid === pid && event.tid === tid);
    const callbacks = own.filter(({ name }) => name === 'FireAnimationFrame').map(({ ts }) => ts);
    const tasks = own.filter(isTask).map(({ ts, dur, tdur }) => ({
      clock: dur / 1000,
      cpu: (tdur ?? dur) / 1000,
      frame: callbacks.some((callback) => ts <= callback && callback < ts + dur),
    }));
    return { pid, tid, own, tasks };
  }).sort((one, other) => other.tasks.length - one.tasks.length);
}

/** The most MB of WebAssembly memory that an engine that learns holds, of all that are up. */
export async function engineMemory(page, address) {
  const all = await Promise.all(page.workers().map((worker) => worker.evaluate(async (script) => {
    const { default: start } = await import(script);
    // Of a program that has started this gives what it exports, and starts nothing.
    const { memory } = await start();
    return memory.buffer.byteLength / 1e6;
  }, `${address}learner.js`).catch(() => 0)));
  return Math.max(0, ...all);
}
