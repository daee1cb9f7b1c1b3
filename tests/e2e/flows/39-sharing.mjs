// Sharing: a link or a file brings back the room, its rules, what was said, which reading was meant, and what was
// taught; a damaged one changes nothing and says so.

import { flow } from '../flow.mjs';
import { openElsewhere, openPage } from '../page.mjs';

/** A page that taught and said something, and chose the second reading. */
async function busy(t) {
  const demo = await openPage(t);
  await demo.mode('teach');
  await demo.drag([8, 6], [2, 6]);
  await demo.by('lesson').fill('schlep the block to the blue room');
  await demo.press('teach');
  await demo.by('learned').waitFor();
  await demo.deepen('see');
  await demo.ask('take the block to the green room');
  await demo.reading('The object is in').click();
  await t.until('it is planned for', async () => (await demo.plain()) === 'I will bring the object into the green room.');
  await demo.finish();
  await demo.press('share');
  await demo.by('shared').waitFor();
  return demo;
}

/** What is to be seen of it. */
async function seen(demo) {
  return { plain: await demo.plain(), world: await demo.world(), command: await demo.by('command').inputValue(),
    lessons: await demo.by('lesson-try').allTextContents() };
}

/** Waits until another page shows the same. */
async function same(t, demo, other) {
  await demo.redrawn();
  const wanted = await seen(demo);
  await t.until('the second reading', async () => (await other.plain()) === wanted.plain);
  await other.finish();
  await t.equal(() => seen(other), wanted, 'what came over');
}

flow('a link brings everything to a fresh browser', async (t) => {
  const demo = await busy(t);
  await demo.by('link').waitFor();
  await t.check(async () => (await demo.by('link').inputValue()).startsWith(`${t.address}#s=`), 'the link is of this page');
  const link = await demo.by('link').inputValue();
  t.note(`the link has ${link.length} characters`);
  await openElsewhere(t, link, async (other) => {
    await same(t, demo, other);
  });
});

flow('a file brings everything back, dropped on the page', async (t) => {
  const demo = await busy(t);
  const session = await demo.saved('save-session');
  const other = await openPage(t);
  await other.drop('groundling.json', session);
  await same(t, demo, other);
});

flow('damaged links and files say so, and change nothing', async (t) => {
  const demo = await openPage(t);
  const before = await demo.world();
  for (const hash of ['#s=', '#s=%%%', '#s=AAAA', `#s=${'A'.repeat(20_000)}`]) {
    await demo.page.evaluate((to) => { location.hash = to; }, hash);
    await demo.by('link-notice').waitFor();
    await t.check(async () => /cannot be opened/.test(await demo.by('link-notice').textContent()), hash.slice(0, 9));
    await t.equal(() => demo.world(), before, 'the room');
    await demo.press('close-share');
  }
  for (const session of ['{"groundling-session":99}', '{"groundling-session":1,"world":{}}']) {
    await demo.drop('groundling.json', session);
    await demo.by('link-notice').waitFor();
    await t.equal(() => demo.world(), before, 'the room');
    await demo.press('close-share');
  }
  await t.accessible('after damaged links');
});
