// How the page that asks looks: consent, the instructions with their example, a task of pairs, a run that is played, and
// the end, on a desk and on a phone, light and dark; and a run in a pair's place, as one takes part in it.

import { writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { answersOf, host, makeStudy, takePart } from '../collect.mjs';
import { flow } from '../flow.mjs';

const TASK = 'task to-bag\nsays Go to the bag.\ngoal (near:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> bag:<e,t>))\nthing any bag\n';

/** A study of runs: the way to a bag, twice. */
async function runs(t) {
  const tasks = path.join(os.tmpdir(), `groundling-${process.pid}-tasks.txt`);
  await writeFile(tasks, TASK);
  return makeStudy(t, { asked: 1, shown: 2, ends: ['file'] }, ['--tasks', tasks, '--pairs', '2', '--ways']);
}

for (const [name, viewport] of [['desk', { width: 1280, height: 800 }], ['phone', { width: 390, height: 844 }]]) {
  for (const colorScheme of ['light', 'dark']) {
    flow(`taking part as it looks, ${name} and ${colorScheme}`, { viewport, colorScheme, reducedMotion: 'reduce' }, async (t) => {
      await host(t, await makeStudy(t, { asked: 1, ends: ['code', 'file'] }));
      await host(t, await runs(t), 'runs.json');
      const person = await takePart(t, '?study=study.json&participant=anna');
      const look = async (part) => {
        await person.page.evaluate(() => { document.activeElement.blur(); scrollTo(0, 0); });
        await person.page.mouse.move(0, 0);
        await t.golden(`collect-${part}-${name}-${colorScheme}`, person.page.locator('html'), { share: 0.01 });
        await t.fits(part);
        await t.accessible(`${part}, ${name}, ${colorScheme}`);
      };
      await person.at('welcome');
      await look('consent');
      await person.press('agree');
      await person.at('instructions');
      await look('instructions');
      await person.press('ready');
      await person.at('turn');
      await person.press('change-1');
      await look('item');
      await person.answer('go to the red room');
      await person.at('end');
      await look('end');
      await person.page.goto(`${t.address}collect.html?study=runs.json&participant=anna`);
      await person.begin();
      await person.press('step-1');
      await look('run');
    });
  }
}

flow('a run takes a pair’s place, and is played to its end', async (t) => {
  await host(t, await runs(t));
  const person = await takePart(t);
  await person.at('welcome');
  await person.press('agree');
  await person.at('instructions');
  await t.check(async () => /Play each of them to its end/.test(await person.page.locator('.card').textContent()), 'what to do');
  await person.press('ready');
  await person.at('turn');
  await t.equal(() => person.page.locator('.picture').count(), 2, 'a picture of each');
  const shown = (at) => person.page.locator('figcaption').nth(at).textContent();
  const [, steps] = /^Step 0 of (\d+)$/.exec(await shown(0));
  await t.check(Number(steps) >= 2, `${steps} steps`);
  await person.press('play-1');
  await t.equal(() => person.by('play-1').textContent(), 'Pause', 'it plays');
  await t.until('it is at its end', async () => (await shown(0)) === `Step ${steps} of ${steps}`);
  await t.equal(() => person.by('play-1').textContent(), 'Play', 'and rests');
  await t.check(() => person.by('step-1').isDisabled(), 'there is no more of it');
  // The other one a step at a time, by keyboard.
  await person.by('step-2').focus();
  while (!(await person.by('step-2').isDisabled())) await person.page.keyboard.press('Enter');
  await t.check(async () => /robot/.test(await person.page.locator('.changed').nth(1).textContent()), 'what changed is said');
  await t.accessible('a run at its end');
  await person.page.waitForTimeout(1100);
  await person.answer('go to the bag');
  await person.at('end');
  const [answer] = answersOf(await person.saved('end'));
  await t.equal([answer.runs.length, answer.pairs ?? 'none', Object.keys(answer.runs[0])], [2, 'none', ['start', 'actions']], 'as a corpus has it');
  await t.check(answer.care.seen_ms.every((ms) => ms > 0), 'both were seen');
});
