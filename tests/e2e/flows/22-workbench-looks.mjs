// How every part of the workbench looks, wide and light, and on a phone in the dark; each is all there for whoever uses
// no mouse and no eyes.

import { flow } from '../flow.mjs';
import { openTrain } from '../page.mjs';

const LOOKS = [
  ['wide', { width: 1440, height: 900 }, 'light'],
  ['phone', { width: 390, height: 844 }, 'dark'],
];

for (const [name, viewport, colorScheme] of LOOKS) {
  flow(`every part of the workbench as it looks, ${name} and ${colorScheme}`, { viewport, colorScheme }, async (t) => {
    const demo = await openTrain(t);
    const look = async (part) => {
      await demo.part(part);
      await demo.redrawn();
      await demo.page.evaluate(() => { document.activeElement.blur(); scrollTo(0, 0); });
      await demo.page.mouse.move(0, 0);
      await t.golden(`bench-${part}-${name}`, demo.page.locator('#workbench'), { share: 0.02 });
      await t.fits(part);
      await t.accessible(part);
    };
    await demo.by('split-percent').fill('50');
    await demo.by('split-percent').blur();
    await demo.by('split-by').selectOption({ label: 'single rows' });
    await demo.press('split-share');
    await t.check(async () => /held out/.test(await demo.by('corpus-count').textContent()), 'a share is held out');
    await look('kept');
    await look('study');
    await look('experiments');
    await demo.part('run');
    await demo.passes(6);
    // From here on the model is the flow's own, and not the one that comes with the page, which changes now and then.
    await demo.train();
    await look('run');
    await demo.part('data');
    await demo.press('audit');
    await demo.says(/Every row is judged/);
    await demo.page.locator('#row-0 .said').click();
    await demo.by('row-readings').waitFor();
    await look('data');
    await look('lexicon');
  });
}

flow('all of the workbench is reached by keyboard', async (t) => {
  const demo = await openTrain(t);
  await demo.by('tab-data').focus();
  for (const part of ['run', 'experiments', 'lexicon', 'study', 'kept', 'data']) {
    await demo.page.keyboard.press('ArrowRight');
    await t.check(async () => (await demo.by(`tab-${part}`).getAttribute('aria-selected')) === 'true', part);
  }
  await demo.page.keyboard.press('ArrowRight');
  await demo.by('train').waitFor();
  await demo.redrawn();
  await demo.reach('train');
  await demo.page.keyboard.press('Enter');
  await t.until('it has trained', async () =>
    (await demo.by('trained').count()) > 0 && /trained here/.test(await demo.by('trained').textContent()));
  await demo.reach('save-model');
  await demo.by('tab-run').focus();
  await demo.page.keyboard.press('ArrowRight');
  await demo.by('six-sentences').waitFor();
  await demo.redrawn();
  await demo.reach('six-sentences');
  await demo.page.keyboard.press('Enter');
  await demo.by('six-found').waitFor();
  await demo.by('tab-experiments').focus();
  for (const part of ['lexicon', 'study', 'kept']) {
    await demo.page.keyboard.press('ArrowRight');
    await t.check(async () => (await demo.by(`tab-${part}`).getAttribute('aria-selected')) === 'true', part);
  }
  await demo.by('kept-name').waitFor();
  await demo.redrawn();
  await demo.reach('kept-name');
  await demo.page.keyboard.type('by keyboard');
  await demo.reach('keep-model');
  await demo.page.keyboard.press('Enter');
  await demo.says(/“by keyboard” is kept/);
  await demo.reach('shelf-delete');
  await demo.page.keyboard.press('Enter');
  await demo.says(/is deleted/);
});
