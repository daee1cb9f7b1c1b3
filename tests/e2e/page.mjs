// The page as a person uses it: what can be pressed and what can be read, by its test ids. Flows speak in
// these words, so that a change of layout is mended here alone.

import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { root } from './packages.mjs';

/** The project's own six sentences, as the page's file has them. */
export const six = await readFile(path.join(root, 'assets/corpus/six.csv'), 'utf8');

/** The rows of `six` under its header: no cell of it holds a line break. */
export const rows = six.trimEnd().split(/\r?\n/);

/** A CSV file of the header of `six` and `lines`. */
export const csv = (...lines) => [rows[0], ...lines, ''].join('\n');

/** What "go to the blue room" means. */
export const BLUE_ROOM = '(in:<e,<e,t>> (the:<<e,t>,e> (lambda $0:e (agent:<e,t> $0))) '
  + '(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (blue:<e,t> $0) (room:<e,t> $0)))))';

/** Opens the built site and waits until its engine has read the six sentences. */
export async function openPage(t) {
  const page = await t.open();
  const demo = new Demo(t, page);
  await demo.by('row').first().waitFor();
  return demo;
}

/** The open page. */
export class Demo {
  constructor(t, page) {
    this.t = t;
    this.page = page;
  }

  /** The element with this test id. */
  by(id) {
    return this.page.getByTestId(id);
  }

  /** Presses Train and waits for the model. */
  async train() {
    await this.by('train').click();
    await this.by('trained').waitFor({ timeout: 60_000 });
  }

  /** The text of the model that the page saves. */
  async model() {
    return this.saved('save-model');
  }

  /** The text of the file that a button saves. */
  async saved(id) {
    const [download] = await Promise.all([this.page.waitForEvent('download'), this.by(id).click()]);
    return readFile(await download.path(), 'utf8');
  }

  /** Types a command and sends it; returns when it has been answered or refused. */
  async ask(command) {
    await this.by('command').fill(command);
    await this.by('ask').click();
    await this.t.until(`an answer to “${command.slice(0, 40)}”`, async () =>
      (await this.by('ask').textContent()).trim() === 'Tell'
        && (await this.by('answer').count()) + (await this.by('ask-notice').count()) > 0);
  }

  /** The reading that stands first: its form and its human form. */
  async reading() {
    const first = this.by('reading').first();
    return {
      form: await first.getByTestId('reading-form').textContent(),
      human: await first.getByTestId('reading-human').textContent(),
      derivation: await first.getByTestId('reading-derivation').textContent(),
      score: Number((await first.getByTestId('reading-score').textContent()).replace(/[^-\d.]/g, '')),
    };
  }

  /** Why the last command came to nothing: the kinds of the messages that are shown. */
  async why() {
    const all = await this.by('why').all();
    return Promise.all(all.map((one) => one.getAttribute('data-kind')));
  }

  /** Where the robot is, as the page says it: cell, and place in words. */
  async robot() {
    const stage = this.by('stage');
    const [x, y, place] = await Promise.all(
      ['x', 'y', 'place'].map((name) => stage.getAttribute(`data-robot-${name}`)));
    return { x: Number(x), y: Number(y), place };
  }

  /** Waits until the plan has been played to its end; returns its number of steps. */
  async played() {
    const plan = this.by('plan');
    await this.t.until('the plan is played', async () => {
      const [at, steps] = [await plan.getAttribute('data-at'), await plan.getAttribute('data-steps')];
      return at === steps && (await plan.getAttribute('data-playing')) === 'false';
    }, 60);
    return Number(await plan.getAttribute('data-steps'));
  }

  /** Chooses a corpus file with this text. */
  async choose(name, content) {
    await this.by('corpus-file').setInputFiles({
      name,
      mimeType: 'text/csv',
      buffer: Buffer.from(content),
    });
  }

  /** Drops a file anywhere on the page. */
  async drop(name, text) {
    const transfer = await this.page.evaluateHandle(([fileName, content]) => {
      const data = new DataTransfer();
      data.items.add(new File([content], fileName, { type: 'text/csv' }));
      return data;
    }, [name, text]);
    await this.page.locator('main').dispatchEvent('drop', { dataTransfer: transfer });
  }

  /** The corpus that is open: its file's name, and how many rows are listed. */
  async corpus() {
    return { name: await this.by('corpus-name').textContent(), rows: await this.by('row').count() };
  }
}
