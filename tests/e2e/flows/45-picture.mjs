// The picture of the room: drawn by the GPU, crisp, moving; and what stands in for it when there is no GPU,
// when it goes away, or when its program does not come.

import { flow } from '../flow.mjs';
import { colours } from '../golden.mjs';
import { openPage } from '../page.mjs';

/** Things glide from step to step. */
const GLIDING = { gpu: true, reducedMotion: 'no-preference' };

/** Waits until the stage is drawn this way. */
async function drawnBy(demo, backend) {
  await demo.t.until(`drawn by ${backend}`, async () =>
    (await demo.by('stage').getAttribute('data-backend')) === backend);
}

/** The robot is led to the blue room, and the page says so. */
async function goesToTheBlueRoom(demo) {
  await demo.ask('go to the blue room');
  await demo.played();
  await demo.t.equal(async () => (await demo.robot()).room, 'blue', 'where the robot ends');
}

/** Takes the GPU away from the canvas that is shown. */
const lose = (demo) => demo.by('stage').locator('canvas').evaluate((canvas) =>
  canvas.getContext('webgl2').getExtension('WEBGL_lose_context').loseContext());

flow('the picture is the golden one at the start, with values and policy, and where a phrase is pointed at', { gpu: true }, async (t) => {
  const demo = await openPage(t);
  await drawnBy(demo, 'webgl2');
  const stage = demo.by('stage');
  await t.check(async () => colours(await stage.screenshot()) > 20, 'a picture of many colours');
  await t.golden('start', stage);
  await demo.deepen('see');
  await demo.ask('put the yellow block in the biggest room');
  await demo.seek(0);
  await t.until('the values', async () => (await demo.by('legend').count()) > 0);
  await demo.page.mouse.move(0, 0);
  await t.golden('values', stage);
  for (const layer of ['goal', 'values', 'arrows']) await demo.press(`layer-${layer}`);
  await demo.by('word').nth(2).hover();
  await t.golden('referent', stage);
});

flow('the picture is the golden one in the dark', { gpu: true, colorScheme: 'dark' }, async (t) => {
  const demo = await openPage(t);
  await drawnBy(demo, 'webgl2');
  await t.golden('dark', demo.by('stage'));
});

for (const ratio of [1, 1.5, 3]) {
  flow(`the picture is crisp at ${ratio} device pixels a pixel`, { gpu: true, deviceScaleFactor: ratio }, async (t) => {
    const demo = await openPage(t);
    await drawnBy(demo, 'webgl2');
    const widths = () => demo.by('stage').locator('canvas').evaluate((canvas) =>
      [canvas.width, canvas.getBoundingClientRect().width]);
    const isCrisp = ([width, shown]) => Math.abs(width - shown * ratio) <= 1;
    await t.check(async () => isCrisp(await widths()), async () => `pixels and width at ${ratio}: ${await widths()}`);
  });
}

flow('steps glide', GLIDING, async (t) => {
  const demo = await openPage(t, `${t.address}#talk`);
  await drawnBy(demo, 'webgl2');
  const seen = await stillness(demo);
  await t.check(seen.includes('false'), `the picture moves between steps: ${seen}`);
});

flow('steps jump for who prefers less motion', { gpu: true }, async (t) => {
  const demo = await openPage(t);
  await drawnBy(demo, 'webgl2');
  const seen = await stillness(demo);
  await t.check(!seen.includes('false'), `the picture never moves between steps: ${seen}`);
});

/** Whether the picture was still, each time that this changed while a plan was played. */
async function stillness(demo) {
  const stage = demo.by('stage');
  await stage.evaluate((element) => {
    globalThis.seen = [element.dataset.still];
    new MutationObserver(() => globalThis.seen.push(element.dataset.still))
      .observe(element, { attributeFilter: ['data-still'] });
  });
  await demo.ask('go to the blue room');
  await demo.played();
  return demo.page.evaluate(() => globalThis.seen);
}

flow('a GPU that goes away while the robot moves is replaced, and in the end done without', GLIDING, async (t) => {
  const demo = await openPage(t, `${t.address}#talk`);
  await drawnBy(demo, 'webgl2');
  t.expect(/WebGL|CONTEXT_LOST|context/i);
  await lose(demo);
  await t.until('a fresh canvas', async () =>
    demo.by('stage').locator('canvas').evaluate((canvas) => !canvas.getContext('webgl2')?.isContextLost()));
  await drawnBy(demo, 'webgl2');
  await t.check(async () => colours(await demo.by('stage').screenshot()) > 20, 'drawn again');
  await demo.ask('put the yellow block in the biggest room');
  await lose(demo);
  await drawnBy(demo, 'svg');
  await t.check(async () => colours(await demo.by('stage').screenshot()) > 20, 'drawn by the page itself');
  await demo.played();
  await t.check(async () => /yellow block in the blue room/.test(await demo.world()), 'the plan was played all the while');
  await t.accessible('a page without a GPU');
  await t.shot('no-gpu');
});

flow('a browser without a GPU is drawn for by the page itself', { gpu: true }, async (t) => {
  await t.context.addInitScript(() => {
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function getContext(kind, ...rest) {
      return /webgl|webgpu/.test(kind) ? null : original.call(this, kind, ...rest);
    };
  });
  const demo = await openPage(t);
  t.expect(/WebGL|GPU|context/i);
  await drawnBy(demo, 'svg');
  await goesToTheBlueRoom(demo);
});

flow('the page works when its renderer does not come', { gpu: true }, async (t) => {
  await t.context.route(/renderer[^/]*\.wasm/, (route) => route.abort());
  const demo = await openPage(t);
  t.expect(/renderer|Failed to (fetch|load)|ERR_FAILED/);
  await drawnBy(demo, 'svg');
  await goesToTheBlueRoom(demo);
});
