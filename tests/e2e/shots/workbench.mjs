// The pictures of the workbench's guide, taken of the real page. Run by `make shots`.

import path from 'node:path';
import { flow } from '../flow.mjs';
import { root } from '../packages.mjs';
import { csv, openTrain, rows } from '../page.mjs';

/** Ways of saying a command; some hold a word that nobody knows before. */
const WAYS = ['go', 'please go', 'scoot', 'amble', 'trot', 'kindly scoot', 'now amble', 'please trot', 'robot, scoot', 'go now', 'just amble', 'do trot'];

/** A corpus of one's own: the six, in twelve ways. */
const OWN = csv(...WAYS.flatMap((way) => rows.slice(1).map(
  (row) => (way === 'go' ? row : row.replace(/"(?:go|walk) ([^"]*)"(?=,[^,]*,[^,]*$)/, `"${way} $1"`)),
)));

flow('the workbench, step by step', { gpu: true, viewport: { width: 1280, height: 860 } }, async (t) => {
  const demo = await openTrain(t);
  const take = async (name) => {
    await demo.redrawn();
    await demo.page.mouse.move(0, 0);
    await demo.page.evaluate(() => { document.activeElement.blur(); scrollTo(0, 0); });
    await demo.page.waitForTimeout(500);
    await demo.page.screenshot({ path: path.join(root, `www/guide/workbench-${name}.png`) });
  };
  await demo.choose('kitchen.csv', OWN);
  await t.until('it is open', async () => (await demo.corpus()).name === 'kitchen.csv');
  await demo.by('split-percent').fill('25');
  await demo.by('split-percent').blur();
  await demo.press('split-share');
  await demo.press('audit');
  await demo.says(/Every row is judged/);
  await demo.page.locator('#row-1 .said').click();
  await demo.by('row-readings').waitFor();
  await take('data');
  await demo.part('run');
  await demo.passes(6);
  await demo.train();
  await take('train');
  await demo.part('experiments');
  await demo.by('folds').fill('3');
  await demo.by('folds').blur();
  await demo.press('run');
  await demo.by('runs').waitFor({ timeout: 120_000 });
  await take('experiments');
  await demo.part('data');
  await demo.press('audit');
  await demo.says(/Every row is judged/);
  await demo.part('lexicon');
  await take('lexicon');
  await demo.part('kept');
  await demo.by('kept-name').fill('kitchen, first model');
  await demo.press('keep-model');
  await demo.says(/is kept/);
  await take('kept');
});
