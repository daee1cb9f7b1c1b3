// Changing the room: every tool by mouse, one by keys; random rooms by their seed; a room as text, out and in.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

flow('every tool changes the room, and says what is in the way', async (t) => {
  const demo = await openPage(t);
  const holds = async (pattern) => t.check(async () => pattern.test(await demo.world()), async () => `${pattern} in: ${await demo.world()}`);
  const refused = async (pattern) => {
    await demo.by('obstacle').waitFor();
    await t.check(async () => pattern.test(await demo.by('obstacle').textContent()), () => demo.by('obstacle').textContent());
  };
  await demo.mode('edit');
  await demo.drag([8, 6], [8, 2]);
  await holds(/yellow block in the green room/);
  await demo.tap([6, 2]);
  await holds(/facing south/);
  await demo.drag([6, 2], [8, 2]);
  await refused(/Something stands there/);

  await demo.press('tool-object');
  await demo.by('look-shape').selectOption('chair');
  await demo.by('look-color').selectOption('red');
  await demo.tap([2, 2]);
  await holds(/red chair in the blue room/);
  await demo.tap([4, 0]);
  await refused(/no floor/);

  await demo.press('tool-erase');
  await demo.tap([6, 6]);
  await holds(/Rooms: blue and green\./);
  await demo.tap([2, 2]);
  await t.check(async () => !/chair/.test(await demo.world()), 'the chair is gone');
  await demo.tap([6, 2]);
  await refused(/robot stays/);

  await demo.press('tool-room');
  await demo.by('paint').selectOption('teal');
  await demo.drag([4, 4], [10, 8]);
  await holds(/Rooms: blue, green and teal\./);
  await demo.tap([2, 6]);
  await holds(/Rooms: teal, green and teal\./);
  await demo.drag([4, 4], [5, 5]);
  await refused(/drag further/);

  await demo.press('tool-door');
  for (const lock of ['untried', 'locked']) {
    if (lock === 'untried') await demo.tap([8, 4]);
    await demo.tap([8, 4]);
    await demo.says(new RegExp(`door at column 8, row 4 is ${lock}`));
  }
  await demo.tap([0, 0]);
  await refused(/door needs a wall/);
  await t.accessible('a room that is changed');
  await demo.press('reset-world');
  await holds(/Rooms: blue, red and green\..*yellow block in the red room/);
});

flow('the keyboard alone carries a thing to another room', async (t) => {
  const demo = await openPage(t);
  await demo.reach('mode-edit');
  await demo.page.keyboard.press('Enter');
  await demo.reach('room');
  await demo.keys('ArrowRight', 'ArrowRight', ...Array(4).fill('ArrowUp'));
  await demo.says(/yellow block/);
  await demo.keys('Enter');
  await demo.says(/Holding the yellow block/);
  await demo.keys(...Array(6).fill('ArrowLeft'), 'Enter');
  await demo.says(/yellow block is now in the blue room/);
  await demo.keys('Escape');
});

flow('random rooms are those of their seed', async (t) => {
  const demo = await openPage(t);
  await demo.mode('edit');
  await demo.page.locator('summary', { hasText: 'Random' }).click();
  const draw = async (seed) => {
    const before = await demo.world();
    await demo.by('world-seed').fill(`${seed}`);
    await demo.press('draw-world');
    await t.until('another room', async () => (await demo.world()) !== before);
    return demo.world();
  };
  const seven = await draw(7);
  await demo.by('world-rooms').fill('5');
  await demo.by('world-columns').fill('15');
  const eight = await draw(8);
  await t.check(/Rooms: \w+, \w+, \w+, \w+ and \w+\./.test(eight), `five rooms: ${eight}`);
  await demo.by('world-rooms').fill('3');
  await demo.by('world-columns').fill('9');
  await t.equal(await draw(7), seven, 'the room of seed 7');
});

flow('a room goes out as text and comes back; bad text is refused in place', async (t) => {
  const demo = await openPage(t);
  await demo.mode('edit');
  await demo.page.locator('summary', { hasText: 'Random' }).click();
  await demo.press('world-text');
  const drawing = demo.by('drawing');
  await drawing.waitFor();
  const text = await drawing.inputValue();
  const before = await demo.world();
  for (const [bad, message] of [['', /./], ['hello', /line 1/], [text.replace('block yellow', 'sofa yellow'), /sofa/]]) {
    await drawing.fill(bad);
    await demo.press('apply-text');
    await demo.by('world-notice').waitFor();
    await t.until(`${message}`, async () => message.test(await demo.by('world-notice').textContent()));
    await t.equal(() => demo.world(), before, 'the room');
    await t.equal(() => drawing.inputValue(), bad, 'the text stays to be mended');
  }
  await drawing.fill(text.replace('block yellow', 'chair orange'));
  await demo.press('apply-text');
  await t.until('the room of the text', async () => /orange chair in the red room/.test(await demo.world()));
  await demo.press('undo');
  await t.equal(() => demo.world(), before, 'undone');
});
