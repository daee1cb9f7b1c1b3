// The loop with 200 simulated participants, 8 of 100 careless: the real page, an endpoint, a review by a model that has
// learned from other workers alone, and training on what was approved. Told: how many careless answers the flags catch, how
// many good ones they touch, and what a model reaches that learned from what was approved, beside one that learned from the
// same answers with the crowd's own decisions. `make test-long` runs it.

import { writeFile } from 'node:fs/promises';
import path from 'node:path';
import { crowd, host, makeStudy, receiver, takePart } from '../collect.mjs';
import { flow } from '../flow.mjs';

const PEOPLE = Number(process.env.PEOPLE ?? 200);
const RULE = 'some_pairs,no_pair,copied,same,missed';

flow(`${PEOPLE} simulated participants, reviewed and learned from`, { seconds: 3600 }, async (t) => {
  t.expect(/another host is asked/);
  const there = await receiver();
  try {
    const { folder, said, others } = await crowd();
    const made = await makeStudy(t, { asked: 6, hosts: [there.address], ends: [{ endpoint: { url: `${there.address}/in`, key: 'k' } }] }, ['--from', said, '--rehearsed']);
    await host(t, made);
    for (let seed = 0; seed < PEOPLE; seed += 1) {
      const person = await takePart(t, `?study=study.json&simulate=${seed}`);
      await person.at('over');
      await person.page.close();
    }
    await t.equal(there.posts.length, PEOPLE, 'posts');
    const file = (name) => path.join(folder, name);
    await writeFile(file('answers.jsonl'), there.posts.map(({ body }) => body).join('\n'));
    await writeFile(file('study.json'), made);
    const run = async (...args) => {
      const { status, stdout, stderr } = await t.groundling(...args);
      if (status !== 0) throw new Error(stderr);
      return stdout;
    };
    await run('train', '--corpus', others, '--out', file('judge.model'));
    const reviewed = JSON.parse(await run('review', '--study', file('study.json'), '--answers', file('answers.jsonl'), '--model', file('judge.model'), '--reject', RULE, '--out', file('approved.csv'), '--approved-only', '--json'));
    const { careless, caught, good, touched } = reviewed.told_apart;
    t.note(`${reviewed.answers} answers; ${caught} of ${careless} careless caught, ${touched} of ${good} good touched`);
    await t.check(caught >= 0.8 * careless, 'four of five careless answers are caught');
    // The crowd's own decisions of the same rows.
    for (const [name, corpus] of [['approved', file('approved.csv')], ['accepted', said]]) {
      await run('train', '--corpus', corpus, '--out', file(`${name}.model`));
      const { f1, total } = JSON.parse(await run('evaluate', '--model', file(`${name}.model`), '--corpus', others, '--json'));
      t.note(`learned from what was ${name}: F1 ${f1.toFixed(3)} of ${total}`);
    }
  } finally {
    await there.close();
  }
});
