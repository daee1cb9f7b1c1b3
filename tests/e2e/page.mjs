// The page as a person uses it: what can be pressed and what can be read, by its test ids. Flows speak in
// these words, so that a change of layout is mended here alone.

import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { Opened } from './opened.mjs';
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

/** Opens the built site (or a link to it) and waits until it can be talked to. */
export async function openPage(t, address = t.address) {
  const demo = new Demo(t, await t.open(address));
  await demo.ready();
  return demo;
}

/** Four rooms in a ring; the robot stands in the green one. */
export const RING = `#############
#rrrrr#bbbbb#
#rrrrr+bbbbb#
#rrrrr#bbbbb#
###a#####c###
#ggggg#yyyyy#
#g<gggdyyyyy#
#ggggg#yyyyy#
#############

r room red
b room blue
g room green
y room yellow
+ door unlocked
a door unlocked
c door unlocked
d door unlocked
`;

/** Opens the page in a world. */
export async function openIn(t, world) {
  const demo = await openPage(t);
  await demo.mode('edit');
  await demo.page.locator('summary', { hasText: 'Random' }).click();
  await demo.press('world-text');
  await demo.by('drawing').fill(world);
  await demo.press('apply-text');
  await demo.mode('watch');
  return demo;
}

/** Opens the workbench and waits until its engine has read the six sentences. */
export async function openTrain(t) {
  const demo = new Demo(t, await t.open(`${t.address}#train`));
  await demo.by('row').first().waitFor();
  return demo;
}

/** What `body` finds on the page at an address, in a browser that has seen nothing yet, once a command can be sent. */
export function openElsewhere(t, address, body) {
  return t.elsewhere({}, async (page) => {
    await page.goto(address);
    const demo = new Demo(t, page);
    await demo.ready();
    return body(demo);
  });
}

/** The open page where one talks and trains. */
export class Demo extends Opened {
  /** How much of what was said aloud has been waited for. */
  heard = 0;

  /** Presses what has this test id, and waits until the page has redrawn. */
  async press(id) {
    await this.by(id).click();
    await this.redrawn();
  }

  /** Waits until the page has redrawn what has happened; a page that goes away has nothing to draw. */
  async redrawn() {
    await this.page.evaluate(() => new Promise((done) => {
      requestAnimationFrame(() => requestAnimationFrame(done));
    })).catch(() => {});
  }

  /** Waits until a command can be sent. */
  async ready() {
    await this.t.until('the page is ready', async () =>
      (await this.by('ask').count()) > 0 && (await this.page.locator('form.say.main').getAttribute('aria-busy')) === 'false');
  }

  // Talking.

  /** The first reading that says this, wherever it stands among them. */
  reading(words) {
    return this.by('reading').filter({ hasText: words }).first();
  }

  /** Types a command and sends it; returns when it has been answered or refused. */
  async ask(command) {
    await this.by('command').fill(command);
    await this.press('ask');
    await this.answered(command);
  }

  /** Waits until the command was answered or refused. */
  async answered(command) {
    const words = command.slice(0, 40);
    await this.t.until(`an answer to “${words}”`, async () => (await this.by('ask').count()) > 0
      && (await this.page.locator('[data-testid="answer"][data-live="false"]').count())
      + (await this.by('ask-notice').count()) > 0);
  }

  /** Waits until the commands to try are those of the room on view; returns the test id and the words of each. */
  async examples() {
    const seen = () => this.page.evaluate(() => [...document.querySelectorAll('.chip')].map((chip) =>
      [chip.dataset.testid, chip.textContent.trim()]));
    await this.t.until('commands to try', () => this.page.locator('.chips[aria-busy=false]').count());
    return seen();
  }

  /** Waits until the command is planned for; a question on the way is answered with its first reading. */
  async planned() {
    await this.t.until('a plan or a question', async () =>
      (await this.by('plan').count()) + (await this.by('question').count()) > 0);
    if ((await this.by('question').count()) > 0) await this.page.keyboard.press('1');
    await this.t.until('there is a plan', async () => (await this.by('plan').count()) > 0);
  }

  /** What was understood, in plain words; nothing when nothing was. */
  async plain() {
    return (await this.by('plain').count()) > 0 ? this.by('plain').textContent() : null;
  }

  /** Why the last command came to nothing: the kinds of the messages that are shown. */
  async why() {
    const all = await this.by('why').all();
    return Promise.all(all.map((one) => one.getAttribute('data-kind')));
  }

  /** The button of this kind of help, and with these words if some are given. */
  help(kind, words = '') {
    return this.page.locator(`[data-testid="help"][data-help="${kind}"]`, { hasText: words }).first();
  }

  /** Looks as deep as `say`, `see` or `study`. */
  deepen(depth) {
    return this.press(`depth-${depth}`);
  }

  /** The logical form of the reading that counts. */
  async form() {
    await this.deepen('study');
    return this.by('reading-form').textContent();
  }

  // The room.

  /** Where the robot is, as the page says it: cell, and the colour of its room. */
  async robot() {
    const stage = this.by('stage');
    const [x, y, room] = await Promise.all(
      ['x', 'y', 'room'].map((name) => stage.getAttribute(`data-robot-${name}`)));
    return { x: Number(x), y: Number(y), room };
  }

  /** All of the room in words, as a screen reader is told. */
  world() {
    return this.by('stage').locator('svg.picture').getAttribute('aria-label');
  }

  /** Waits until the plan has been played to its end, four times as fast; returns its number of steps. */
  async played() {
    const plan = this.by('plan');
    await this.by('plan-speed').selectOption('4×');
    await this.t.until('the plan is played', async () => {
      const [at, steps] = [await plan.getAttribute('data-at'), await plan.getAttribute('data-steps')];
      return at === steps && (await plan.getAttribute('data-playing')) === 'false';
    }, 60);
    return Number(await plan.getAttribute('data-steps'));
  }

  /** Goes to a step of the plan and stops there. */
  async seek(step) {
    await this.by('plan-scrub').fill(`${step}`);
    await this.t.until(`step ${step}`, async () => {
      const [at, playing] = await Promise.all(['at', 'playing'].map((name) => this.by('plan').getAttribute(`data-${name}`)));
      return at === `${step}` && playing === 'false';
    });
  }

  /** Goes to the plan's end at once; returns its number of steps. */
  async finish() {
    const steps = Number(await this.by('plan').getAttribute('data-steps'));
    await this.seek(steps);
    return steps;
  }

  /** What a screen reader was told last. */
  said() {
    return this.by('announcement').textContent();
  }

  /** Waits until a screen reader is told something like this, after what was waited for before; more may have been said since. */
  async says(pattern) {
    await this.t.until(`${pattern} is said aloud`, async () => {
      const said = await this.page.evaluate(() => globalThis.flowSaid);
      // A page that was loaded again has said nothing yet.
      if (said.length < this.heard) this.heard = 0;
      const at = said.findIndex((words, place) => place >= this.heard && pattern.test(words));
      if (at >= 0) this.heard = at + 1;
      return at >= 0;
    });
  }

  /** The rooms that the robot is in from step to step of the plan. */
  async rooms() {
    const all = [];
    const last = Number(await this.by('plan').getAttribute('data-steps'));
    for (let step = 0; step <= last; step += 1) {
      await this.seek(step);
      const { room } = await this.robot();
      if (room && room !== all.at(-1)) all.push(room);
    }
    return all;
  }

  /** Chooses what the room is for: `watch`, `edit` or `teach`. */
  async mode(mode) {
    const pressed = this.page.locator('.turn[aria-pressed="true"]');
    if (mode !== 'watch') {
      if ((await this.by(`mode-${mode}`).getAttribute('aria-pressed')) === 'false') await this.press(`mode-${mode}`);
    } else if ((await pressed.count()) > 0) await pressed.click();
  }

  /** Where a cell's middle is on the screen. */
  async spot([x, y]) {
    return this.by('stage').locator('svg.picture').evaluate((svg, [column, row]) => {
      const { x: across, y: down } = new DOMPoint(column, -row).matrixTransform(svg.getScreenCTM());
      return { x: across, y: down };
    }, [x, y]);
  }

  /** Presses a cell of the room with the mouse. */
  async tap(cell) {
    await this.by('stage').scrollIntoViewIfNeeded();
    const { x, y } = await this.spot(cell);
    await this.page.mouse.click(x, y);
    await this.redrawn();
  }

  /** Drags with the mouse from one cell of the room to another. */
  async drag(from, to) {
    await this.by('stage').scrollIntoViewIfNeeded();
    const [a, b] = [await this.spot(from), await this.spot(to)];
    await this.page.mouse.move(a.x, a.y);
    await this.page.mouse.down();
    await this.page.mouse.move(b.x, b.y, { steps: 4 });
    await this.page.mouse.up();
    await this.redrawn();
  }

  /** Presses keys in the room, one after another. */
  async keys(...all) {
    await this.by('room').focus();
    for (const key of all) await this.page.keyboard.press(key);
    await this.redrawn();
  }

  /** Presses Tab until what has this test id has the focus. */
  async reach(id) {
    for (let presses = 0; presses < 80; presses += 1) {
      const focused = await this.page.evaluate(() => document.activeElement?.getAttribute('data-testid'));
      if (focused === id) return;
      await this.page.keyboard.press('Tab');
    }
    throw new Error(`Tab never reaches ${id}`);
  }

  // Training and files.

  /** Turns to a part of the workbench: `data` or `run`. */
  async part(name) {
    if ((await this.by(`tab-${name}`).getAttribute('aria-selected')) !== 'true') await this.press(`tab-${name}`);
  }

  /** Has training take so many passes. */
  async passes(count) {
    await this.by('setting-epochs').fill(`${count}`);
    await this.by('setting-epochs').blur();
  }

  /** Holds so many percent of the rows out. */
  async holdOut(percent) {
    await this.by('split-percent').fill(`${percent}`);
    await this.by('split-by').selectOption({ label: 'single rows' });
    await this.press('split-share');
    await this.t.check(async () => /held out/.test(await this.by('corpus-count').textContent()), 'a share is held out');
  }

  /** Presses Train and waits for the model. */
  async train() {
    await this.part('run');
    await this.press('train');
    await this.t.until('it has trained', async () =>
      (await this.by('trained').count()) > 0 && /trained here/.test(await this.by('trained').textContent()), 60);
  }

  /** Goes to the view in which one talks. */
  async talk() {
    await this.press('view-talk');
    await this.ready();
  }

  /** Goes to the workbench. */
  async workbench() {
    await this.press('view-train');
    await this.by('row').first().waitFor();
  }

  /** The text of the model that the workbench saves. */
  async model() {
    await this.part('run');
    return this.saved('save-model');
  }

  /** The link that shares what is on view. */
  async link() {
    await this.press('share');
    await this.by('link').waitFor();
    return this.by('link').inputValue();
  }

  /** The text of the file that a button saves. */
  async saved(id) {
    const [download] = await Promise.all([this.page.waitForEvent('download'), this.press(id)]);
    return readFile(await download.path(), 'utf8');
  }

  /** Chooses a corpus file of this text or these bytes. */
  async choose(name, content) {
    await this.part('data');
    await this.by('corpus-file').setInputFiles({ name, mimeType: 'text/csv', buffer: Buffer.from(content) });
  }

  /** Drops a file anywhere on the page. */
  drop(name, text) {
    return this.dropAll([[name, text]]);
  }

  /** Drops files anywhere on the page, each a name and a text, and perhaps what follows it so many times. */
  async dropAll(files) {
    await this.let(await this.carried(files));
  }

  /** Files as a mouse carries them, for `let`; bringing them into the page takes its thread some time. */
  carried(files) {
    return this.page.evaluateHandle((all) => {
      const data = new DataTransfer();
      for (const [name, text, more = '', times = 0] of all) {
        data.items.add(new File([text, ...Array(times).fill(more)], name, { type: 'text/csv' }));
      }
      return data;
    }, files);
  }

  /** Lets go of what the mouse carries. */
  async let(transfer) {
    await this.page.locator('main').dispatchEvent('drop', { dataTransfer: transfer });
  }

  /** The corpus that is open: its file's name, and how many rows are listed. */
  async corpus() {
    await this.part('data');
    return { name: await this.by('corpus-name').textContent(), rows: await this.by('row').count() };
  }
}
