// The README's pictures, taken of the real page. Run by `make shots`.

import path from 'node:path';
import { flow } from '../flow.mjs';
import { root } from '../packages.mjs';
import { openPage } from '../page.mjs';

const COMMAND = 'put the yellow block in the biggest room';

/** Where the README's pictures lie. */
const file = (name) => path.join(root, `www/guide/${name}.png`);

/** Goes to a step of the plan, with nothing pointed at, and waits until the page has come to rest. */
async function seek(demo, step) {
  await demo.by('plan-scrub').fill(`${step}`);
  await demo.t.until('it stands still', async () =>
    (await demo.by('stage').getAttribute('data-still')) === 'true');
  await demo.page.mouse.move(0, 0);
  await demo.page.evaluate(() => { document.activeElement.blur(); scrollTo(0, 0); });
  await demo.page.waitForTimeout(1000);
}

flow('say', { gpu: true, viewport: { width: 1280, height: 800 } }, async (t) => {
  const demo = await openPage(t);
  await demo.ask(COMMAND);
  await seek(demo, 5);
  await demo.page.screenshot({ path: file('page') });
});

flow('study, in the dark', { gpu: true, viewport: { width: 1280, height: 1000 }, colorScheme: 'dark' }, async (t) => {
  const demo = await openPage(t);
  await demo.deepen('study');
  await demo.ask('take the block to the green room');
  await demo.by('legend').waitFor();
  await demo.by('features').waitFor();
  await demo.press('reduce-all');
  await seek(demo, 3);
  await demo.page.screenshot({ path: file('page-values') });
  await demo.by('study').screenshot({ path: file('page-study') });
});

flow('a phone', { gpu: true, viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true }, async (t) => {
  const demo = await openPage(t);
  await demo.ask(COMMAND);
  await seek(demo, 5);
  await demo.page.screenshot({ path: file('page-phone') });
});

flow('the picture for who shares the address', { gpu: true, viewport: { width: 1200, height: 630 } }, async (t) => {
  const demo = await openPage(t);
  await demo.ask(COMMAND);
  await seek(demo, 5);
  await demo.page.screenshot({ path: path.join(root, 'www/card.png') });
});
