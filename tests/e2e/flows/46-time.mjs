// Goals in time: steps one after the other with a room that is never entered, carried out; one for which there is no way,
// explained and relaxed; one that is broken from the beginning.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

/** Four rooms in a ring; the robot stands in the green one. */
const RING = `#############
#rrrrr#bbbbb#
#rrrrr+bbbbb#
#rrrrr#bbbbb#
###a#####c###
#ggggg#yyyyy#
#g<gggdyyyyy#
#ggggg#yyyyy#
#############

r room red
b room blue
g room green
y room yellow
+ door unlocked
a door unlocked
c door unlocked
d door unlocked
`;

/** The same without the door between the red and the blue room. */
const OPEN = RING.replace('rrrrr+bbbbb', 'rrrrr#bbbbb').replace('+ door unlocked\n', '');

/** Opens the page in a world. */
async function openIn(t, world) {
  const demo = await openPage(t);
  await demo.mode('edit');
  await demo.page.locator('summary', { hasText: 'Random' }).click();
  await demo.press('world-text');
  await demo.by('drawing').fill(world);
  await demo.press('apply-text');
  await demo.mode('watch');
  return demo;
}

const steps = (demo) => demo.page.locator('[data-testid="step"]').evaluateAll((all) =>
  all.map((one) => `${one.dataset.stand}: ${one.textContent}`));
const forbidden = (demo) => demo.page.locator('.forbidden').count();

/** How many actions the plan has. */
const length = async (demo) => Number(await demo.by('plan').getAttribute('data-steps'));

/** The rooms that the robot is in from step to step. */
async function rooms(demo) {
  const all = [];
  const last = await length(demo);
  for (let step = 0; step <= last; step += 1) {
    await demo.seek(step);
    const { room } = await demo.robot();
    if (room && room !== all.at(-1)) all.push(room);
  }
  return all;
}

flow('one room after the other, and one never: said, shown, done, undone', async (t) => {
  const demo = await openIn(t, RING);
  await demo.ask('go to the blue room and then to the red room but never enter the yellow room');
  await t.equal(() => demo.plain(), 'I will go to the blue room, then go to the red room, but never enter the yellow room.', 'what it understood');
  await t.equal(() => demo.by('never').allTextContents(), ['never: the yellow room'], 'what is forbidden');
  await t.check(async () => (await forbidden(demo)) >= 15, async () => `${await forbidden(demo)} cells are hatched`);
  await demo.seek(0);
  await t.equal(() => steps(demo), ['next: the blue room', 'later: the red room'], 'the first step is next');
  await t.equal(() => rooms(demo), ['green', 'red', 'blue', 'red'], 'the way');
  await t.equal(() => steps(demo), ['done: the blue room', 'done: the red room'], 'all is done');
  await t.accessible('a task over time');
  await demo.seek(Math.floor((await length(demo)) * 0.7));
  await t.shot('time');
  await demo.deepen('see');
  await t.shot('time-values');
  await demo.ask('go to the yellow room');
  await demo.by('undo').click();
  await t.equal(() => demo.by('never').allTextContents(), ['never: the yellow room'], 'what was said before is back');
});

flow('where a demand leaves no way it is named, and what is meant can be done without', async (t) => {
  const demo = await openIn(t, OPEN);
  await demo.ask('go to the blue room but never enter the yellow room');
  await t.equal(() => demo.why(), ['blocked'], 'why nothing is done');
  await t.accessible('a task without a way');
  await t.shot('time-blocked');
  await demo.help('instead').click();
  await t.until('there is a plan', async () => (await demo.by('plan').count()) > 0);
  await t.equal(() => rooms(demo), ['green', 'yellow', 'blue'], 'the way without');
  await t.equal(() => demo.why(), [], 'nothing is wrong any more');
});

flow('what is broken from the beginning is done once that is over', async (t) => {
  const demo = await openIn(t, RING);
  await demo.ask('go to the blue room but never enter the green room');
  await t.equal(() => demo.why(), ['already_broken'], 'why nothing is done');
  await demo.help('instead').click();
  await t.until('there is a plan', async () => (await demo.by('plan').count()) > 0);
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'where the robot is');
});
