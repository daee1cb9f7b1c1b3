// Goals in time: steps one after the other with a room that is never entered, carried out; one for which there is no way,
// explained and relaxed; one that is broken from the beginning.

import { flow } from '../flow.mjs';
import { RING, openElsewhere, openIn } from '../page.mjs';

/** The same without the door between the red and the blue room. */
const OPEN = RING.replace('rrrrr+bbbbb', 'rrrrr#bbbbb').replace('+ door unlocked\n', '');

const steps = (demo) => demo.page.locator('[data-testid="step"]').evaluateAll((all) =>
  all.map((one) => `${one.dataset.stand}: ${one.textContent}`));
const forbidden = (demo) => demo.page.locator('.forbidden').count();

/** How many actions the plan has. */
const length = async (demo) => Number(await demo.by('plan').getAttribute('data-steps'));

flow('one room after the other, and one never: said, shown, done, undone', async (t) => {
  const demo = await openIn(t, RING);
  await demo.ask('go to the blue room and then to the red room but never enter the yellow room');
  await t.equal(() => demo.plain(), 'I will go to the blue room, then go to the red room, but never enter the yellow room.', 'what it understood');
  await t.equal(() => demo.by('never').allTextContents(), ['never: the yellow room'], 'what is forbidden');
  await t.check(async () => (await forbidden(demo)) >= 15, async () => `${await forbidden(demo)} cells are hatched`);
  await demo.seek(0);
  await t.equal(() => steps(demo), ['next: the blue room', 'later: the red room'], 'the first step is next');
  await t.equal(() => demo.rooms(), ['green', 'red', 'blue', 'red'], 'the way');
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
  await t.equal(() => demo.rooms(), ['green', 'yellow', 'blue'], 'the way without');
  await t.equal(() => demo.why(), [], 'nothing is wrong any more');

  const link = await demo.link();
  await openElsewhere(t, link, async (other) => {
    await t.until('there is a plan', async () => (await other.by('plan').count()) > 0);
    await t.equal(() => other.plain(), await demo.plain(), 'what is done instead comes over');
    await t.equal(() => other.rooms(), ['green', 'yellow', 'blue'], 'and its way');
  });
});

flow('a robot that is carried where it may not be stops and asks; carried elsewhere it goes on', async (t) => {
  const demo = await openIn(t, RING);
  await demo.ask('go to the blue room but never enter the yellow room');
  await demo.planned();
  await demo.seek(2);
  await demo.drag([3, 3], [9, 2]);
  await demo.by('moved-keep').click();
  await t.equal(() => demo.why(), ['broken'], 'why it stopped');
  await t.accessible('a task that was broken');
  await t.shot('time-carried');
  await demo.help('instead').click();
  await demo.planned();
  await t.equal(() => demo.rooms(), ['yellow', 'blue'], 'out of there, and not again');

  await demo.press('reset-world');
  await demo.ask('go to the red room and then to the blue room');
  await demo.planned();
  await demo.seek(4);
  await t.equal(async () => (await demo.robot()).room, 'red', 'the first step is done');
  await demo.drag([3, 5], [2, 2]);
  await demo.by('moved-keep').click();
  await demo.planned();
  await t.check(async () => (await steps(demo))[0] === 'done: the red room', async () => `${await steps(demo)}`);
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'it goes on');
});

flow('a robot that is carried where it may not be once more asks once more', async (t) => {
  const demo = await openIn(t, RING);
  await demo.ask('go to the blue room and then to the red room but never enter the yellow room');
  await demo.planned();
  await demo.seek(2);
  for (const time of ['once', 'once more']) {
    const { x, y } = await demo.robot();
    await demo.drag([x, y], [9, 2]);
    await demo.by('moved-keep').click();
    await t.equal(() => demo.why(), ['broken'], `it stops ${time}`);
    await demo.help('instead').click();
    await demo.planned();
    await t.equal(() => demo.why(), [], `it goes on ${time}`);
    await demo.seek(4);
  }
  await t.equal(() => demo.rooms(), ['yellow', 'blue', 'red'], 'out of there, and to both rooms');
});

flow('a task over time in German: its steps, what is forbidden, what stands in its way', async (t) => {
  const demo = await openIn(t, OPEN);
  await demo.by('language').selectOption('de');
  await demo.ask('go to the red room and then to the yellow room but never enter the blue room');
  await demo.planned();
  await t.equal(() => demo.plain(), 'Ich werde in den roten Raum gehen, dann in den gelben Raum gehen, aber nie in den blauen Raum gehen.', 'was er verstanden hat');
  await demo.seek(5);
  await t.equal(() => steps(demo), ['done: der rote Raum', 'next: der gelbe Raum'], 'the steps');
  await t.equal(() => demo.by('never').allTextContents(), ['nie: der blaue Raum'], 'what is forbidden');
  await t.shot('time-german');
  await demo.ask('go to the blue room but never enter the yellow room');
  await t.equal(() => demo.why(), ['blocked'], 'why nothing is done');
  await t.equal(() => demo.help('instead').textContent(), 'Ohne das tun: der Roboter ist nicht im gelben Raum', 'what can be done');
  await t.shot('time-german-blocked');
  await demo.help('instead').click();
  await t.until('there is a plan', async () => (await demo.by('plan').count()) > 0);
  await t.equal(() => demo.plain(), 'Ich werde in den blauen Raum gehen.', 'what is done instead');
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
