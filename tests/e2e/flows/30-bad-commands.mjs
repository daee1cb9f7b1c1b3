// Commands that come to nothing: each is answered where the person types, by its kind and with a remedy.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';

/** Commands, the kind of the answer, and what its words must hold. */
const COMMANDS = [
  ['two hundred words', 'go to the blue room '.repeat(40), 'too_long', /more than 50/],
  ['nothing', '   ', 'empty', /no word/i],
  ['emoji', '🤖🚪🟦', 'empty', /no word/i],
  ['nothing but words never seen', 'fetch my slippers', 'unknown_words', /slippers/],
  ['a word never seen', 'go to the purple room', 'unknown_words', /purple/],
  ['words that do not fit', 'room the to the go', 'no_parse', /fit|order/],
  ['markup', '<img src=x onerror=alert(1)> room', 'unknown_words', /onerror/],
];

for (const [what, command, kind, words] of COMMANDS) {
  flow(`a command of ${what}`, async (t) => {
    const demo = await openPage(t);
    await demo.train();
    const before = await demo.robot();
    await demo.ask(command);
    const why = demo.by('why').first();
    const text = await why.textContent();
    t.check((await demo.why()).includes(kind), `${kind} in ${await demo.why()}`);
    t.check(words.test(text), `${words} in: ${text}`);
    t.check(await why.isVisible(), 'the message is in sight');
    t.equal(await demo.robot(), before, 'the robot stays');
    await t.fits(`a command of ${what}`);
    await demo.ask('go to the blue room');
    await demo.played();
    t.equal((await demo.robot()).place, 'the blue room', 'the next command works');
  });
}

flow('a goal that is already true', async (t) => {
  const demo = await openPage(t);
  await demo.train();
  await demo.ask('go to the blue room');
  await demo.played();
  await demo.ask('go to the blue room');
  t.equal(await demo.why(), ['already_true'], 'why');
  t.equal((await demo.robot()).place, 'the blue room', 'the robot stays');
});

flow('a goal that cannot be reached, and a phrase that names nothing', async (t) => {
  const demo = await openPage(t);
  await demo.train();
  await demo.page.getByRole('button', { name: 'Locked', exact: true }).click();
  const before = await demo.robot();
  await demo.ask('go to the blue room');
  t.equal(await demo.why(), ['unreachable'], 'why');
  t.equal(await demo.robot(), before, 'the robot stays');
  await demo.ask('go to the yellow room');
  t.check((await demo.why()).includes('no_referent'), `no_referent in ${await demo.why()}`);
  t.check(/yellow/.test(await demo.by('why').first().textContent()), 'the phrase is named');
});
