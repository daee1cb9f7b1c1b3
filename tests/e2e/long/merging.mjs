// What a merge of 200 participants with 30 answers each costs the page: their files are brought at once, looked through,
// decided by the rule and saved, under Chromium's trace. No task of the page's own thread may take over 50 ms of CPU, but
// for the one in which a file of some 25 MB comes from the engine, as one piece.

import { mkdtemp, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { answersOf, host, makeStudy, takePart } from '../collect.mjs';
import { flow } from '../flow.mjs';
import { openTrain } from '../page.mjs';
import { mainThreads, trace } from '../trace.mjs';

const PEOPLE = Number(process.env.PEOPLE ?? 200);
const ITEMS = 30;
/** Milliseconds of CPU, and those for a whole file. */
const [MOST, WHOLE] = [50, 100];

/** The files of so many people, made of one real answer: their paths, and their bytes in all. */
async function files(t) {
  await host(t, await makeStudy(t, { asked: 1, ends: ['file'] }));
  const person = await takePart(t);
  await person.begin();
  await person.answer('go to the red room');
  await person.at('end');
  const [answer] = answersOf(await person.saved('end'));
  await person.page.close();
  const folder = await mkdtemp(path.join(os.tmpdir(), 'groundling-'));
  let bytes = 0;
  const paths = await Promise.all(Array.from({ length: PEOPLE }, async (_, who) => {
    const lines = Array.from({ length: ITEMS }, (__, at) => JSON.stringify({
      ...answer, id: `p${who}-${at + 1}`, worker: `p${who}`, item: `i${at}`, task: `task-${at}`, turn: [at + 1, ITEMS], study: '',
      command: `go to the ${['red', 'blue', 'green'][(who + at) % 3]} room, person ${who}`,
    }));
    const text = `${lines.join('\n')}\n`;
    bytes += text.length;
    const file = path.join(folder, `${who}.jsonl`);
    await writeFile(file, text);
    return file;
  }));
  return { paths, bytes };
}

flow(`${PEOPLE} × ${ITEMS} answers are merged, and the page stays at hand`, async (t) => {
  const { paths, bytes } = await files(t);
  const demo = await openTrain(t);
  t.page = demo.page;
  await demo.part('study');
  const parts = [
    ['merging', async () => {
      // By their paths: bytes would cost the page what the driver does with them.
      await demo.by('answers-file').setInputFiles(paths);
      await t.until('all are merged', async () => (await demo.by('answer-counts').count()) > 0
        && (await demo.by('answer-counts').textContent()).startsWith(`${PEOPLE * ITEMS} answers`), 400);
    }],
    ['looking', async () => {
      await demo.press('later');
      await demo.by('look').first().click();
      await demo.by('answer-pairs').waitFor();
    }],
    ['deciding', async () => {
      await demo.press('decide');
      await t.until('all is decided', async () => /: 0 open/.test(await demo.by('answer-counts').textContent()), 60);
    }],
    ['saving', async () => { await demo.saved('save-lines'); }],
  ];
  const over = [];
  for (const [name, body] of parts) {
    const [{ tasks }] = mainThreads(await trace(demo.page, body));
    const longest = tasks.reduce((a, b) => (a.cpu > b.cpu ? a : b), { clock: 0, cpu: 0 });
    const sum = tasks.reduce((total, { cpu }) => total + cpu, 0);
    t.note(`${name} (${(bytes / 1e6).toFixed(1)} MB): longest task ${longest.cpu.toFixed(1)} ms of CPU, ${sum.toFixed(0)} ms in all`);
    if (longest.cpu > (name === 'saving' ? WHOLE : MOST)) over.push(`${name}: ${longest.cpu.toFixed(1)} ms`);
  }
  await t.check(over.length === 0, `too long: ${over.join('; ')}`);
});
