// What other programs collected: jsPsych itself, from npm, runs a small study of three trials in Chromium, and its CSV is
// mapped in the workbench and taken into training; psiTurk's downloads are written by hand.

import { readFile } from 'node:fs/promises';
import http from 'node:http';
import path from 'node:path';
import { makeStudy } from '../collect.mjs';
import { flow } from '../flow.mjs';
import { packageFolder } from '../packages.mjs';
import { openTrain } from '../page.mjs';

/** A page of jsPsych's with three trials, which ends with its data as CSV in the page. */
const experiment = (pairs) => `<!DOCTYPE html><html lang="en"><head><title>A study of jsPsych's</title>
<script src="jspsych/dist/index.browser.js"></script>
<script src="@jspsych/plugin-html-button-response/dist/index.browser.js"></script>
<script src="@jspsych/plugin-survey-text/dist/index.browser.js"></script></head><body></body><script>
const jsPsych = initJsPsych({ on_finish: () => { window.collected = jsPsych.data.get().csv(); window.byColumn = jsPsych.data.get().values().reduce((all, row) => { for (const [k, v] of Object.entries(row)) (all[k] ??= []).push(v); return all; }, {}); } });
jsPsych.data.addProperties({ ...jsPsych.data.urlVariables(), subject: 's=1' });
const pairs = ${JSON.stringify(pairs)};
const ask = (at) => ({ type: jsPsychSurveyText, questions: [{ prompt: 'One command', name: 'command', required: true, rows: 3 }],
  data: { task: 'step', pre_1: pairs[at].pre, post_1: pairs[at].post } });
jsPsych.run([{ type: jsPsychHtmlButtonResponse, stimulus: 'Welcome, "all" of you', choices: ['Begin'] }, ask(0), ask(1)]);
</script></html>`;

async function serve(pairs) {
  const types = { '.js': 'text/javascript' };
  const server = http.createServer(async (request, response) => {
    const name = decodeURIComponent(request.url.split('?')[0]).slice(1);
    if (name === '') return response.writeHead(200, { 'Content-Type': 'text/html' }).end(experiment(pairs));
    try {
      const body = await readFile(path.join(packageFolder('jspsych'), '..', name));
      return response.writeHead(200, { 'Content-Type': types[path.extname(name)] ?? 'application/octet-stream' }).end(body);
    } catch {
      return response.writeHead(name === 'favicon.ico' ? 204 : 404).end();
    }
  });
  await new Promise((resolve) => { server.listen(0, '127.0.0.1', resolve); });
  return {
    address: `http://127.0.0.1:${server.address().port}/`,
    close: () => new Promise((resolve) => { server.close(resolve); server.closeAllConnections(); }),
  };
}

flow('what jsPsych collects is mapped, and learned from', async (t) => {
  const { items } = JSON.parse(await makeStudy(t, {}));
  const there = await serve(items.slice(0, 2).map(({ shows }) => shows[0]));
  try {
    const page = await t.open(there.address);
    await page.getByText('Begin').click();
    for (const words of ['go to the "red" room, please', '=step\naside']) {
      await page.locator('#input-0').fill(words);
      await page.locator('#jspsych-survey-text-next').click();
    }
    const csv = await t.until('it is over', () => page.evaluate(() => window.collected));
    const byColumn = JSON.stringify(await page.evaluate(() => window.byColumn));
    t.note(`columns: ${csv.split('\n')[0].slice(0, 300)}`);
    const demo = await openTrain(t);
    t.page = demo.page;
    await demo.part('study');
    const bring = (name, text) => demo.by('answers-file').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
    await bring('columns.json', byColumn);
    await demo.by('answer-flaws').locator('summary').click();
    await t.check(async () => /its rows no longer belong together/.test(await demo.by('answer-flaws').textContent()), 'by column is refused');
    await bring('data.csv', csv);
    await demo.by('survey').waitFor();
    await t.check(async () => /^3 trials/.test(await demo.by('survey').locator('p').first().textContent()), 'three trials');
    await t.accessible('a mapping of trials');
    const mapping = JSON.parse(await demo.saved('save-survey'));
    await t.equal([mapping.values.command, mapping.values.worker, mapping.values.pairs], ['response.command', 'subject', [{ pre: 'pre_1', post: 'post_1' }]], 'what is proposed');
    await demo.press('convert');
    await t.check(async () => /^2 answers: 2 open/.test(await demo.by('answer-counts').textContent()), 'two answers');
    await demo.press('train-on-answers');
    await t.until('they are the corpus', async () => /study-answers/.test(await demo.page.locator('main').textContent()));
  } finally {
    await there.close();
  }
});

flow('psiTurk’s downloads are mapped, and who did not finish is left out', async (t) => {
  const { items: [{ shows: [{ pre, post }] }] } = JSON.parse(await makeStudy(t, {}));
  const quoted = (text) => `"${text.replaceAll('"', '""')}"`;
  const trial = (who, n, data) => `${who},${n},1764390000000,${quoted(JSON.stringify(data))}\n`;
  const files = {
    'trialdata.csv': trial('A1:H1', 0, { command: 'go east', pre_1: pre, post_1: post })
      + trial('A1:H1', 1, { phase: 'postquestionnaire' }) + trial('B2:H1', 0, { command: 'go west', pre_1: pre, post_1: post }),
    'questiondata.csv': 'A1:H1,engagement,\'4\'\nA1:H1,remarks,"u\'it\\\\\'s fine\'"\n',
    'eventdata.csv': 'A1:H1,focus,10,on,1764390000000\n',
  };
  const demo = await openTrain(t);
  await demo.part('study');
  await demo.by('answers-file').setInputFiles(Object.entries(files).map(([name, text]) => ({ name, mimeType: 'text/csv', buffer: Buffer.from(text) })));
  await demo.by('survey').waitFor();
  await demo.press('convert');
  await t.check(async () => /^1 answers/.test(await demo.by('answer-counts').textContent()), 'one answer');
  await t.check(async () => /1 of people who did not finish/.test(await demo.by('study-notice').textContent()), 'who is left out');
});
