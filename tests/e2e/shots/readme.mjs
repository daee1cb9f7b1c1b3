// The README's picture, taken of the real page. Run by `make shots`.

import path from 'node:path';
import { flow } from '../flow.mjs';
import { root } from '../packages.mjs';
import { openTrain } from '../page.mjs';

flow('the page after “go to the blue room”', { viewport: { width: 1180, height: 900 } }, async (t) => {
  const demo = await openTrain(t);
  await demo.train();
  await demo.ask('go to the blue room');
  await demo.played();
  await demo.page.evaluate(() => scrollTo(0, 0));
  await demo.page.screenshot({ path: path.join(root, 'www/guide/page.png') });
});
