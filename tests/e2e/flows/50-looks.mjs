// How it looks: narrow, wide and dark windows, every depth and mode; no view is wider than its window, and axe finds
// nothing in any.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

for (const [name, settings] of [
  ['390', { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2 }],
  ['1600', { viewport: { width: 1600, height: 1000 } }],
  ['dark', { colorScheme: 'dark' }],
]) {
  flow(`every view at its sizes and colours: ${name}`, settings, async (t) => {
    const demo = await openPage(t);
    const look = async (view) => {
      await t.fits(`${view}, ${name}`);
      await t.accessible(`${view}, ${name}`);
      await t.shot(`${view}-${name}`);
    };
    await look('first');
    await demo.ask('put the yellow block in the biggest room');
    await demo.finish();
    await look('say');
    await demo.deepen('see');
    await demo.seek(0);
    await t.until('the values', async () => (await demo.by('legend').count()) > 0);
    await look('see');
    await demo.deepen('study');
    await demo.by('features').waitFor();
    await look('study');
    await demo.deepen('say');
    await demo.mode('edit');
    await demo.press('tool-object');
    await demo.page.locator('summary').first().click();
    await look('edit');
    await demo.mode('teach');
    await look('teach');
    await demo.press('share');
    await demo.by('shared').waitFor();
    await look('share');
    await demo.workbench();
    await look('train');
  });
}
