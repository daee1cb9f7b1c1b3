// Files that are wrong: each is answered in words beside the corpus, and what was open stays open.

import { flow } from '../flow.mjs';
import { csv, openTrain, rows } from '../page.mjs';

/** A row of the six with one text replaced in its cells. */
function spoilt(from, to) {
  const line = rows[1].replace(from, to);
  if (line === rows[1]) throw new Error(`no ${from} in the first row`);
  return line;
}

/** Puts the object of a row's first state where the robot is. */
function crowded() {
  const [, x, y] = /""agent"":\{""x"":(\d+),""y"":(\d+)/.exec(rows[1]);
  return spoilt(/(""objects"":\[\{[^}]*?""x"":)\d+(,""y"":)\d+/, `$1${x}$2${y}`);
}

/** Files without a single good row, and what must be said of each. */
const HOPELESS = [
  ['an empty file', '', /empty/i],
  ['a header alone', csv(), /row/i],
  ['a picture', Buffer.from([0x89, 0x50, 0x4e, 0x47, 0xff, 0xfe, 0x00, 0x80]), /not a text file/],
  ['a letter', 'Dear robot,\nplease go to the blue room.\n', /column/i],
  ['a file without the command', csv(...rows.slice(1)).replace('Answer.command', 'Answer.other'), /Answer\.command/],
  ['a file without a state', csv(...rows.slice(1)).replace('Input.post_1', 'Input.other_1'), /Input\.post_1|post_1/],
];

/** Rows that are wrong, each put before a good one, and what must be said. */
const SPOILT = [
  ['broken JSON', () => spoilt('""agent"":{', '""agent"":{{'), /line 2[^]*Input\.pre_1/],
  ['a robot in a wall', () => spoilt(/""agent"":\{""x"":\d+/, '""agent"":{""x"":0'), /wall/],
  ['two things in one cell', crowded, /cell/],
  ['an unknown shape', () => spoilt(/""shape"":""\w+""/, '""shape"":""sofa""'), /sofa[^]*chair/],
  ['an unknown colour', () => spoilt(/""color"":""\w+""/, '""color"":""mauve""'), /mauve[^]*red/],
];

flow('files without a good row are refused in words, and the corpus stays', async (t) => {
  const demo = await openTrain(t);
  const notice = demo.by('file-notice');
  for (const [what, content, message] of HOPELESS) {
    await demo.choose('other.csv', content);
    await t.until(`${message} for ${what}`, async () =>
      (await notice.count()) > 0 && message.test(await notice.textContent()));
    await t.check(() => notice.isVisible(), `the message is in sight for ${what}`);
    await t.equal(() => demo.corpus(), { name: 'six.csv', rows: 6 }, `what is open after ${what}`);
  }
  await demo.train();
});

flow('bad rows are explained, and the good one is kept', async (t) => {
  const demo = await openTrain(t);
  for (const [what, row, message] of SPOILT) {
    const name = `${what}.csv`;
    await demo.choose(name, csv(row(), rows[2]));
    await t.until(`${name} is open`, async () => (await demo.corpus()).name === name);
    await t.equal(() => demo.corpus(), { name, rows: 1 }, 'what is open');
    const problems = () => demo.by('problems').textContent();
    await t.check(async () => /line 2/.test(await problems()), async () => `the line is named in: ${await problems()}`);
    await t.check(async () => message.test(await problems()), async () => `${message} in: ${await problems()}`);
  }
});

flow('a model taught before outlives a bad file, dropped this time', async (t) => {
  const demo = await openTrain(t);
  await demo.train();
  const model = await demo.model();
  await demo.talk();
  await demo.drop('bad.csv', 'a,b\n1,2\n');
  await demo.by('file-notice').waitFor();
  await t.check(() => demo.by('file-notice').isVisible(), 'the message is in sight');
  await t.accessible('a refused file');
  await t.check(async () => (await demo.model()) === model, 'the model is as it was');
  await demo.talk();
  await demo.ask('go to the blue room');
  await demo.finish();
  await t.equal(async () => (await demo.robot()).room, 'blue', 'and it still answers');
});

flow('a bad model file is refused beside the training', async (t) => {
  const demo = await openTrain(t);
  await demo.train();
  const model = await demo.model();
  const file = (text) => ({ name: 'bad.model', mimeType: 'text/plain', buffer: Buffer.from(text) });
  for (const text of ['', 'groundling model 99\n', model.slice(0, model.length / 2), 'hello\n']) {
    await demo.part('run');
    await demo.by('model-file').setInputFiles(file(text));
    await t.until('a message', async () =>
      (await demo.by('model-notice').count()) + (await demo.by('file-notice').count()) > 0);
    await t.check(async () => (await demo.model()) === model, 'the model is as it was');
  }
});
