// The front page for who has ten seconds: what it looks like, what it does by itself, the commands that it offers, what
// is asked where one drags, and what is in sight at every size.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

const SIZES = { phone: [390, 844], desk: [1440, 900], wide: [1920, 1080] };

for (const colorScheme of ['light', 'dark']) {
  for (const [name, [width, height]] of Object.entries(SIZES)) {
    flow(`the first screen on a ${name}, ${colorScheme}`, { viewport: { width, height }, colorScheme }, async (t) => {
      const demo = await openPage(t);
      await t.until('drawn', async () => (await demo.by('stage').getAttribute('data-backend')) === 'webgl2');
      await demo.examples();
      await demo.page.evaluate(() => document.activeElement.blur());
      await demo.page.mouse.move(0, 0);
      await t.golden(`first-${name}-${colorScheme}`, demo.page.locator('html'), { share: 0.02 });
      await t.fits('the first screen');
      await t.accessible('the first screen');
      await t.equal(() => inSight(demo, ['stage', 'command', 'example-0']), [], 'what is out of sight');
    });
  }
}

/** Which of these are not wholly in the window, or lie under the command bar where that stays at the bottom. */
async function inSight(demo, ids) {
  const { width, height: whole } = demo.page.viewportSize();
  const bar = await demo.page.locator('.say.main').evaluate((it) => getComputedStyle(it).position === 'fixed' && it.getBoundingClientRect().top);
  const out = [];
  for (const id of ids) {
    const box = await demo.by(id).boundingBox();
    const height = bar && id !== 'command' ? bar : whole;
    if (!box || box.x < 0 || box.y < 0 || box.x + box.width > width + 1 || box.y + box.height > height + 1) out.push(id);
  }
  return out;
}

flow('the page does one command by itself, and stops at the first key', { reducedMotion: 'no-preference' }, async (t) => {
  const demo = await openPage(t);
  await t.until('it types', async () => /^put the y/.test(await demo.by('command').inputValue()));
  await demo.by('plan').waitFor();
  await t.equal(() => demo.by('command').inputValue(), 'put the yellow block in the biggest room', 'what it said');
  await t.until('it walks', async () => (await demo.by('plan').getAttribute('data-at')) !== '0');
  await demo.page.keyboard.press('Shift');
  await t.until('it stands still', async () => (await demo.by('plan').getAttribute('data-playing')) === 'false');
});

flow('who is quicker than the model is heard all the same', async (t) => {
  let come;
  const wait = new Promise((resolve) => { come = resolve; });
  await t.context.route(/cleanup[^/]*\.model/, async (route) => { await wait; await route.continue(); });
  await t.open();
  await t.page.getByTestId('command').fill('go to the blue room');
  await t.page.keyboard.press('Enter');
  await t.check(async () => /One moment/.test(await t.page.getByTestId('hello').textContent()), 'what it says meanwhile');
  come();
  await t.page.getByTestId('plan').waitFor();
  await t.equal(() => t.page.getByTestId('plain').textContent(), 'I will go to the blue room.', 'what it does then');
});

flow('what was typed by itself is gone before a key comes into the box', { reducedMotion: 'no-preference' }, async (t) => {
  const demo = await openPage(t);
  await t.until('it types', async () => /^put/.test(await demo.by('command').inputValue()));
  // A key's letter comes right behind its listeners, whenever the page is drawn.
  const left = await demo.by('command').evaluate((box) => {
    box.dispatchEvent(new KeyboardEvent('keydown', { key: 'g', bubbles: true }));
    return box.value;
  });
  if (left !== '') throw new Error(`left in the box: ${left}`);
});

flow('text that comes without a key takes the place of what was typed by itself', { reducedMotion: 'no-preference' }, async (t) => {
  const demo = await openPage(t);
  await t.until('it types', async () => /^put/.test(await demo.by('command').inputValue()));
  await demo.page.keyboard.insertText('go to the blue room');
  await t.equal(() => demo.by('command').inputValue(), 'go to the blue room', 'what stands in the box');
});

flow('a key while it types by itself, and the box is the person’s', { reducedMotion: 'no-preference' }, async (t) => {
  const demo = await openPage(t);
  await t.until('it types', async () => /^put/.test(await demo.by('command').inputValue()));
  await demo.page.keyboard.type('go');
  await t.equal(() => demo.by('command').inputValue(), 'go', 'what stands in the box');
  await demo.page.waitForTimeout(1500);
  await t.equal(() => demo.by('command').inputValue(), 'go', 'and stays there');
});

for (const [what, settings, hash] of [
  ['who prefers less motion', { reducedMotion: 'reduce' }, ''],
  ['who asks for a view', { reducedMotion: 'no-preference' }, '#talk'],
]) {
  flow(`nothing is done by itself for ${what}`, settings, async (t) => {
    const demo = await openPage(t, `${t.address}${hash}`);
    await demo.page.waitForTimeout(2500);
    await t.equal(() => demo.by('command').inputValue(), '', 'what stands in the box');
    await t.equal(() => demo.page.evaluate(() => document.activeElement.id), 'command', 'the focus');
  });
}

flow('what is offered can be done, in every room and after the dice', async (t) => {
  const demo = await openPage(t);
  let tried = 0;
  for (const world of [0, 1, 2, 'dice', 'dice']) {
    if (world === 'dice') {
      const shown = () => demo.by('stage').getByRole('img').getAttribute('aria-label');
      const before = await shown();
      await demo.press('dice');
      await t.until('other rooms', async () => (await shown()) !== before);
    } else await demo.by('world').selectOption({ index: world });
    const offered = await demo.examples();
    await t.check(offered.length >= 3, `offered in ${world}: ${offered}`);
    const can = offered.filter(([id]) => id !== 'example-5');
    const [at] = can.at(-1);
    await demo.press(at);
    await demo.answered('an example');
    await t.equal(() => demo.by('question').count(), 0, 'questions');
    await t.check(async () => (await demo.by('plan').count()) > 0, `no plan for ${can.at(-1)}`);
    tried += 1;
  }
  t.note(`${tried} examples were done`);
});

flow('the word that nobody knows leads to a lesson', async (t) => {
  const demo = await openPage(t);
  const offered = await demo.examples();
  await t.equal(offered[2], ['example-5', 'go to the dungeon'], 'what is there to be taught');
  await demo.press('example-5');
  await demo.answered('the example');
  await t.check(async () => (await demo.why()).includes('unknown_words'), async () => `${await demo.why()}`);
  await demo.help('teach').click();
  await t.equal(() => demo.by('lesson').inputValue(), 'go to the dungeon', 'the words of the lesson');
});

flow('what is dragged is asked about where it lies: moved, put back, taught', async (t) => {
  const demo = await openPage(t);
  const start = await demo.world();
  await demo.drag([8, 6], [2, 6]);
  await demo.by('moved').waitFor();
  await t.accessible('a question in the room');
  await demo.press('moved-back');
  await t.equal(() => demo.world(), start, 'put back');
  await demo.drag([8, 6], [2, 6]);
  await demo.press('moved-keep');
  await t.check(async () => /yellow block in the blue room/.test(await demo.world()), 'moved');
  await t.until('it can be undone', () => demo.by('undo').isEnabled());
  await demo.press('undo');
  await t.until('it is undone', async () => (await demo.world()) === start);
  await demo.drag([8, 6], [2, 6]);
  await demo.press('moved-teach');
  await t.equal(() => demo.by('mode-teach').getAttribute('aria-pressed'), 'true', 'it is a lesson');
  await t.check(async () => /yellow block in the blue room/.test(await demo.world()), 'what is shown');
  await demo.page.keyboard.type('stow the block in the blue room');
  await demo.page.keyboard.press('Enter');
  await demo.by('learned').waitFor();
});

flow('why, and how: the depths are asked for at the answer', async (t) => {
  const demo = await openPage(t);
  await demo.ask('go to the blue room');
  await demo.press('ask-why');
  await demo.by('reading').first().waitFor();
  await demo.press('show-grammar');
  await demo.by('study').waitFor();
  await demo.press('less');
  await t.equal(() => demo.by('reading').count(), 0, 'readings');
});

for (const [width, height] of [[390, 844], [720, 450], [1440, 900], [320, 640]]) {
  flow(`room and player are in sight after Enter at ${width} × ${height}`, { viewport: { width, height } }, async (t) => {
    const demo = await openPage(t);
    await demo.by('command').fill('put the yellow block in the biggest room');
    await demo.by('command').press('Enter');
    await demo.by('plan').waitFor();
    await t.until('room, player and answer are in sight', async () =>
      (await inSight(demo, ['stage', 'plan', 'understood', 'command'])).length === 0);
    await t.fits('a plan');
    await demo.ask(`go to the ${'a'.repeat(40)} room`);
    await t.fits('a word of forty letters');
    await demo.ask('put the yellow block in the biggest room');
    await demo.deepen('study');
    await demo.by('study').waitFor();
    await t.fits('as deep as it goes');
  });
}

flow('the room is larger in a larger window', { viewport: { width: 1440, height: 900 } }, async (t) => {
  const demo = await openPage(t);
  const area = async () => {
    const { width, height } = await demo.by('stage').boundingBox();
    return width * height;
  };
  const small = await area();
  await demo.page.setViewportSize({ width: 1920, height: 1080 });
  await t.check(async () => (await area()) > small * 1.2, 'the room has grown');
});

flow('a field can be emptied while one types', async (t) => {
  const demo = await openPage(t);
  await demo.mode('edit');
  await demo.page.locator('summary', { hasText: 'Random' }).click();
  const rooms = demo.by('world-rooms');
  await rooms.fill('3');
  await rooms.press('End');
  await rooms.press('Backspace');
  await rooms.press('8');
  await t.equal(() => rooms.inputValue(), '8', 'rooms');
});

flow('the model that reads is named, in German, too', { locale: 'de-DE' }, async (t) => {
  const demo = await openPage(t);
  await t.check(async () => /^Modell: das der Seite, \d+ Einträge$/.test(await demo.by('model-in-use').textContent()), 'the model');
  await t.check(async () => /blauer Raum/.test(await demo.by('stage').textContent()), 'the names of the rooms');
});

flow('without a GPU what moves is drawn plainly, which costs little in all processes together', { reducedMotion: 'no-preference', viewport: { width: 1440, height: 900 } }, async (t) => {
  const demo = await openPage(t, `${t.address}#talk`);
  await t.equal(() => demo.by('stage').getAttribute('data-backend'), 'webgl2', 'the first picture is drawn by');
  const browser = await demo.page.context().browser().newBrowserCDPSession();
  const cpu = async () => (await browser.send('SystemInfo.getProcessInfo')).processInfo.reduce((all, { cpuTime }) => all + cpuTime, 0) * 1000;
  await demo.ask('put the yellow block in the biggest room');
  await demo.by('plan').waitFor();
  await t.equal(() => demo.by('stage').getAttribute('data-backend'), 'svg', 'what changes is drawn by');
  await demo.seek(0);
  await demo.by('plan-speed').selectOption('1×');
  let before = await cpu();
  const begun = Date.now();
  await demo.press('plan-play');
  const at = (name) => demo.by('plan').getAttribute(name);
  await t.until('it is played', async () => (await at('data-at')) === (await at('data-steps')));
  const [spent, took] = [(await cpu()) - before, Date.now() - begun];
  // What the page costs while nothing moves (a caret that blinks is a frame, too).
  before = await cpu();
  await demo.page.waitForTimeout(took);
  const [steps, rest] = [Number(await at('data-steps')), (await cpu()) - before];
  t.note(`drawn by svg: ${(spent / steps).toFixed(0)} ms of CPU a step, all processes; at rest as long ${(rest / steps).toFixed(0)} ms`);
});
