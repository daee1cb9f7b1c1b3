// The paper's own six sentences, kept outside the project: dropped on the page, learned, and tried on a
// command that none of them holds. Run by `make check-corpora DIR=folder`.

import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { flow } from '../flow.mjs';
import { BLUE_ROOM, openTrain } from '../page.mjs';

flow('the paper’s six sentences, then “move to the red room”', async (t) => {
  const text = await readFile(path.join(process.env.CORPORA, 'amt-six-train.csv'), 'utf8');
  const demo = await openTrain(t);
  await demo.drop('amt-six-train.csv', text);
  await t.until('the file is open', async () => (await demo.corpus()).name === 'amt-six-train.csv');
  t.equal((await demo.corpus()).rows, 6, 'rows');
  await demo.train();
  await demo.talk();
  await demo.ask('move to the red room');
  await demo.played();
  t.equal((await demo.robot()).room, 'red', 'where the robot ends');
  t.equal(await demo.form(), BLUE_ROOM.replace('blue', 'red'), 'the form');
});
