// The page that drives a robot as a person uses it, and the rosbridge of the tests' own that it is linked to
// (tests/peer, built by `cargo build --example peer`).

import { spawn } from 'node:child_process';
import path from 'node:path';
import { createInterface } from 'node:readline';
import { PATIENCE } from './flow.mjs';
import { Opened } from './opened.mjs';
import { root } from './packages.mjs';

/** Starts a peer; what comes in it keeps as `frames`, and `tell` has it do something. */
export async function startPeer() {
  const binary = path.join(process.env.CARGO_TARGET_DIR ?? path.join(root, 'target'), 'debug/examples/peer');
  const child = spawn(binary, [], { stdio: ['pipe', 'pipe', 'inherit'] });
  const peer = { frames: [], address: null };
  const reports = [];
  const ready = new Promise((resolve, reject) => {
    child.once('error', reject);
    child.once('exit', () => reject(new Error('the peer has ended')));
    createInterface({ input: child.stdout }).on('line', (line) => {
      const said = JSON.parse(line);
      if (said.listening) {
        peer.address = said.listening;
        resolve();
      } else if (said.report) reports.shift()?.(said.report);
      else peer.frames.push({ ...said, at: performance.now() });
    });
  });
  ready.catch(() => {});
  await ready;
  peer.tell = (line) => child.stdin.write(`${line}\n`);
  peer.report = () => new Promise((resolve) => {
    reports.push(resolve);
    peer.tell('report');
  });
  /** The velocities that came in since the frame of this place: ahead and turning. */
  peer.velocities = (from = 0) => peer.frames.slice(from).map(({ frame }) => frame)
    .filter(({ op, topic }) => op === 'publish' && topic === '/cmd_vel')
    .map(({ msg }) => [(msg.twist ?? msg).linear.x, (msg.twist ?? msg).angular.z]);
  peer.end = () => {
    child.removeAllListeners('exit');
    child.kill();
  };
  return peer;
}

/** Opens the page, and waits until it is there. */
export async function openRobot(t, { german = false } = {}) {
  const page = await t.open(`${t.address}robot.html`);
  const robot = new Robot(t, page);
  await robot.by('stage').waitFor();
  const other = await page.evaluate(() => document.documentElement.lang) === 'de';
  if (german !== other) await robot.press('language');
  return robot;
}

/** The open page. */
export class Robot extends Opened {
  /** Waits until the driver is at this stage. */
  at(stage, seconds = PATIENCE) {
    return this.t.until(`it is ${stage}`, async () => (await this.stage()) === stage, seconds);
  }

  stage() {
    return this.page.locator('.drive').getAttribute('data-stage');
  }

  /** What the dry run found of a thing: good, bad or open. */
  found(check) {
    return this.page.locator(`[data-check="${check}"]`).getAttribute('data-found');
  }

  /** Waits until a thing was found so. */
  finds(check, what, seconds = PATIENCE) {
    return this.t.until(`${check} is ${what}`, async () => (await this.found(check)) === what, seconds);
  }

  /** Links to a peer, whose topics are the usual ones. */
  async link(peer) {
    await this.press('real');
    await this.by('address').fill(peer.address);
    await this.press('link');
    await this.finds('poses', 'good');
  }

  /** Holds the space bar, wherever the keyboard was. */
  async hold() {
    await this.page.evaluate(() => document.activeElement?.blur());
    await this.page.keyboard.down('Space');
  }

  /** Holds the button that is a dead man's key. */
  async holdButton() {
    await this.by('hold').scrollIntoViewIfNeeded();
    const box = await this.by('hold').boundingBox();
    await this.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await this.page.mouse.down();
  }

  letGo() {
    return this.page.keyboard.up('Space');
  }

  /**
   * Waits for something while the key is held. Where a machine is so busy that no pose comes for half a second, or that the
   * page itself stands still, it stops, as it should: who has looked lets it go on.
   */
  underway(what, test, seconds = PATIENCE) {
    return this.t.until(what, async () => {
      if (await test()) return true;
      if (await this.isTooSlow()) await this.goOn();
      return false;
    }, seconds);
  }

  async isTooSlow() {
    return (await this.stage()) === 'halted' && /No pose came|stood still/.test(await this.by('stage').textContent());
  }

  /** Lets it go on that has stopped: ready, and the key held, where it was seen to stop by itself before. */
  async goOn() {
    await this.letGo();
    await this.press('release');
    await this.finds('placed', 'good');
    if (await this.found('stops') !== 'good') return;
    await this.press('arm');
    // So busy a machine may stop it at once; whoever waits for it looks again.
    await this.t.until('it is ready or stopped', async () => {
      const stage = await this.stage();
      const isSeen = await this.found('stops') === 'good';
      if (stage === 'off' && isSeen) await this.press('arm');
      return ['ready', 'halted'].includes(stage) || !isSeen;
    });
    await this.hold();
  }

  /** Holds the key until it drives. */
  async drive() {
    await this.hold();
    await this.underway('it is driving', async () => (await this.stage()) === 'driving');
  }

  /** Lets the key go, and waits until that is all that is missing. */
  async pause() {
    await this.letGo();
    await this.t.until('it waits for the key', async () => {
      const stage = await this.stage();
      if (stage === 'ready') return true;
      if (stage === 'off' && await this.found('stops') === 'good') await this.press('arm');
      if (await this.isTooSlow()) {
        await this.goOn();
        await this.letGo();
      }
      return false;
    }, 120);
  }

  /** The base is seen to stop by itself, tried again where too little was seen of it, and driving is allowed. */
  async arm() {
    await this.underway('it stops by itself', async () => {
      if (await this.found('stops') === 'good') return true;
      if (await this.stage() === 'off') {
        await this.letGo();
        await this.press('try');
        await this.hold();
      }
      return false;
    }, 120);
    await this.allow();
  }

  /** Allows it to drive, and waits until the key is all that is missing. */
  async allow() {
    await this.letGo();
    await this.press('arm');
    await this.pause();
  }

  /** Asks for something; returns when there is a plan. */
  async ask(command) {
    await this.by('command').fill(command);
    await this.t.until('it can be asked', () => this.by('ask').isEnabled());
    await this.press('ask');
    await this.by('plan').waitFor();
  }

  /** Where the robot is in the picture, in cells. */
  async place() {
    const [x, y] = await Promise.all(['x', 'y'].map((name) => this.by('picture').getAttribute(`data-${name}`)));
    return [Number(x), Number(y)];
  }
}
