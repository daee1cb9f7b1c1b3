// Questions are answered from the world; what lies beyond the language is named; suggestions are of the seed and the room;
// and a place says what can be said.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

flow('questions are answered from the world', async (t) => {
  const demo = await openPage(t);
  const cases = [
    ['where is the block?', /yellow block is in the red room/],
    ['where are you?', /robot is in the green room/],
    ['what is in the red room?', /red room: yellow block/],
    ['is the block in the red room?', /^Yes/],
    ['is the yellow block in the blue room?', /^No/],
    ['are you in the green room?', /^Yes/],
    ['how many rooms are there?', /^3:/],
    ['how many doors are there?', /^[234]: column \d/],
    ['where is the chair?', /no chair/],
    ['what can you do?', /bring things/],
    ['why are you here?', /cannot tell/],
  ];
  for (const [question, wanted] of cases) {
    await demo.by('command').fill(question);
    await demo.press('ask');
    await t.check(async () => (await demo.by('reply').count()) > 0 && wanted.test(await demo.by('reply').textContent()),
      async () => `${question}: ${(await demo.by('answer').allTextContents()).join(' ')}`);
    await demo.says(wanted);
  }
  await demo.by('command').fill('where is the block?');
  await demo.press('ask');
  await t.accessible('an answer');
  await t.shot('question');
  await demo.by('language').selectOption('de');
  await demo.press('ask');
  await demo.says(/gelbe Block ist im roten Raum/);
});

flow('what lies beyond the language is named as such', async (t) => {
  const demo = await openPage(t);
  for (const [command, wanted] of [
    ['move three steps to the blue room', /do not count|steps/],
    ['put the block between the red room and the blue room', /between/],
    ['if the block is in the red room go to the blue room', /conditions/],
    ['turn north', /directions/],
    ['open the door', /go somewhere/],
    ['put the block next to the door', /a door is a place/],
  ]) {
    await demo.ask(command);
    const why = () => demo.by('why').allTextContents();
    await t.check(async () => (await demo.why()).includes('beyond') && wanted.test((await why()).join(' ')),
      async () => `${command}: ${await why()}`);
  }
  await t.shot('beyond');
});

flow('only words that the room knows are suggested', async (t) => {
  const demo = await openPage(t);
  for (const [command, what] of [['hello', 'a greeting'], ['go to the tael room', 'a colour that is not there']]) {
    await demo.ask(command);
    await t.equal(() => demo.page.locator('[data-testid="help"][data-help="say"]').allTextContents(), [], what);
  }
});

flow('the guide says what can be said, with examples to press', async (t) => {
  const demo = await openPage(t);
  await demo.press('view-help');
  await demo.by('example').first().waitFor();
  await t.accessible('the guide');
  await t.fits('the guide');
  await t.shot('guide');
  await demo.by('example').filter({ hasText: 'put the yellow block in the blue room' }).first().click();
  await demo.by('answer').waitFor();
  await demo.planned();
  await demo.page.goBack();
  await demo.by('example').first().waitFor();
  await demo.by('language').selectOption('de');
  await demo.page.getByText('Was er versteht').waitFor();
});
