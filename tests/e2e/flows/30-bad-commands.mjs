// Commands that come to nothing: each is answered where the person types, by its kind, and the next
// command works.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

/** Commands, the kind of the answer, and what its words must hold. */
const COMMANDS = [
  ['two hundred words', 'go to the blue room '.repeat(40), 'too_long', /more than 50/],
  ['nothing', '   ', 'empty', /no word/i],
  ['emoji', '🤖🚪🟦', 'empty', /no word/i],
  ['a word that nothing is left without', 'fetch my slippers', 'unknown_words', /slippers/],
  ['a word that is left out', 'go to the frobly room', 'unknown_words', /frobly[^]*left that out/],
  ['markup', '<img src=x onerror=alert(1)> room', 'unknown_words', /onerror/],
  ['a phrase that names nothing', 'go to the yellow room', 'no_referent', /no yellow room/],
];

flow('commands that come to nothing', async (t) => {
  const demo = await openPage(t);
  const before = await demo.robot();
  for (const [what, command, kind, words] of COMMANDS) {
    await demo.ask(command);
    await t.check(async () => (await demo.why()).includes(kind), async () => `${what}: ${kind} in ${await demo.why()}`);
    const why = demo.page.locator(`[data-testid="why"][data-kind="${kind}"]`);
    await t.check(async () => words.test(await why.textContent()), async () => `${what}: ${words} in: ${await why.textContent()}`);
    await t.check(() => why.isVisible(), `${what}: the message is in sight`);
    await t.equal(() => demo.robot(), before, `${what}: where the robot stays`);
    await t.fits(what);
  }
  await demo.ask('go to the blue room');
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'the next command works');
});

flow('words that do not fit together, with a parser that does not guess', async (t) => {
  const demo = await openPage(t);
  await demo.workbench();
  await demo.train();
  await demo.talk();
  await demo.ask('room the to the go');
  await t.check(async () => (await demo.why()).includes('no_parse'), async () => `no_parse in ${await demo.why()}`);
  await t.equal(() => demo.help('teach').count(), 1, 'help');
});
