// How long things take in the page, from the press to what it changes. Reported, never asserted: frames are
// drawn in software here, and other programs may be at work.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

/** Milliseconds from a click on `press` until an element `awaited` is there, and until it was drawn. */
function taken(page, press, awaited) {
  return page.evaluate(([from, to]) => new Promise((resolve) => {
    const by = (id) => document.querySelector(`[data-testid="${id}"]`);
    const start = performance.now();
    const look = () => {
      const there = performance.now() - start;
      if (by(to)) requestAnimationFrame(() => resolve([there, performance.now() - start].map(Math.round)));
      else setTimeout(look);
    };
    by(from).click();
    look();
  }), [press, awaited]);
}

flow('times', async (t) => {
  const demo = await openPage(t);
  const training = await taken(demo.page, 'train', 'trained');
  t.note(`six sentences, 15 epochs: ${training[0]} ms`);
  await demo.by('command').fill('go to the blue room');
  // The page comes to rest before it is asked.
  await new Promise((resolve) => setTimeout(resolve, 1000));
  const [answered, drawn] = await taken(demo.page, 'ask', 'plan');
  t.note(`a command parsed, grounded and planned: ${answered} ms; on the screen: ${drawn} ms`);
  const [loaded, bytes] = await demo.page.evaluate(() => {
    const resources = performance.getEntriesByType('resource');
    return [performance.getEntriesByType('navigation')[0].duration,
      resources.reduce((sum, entry) => sum + entry.decodedBodySize, 0)];
  });
  t.note(`the page: ${loaded.toFixed(0)} ms, ${(bytes / 1e6).toFixed(1)} MB before compression, renderer included`);
});
