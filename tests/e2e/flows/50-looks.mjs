// How it looks and moves: narrow, wide and dark windows, reduced motion, the keyboard alone.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

for (const [name, settings] of [
  ['390', { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2 }],
  ['1600', { viewport: { width: 1600, height: 1000 } }],
  ['dark', { colorScheme: 'dark' }],
]) {
  flow(`the page at its sizes and colours: ${name}`, settings, async (t) => {
    const demo = await openPage(t);
    await t.fits(`the first view, ${name}`);
    await t.shot(`first-${name}`);
    await demo.train();
    await demo.ask('go to the blue room');
    await demo.played();
    await t.fits(`an answer, ${name}`);
    await t.accessible(`an answer, ${name}`);
    await t.shot(`answer-${name}`);
  });
}

flow('the keyboard alone trains, asks and steps', async (t) => {
  const demo = await openPage(t);
  const focused = () => demo.page.evaluate(() => document.activeElement?.getAttribute('data-testid'));
  const reach = async (id) => {
    for (let presses = 0; presses < 60; presses += 1) {
      if ((await focused()) === id) return;
      await demo.page.keyboard.press('Tab');
    }
    throw new Error(`Tab never reaches ${id}`);
  };
  await reach('train');
  await demo.page.keyboard.press('Enter');
  await demo.by('trained').waitFor();
  await reach('command');
  await demo.page.keyboard.type('go to the blue room');
  await demo.page.keyboard.press('Enter');
  await demo.by('plan').waitFor();
  await demo.played();
  t.equal((await demo.robot()).place, 'the blue room', 'where the robot ends');
  await reach('plan-first');
  await demo.page.keyboard.press('Enter');
  t.equal(await demo.by('plan').getAttribute('data-at'), '0', 'back at the start');
});
