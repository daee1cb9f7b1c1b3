// The keyboard alone, from the first Tab to a plan that was played; and the page in German.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

flow('the keyboard alone asks, plays and steps', async (t) => {
  const demo = await openPage(t);
  const { keyboard } = demo.page;
  await t.equal(() => demo.page.evaluate(() => document.activeElement.id), 'command', 'where one begins');
  await demo.reach('view-talk');
  await keyboard.press('Shift+Tab');
  await t.equal(() => demo.page.evaluate(() => document.activeElement.className), 'skip', 'before all else');
  await keyboard.press('Enter');
  await demo.reach('command');
  await keyboard.type('go to the blue room');
  await keyboard.press('Enter');
  await demo.by('plan').waitFor();
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'where the robot ends');
  await demo.reach('plan-first');
  await keyboard.press('Enter');
  await t.until('back at the start', async () => (await demo.by('plan').getAttribute('data-at')) === '0');
});

flow('the page speaks German where the browser does', { locale: 'de-DE' }, async (t) => {
  const demo = await openPage(t);
  await t.equal(() => demo.page.locator('html').getAttribute('lang'), 'de', 'the language');
  await demo.ask('go to the blue room');
  await demo.finish();
  await t.equal(() => demo.plain(), 'Ich werde in den blauen Raum gehen.', 'in plain words');
  await t.accessible('the page in German');
  await t.fits('the page in German');
  await t.shot('german');
  await demo.by('language').selectOption('en');
  await t.equal(() => demo.plain(), 'I will go to the blue room.', 'in English');
});
