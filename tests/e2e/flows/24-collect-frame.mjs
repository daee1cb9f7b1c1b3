// A frame as on Mechanical Turk: a page of the tests' own embeds the study and takes its form; a preview posts nothing; a
// host that is not listed gets nothing.

import { answersOf, host, makeStudy, Participant, receiver, takePart } from '../collect.mjs';
import { flow } from '../flow.mjs';

const asked = { asked: 1 };

flow('a platform’s frame embeds the study and receives its form', async (t) => {
  t.expect(/another host is asked/);
  const there = await receiver();
  try {
    await host(t, await makeStudy(t, { ...asked, hosts: [there.address], ends: [{ form: {} }] }));
    const query = new URLSearchParams({ study: 'study.json', assignmentId: '3Z=', hitId: '3H', workerId: 'A1', turkSubmitTo: there.address });
    const source = `${t.address}collect.html?${query}`;
    const page = await t.open(`${there.address}/frame?src=${encodeURIComponent(source)}`);
    const frame = page.frameLocator('iframe');
    await frame.getByTestId('agree').click();
    await frame.getByTestId('ready').click();
    await frame.getByTestId('command').fill('go to the =red room');
    await frame.getByTestId('next').click();
    await t.equal(() => there.posts.length, 0, 'nothing is posted before it is sent');
    await frame.getByTestId('end').click();
    await t.until('the form has come', () => there.posts.length === 1);
    const [{ path, type, body }] = there.posts;
    await t.equal([path, type], ['/mturk/externalSubmit', 'application/x-www-form-urlencoded'], 'where, and as what');
    const fields = new URLSearchParams(body);
    await t.equal([fields.get('assignmentId'), fields.get('hitId'), fields.get('workerId')], ['3Z=', '3H', 'A1'], 'the platform’s names');
    const answers = answersOf(fields.get('answers'));
    await t.equal(answers.map(({ command, assignment }) => [command, assignment]), [['go to the =red room', '3Z=']], 'the answers');
    // Nobody can tell whether a form arrived: it can be sent again, or deleted.
    const again = new Participant(t, await t.open(source));
    await again.at('over');
    await again.by('outbox').waitFor();
    await again.press('ended');
    await again.by('erased').waitFor();
  } finally {
    await there.close();
  }
});

flow('a frame that is only looked at posts nothing', async (t) => {
  t.expect(/another host is asked/);
  const there = await receiver();
  try {
    await host(t, await makeStudy(t, { ...asked, hosts: [there.address], ends: [{ form: {} }] }));
    const query = new URLSearchParams({ study: 'study.json', assignmentId: 'ASSIGNMENT_ID_NOT_AVAILABLE', turkSubmitTo: there.address });
    const person = await takePart(t, `?${query}`);
    await person.begin();
    await person.by('command').fill('go');
    await person.press('next');
    await person.at('end');
    await person.press('end');
    await person.at('over');
    await t.equal(() => there.posts.length, 0, 'posts');
  } finally {
    await there.close();
  }
});

flow('a host that the study does not list gets nothing, and why is said', async (t) => {
  const there = await receiver();
  try {
    await host(t, await makeStudy(t, { ...asked, hosts: ['https://www.mturk.com'], ends: [{ form: {} }] }));
    const query = new URLSearchParams({ study: 'study.json', assignmentId: 'a', workerId: 'w', turkSubmitTo: there.address });
    const person = await takePart(t, `?${query}`);
    await person.begin();
    await person.answer('go');
    await person.at('end');
    await t.check(async () => /does not list 127\.0\.0\.1/.test(await person.by('refusal').textContent()), 'why');
    await t.equal(() => person.by('end').count(), 0, 'nothing to send with');
    await t.equal(answersOf(await person.saved('save-answers')).length, 1, 'a file instead');
    await t.equal(there.posts.length, 0, 'posts');
  } finally {
    await there.close();
  }
});

flow('the way back holds the code, and nothing is kept behind it', async (t) => {
  t.expect(/another host is asked/);
  const there = await receiver();
  try {
    await host(t, await makeStudy(t, { ...asked, ends: [{ return: { url: `${there.address}/done?cc={code}&who={worker}` } }] }));
    const person = await takePart(t, '?study=study.json&participant=a%20b');
    await person.begin();
    await person.answer('go');
    await person.press('end');
    await person.page.waitForURL(`${there.address}/done**`);
    const back = new URL(person.page.url()).searchParams;
    await t.check(/^[0-9A-Z]{8}$/.test(back.get('cc')) && back.get('who') === 'a b', 'the code');
    const again = await takePart(t, '?study=study.json&participant=a%20b');
    await again.at('over');
  } finally {
    await there.close();
  }
});
