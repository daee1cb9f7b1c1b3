// What a flow is and what it is given: a page of its own, watched for anything that goes wrong, and the
// few checks that flows share. A flow file calls `flow(title, body)` or `flow(title, settings, body)`.

import { execFile } from 'node:child_process';
import { readFile, mkdir } from 'node:fs/promises';
import path from 'node:path';
import { promisify } from 'node:util';
import { matchGolden } from './golden.mjs';
import { axeFile, root } from './packages.mjs';

/** Seconds that whatever a flow waits for may take, on a machine that is busy with other things. */
export const PATIENCE = 60;

/** The flows declared so far. */
export const flows = [];

/**
 * Declares a flow; `settings` are those of a browser context (viewport, reducedMotion …), `gpu: true` for a browser that
 * seems to have one, `seconds` for one that takes long.
 */
export function flow(title, settings, body) {
  flows.push(body ? { title, settings, body } : { title, settings: {}, body: settings });
}

/** The folder of screenshots. */
export const OUT = path.join(root, 'target/e2e');

/** What browser and driver say by themselves: WebGPU with nothing to run it on, a service worker that the flow does without. */
const OWN = /^(No available adapters\.|Service Worker registration blocked by Playwright)$/;

/** What a flow's body is given. */
export class Flow {
  /** `context` is a fresh browser context, `address` the site's. */
  constructor(context, address) {
    this.context = context;
    this.address = address;
    /** What is told in the report. */
    this.notes = [];
    /** What went wrong in the page by itself. */
    this.problems = [];
    /** Problems that the flow provokes, as regular expressions. */
    this.expected = [];
  }

  /** Says something worth reading in the report. */
  note(words) {
    this.notes.push(words);
  }

  /** Lets the page take the rasteriser in software for a GPU, which it would spare. */
  async pretendGpu() {
    await this.context.addInitScript(() => {
      const UNMASKED_RENDERER = 0x9246;
      const { prototype } = WebGL2RenderingContext;
      const own = prototype.getParameter;
      prototype.getParameter = function getParameter(name) {
        return name === UNMASKED_RENDERER ? 'a GPU, as far as flows go' : own.call(this, name);
      };
    });
  }

  /** Opens a page at `address`, watched from its first moment. */
  async open(address = this.address) {
    const page = await this.context.newPage();
    this.page ??= page;
    const origin = new URL(address).origin;
    const problem = (what) => this.problems.push(what);
    page.on('console', (message) => {
      if (OWN.test(message.text())) return;
      if (['error', 'warning'].includes(message.type())) problem(`console: ${message.text()}`);
    });
    page.on('pageerror', (error) => problem(`uncaught: ${error.stack ?? error}`));
    page.on('crash', () => problem('the page crashed'));
    page.on('requestfailed', (request) => {
      const why = request.failure()?.errorText;
      // What a page or an engine was still fetching ends with it.
      if (why !== 'net::ERR_ABORTED') problem(`request failed: ${request.url()}: ${why}`);
    });
    page.on('response', (response) => {
      if (response.status() >= 400) problem(`status ${response.status()}: ${response.url()}`);
    });
    page.on('request', (request) => {
      const url = new URL(request.url());
      const own = url.origin === origin || (url.protocol === 'blob:' && url.href.includes(origin));
      if (!own && url.protocol !== 'data:') problem(`another host is asked: ${url}`);
    });
    await page.addInitScript(watch);
    await page.goto(address);
    return page;
  }

  /** What `body` finds with a page of a browser that has seen nothing yet, closed behind it; `settings` are its context's. */
  async elsewhere(settings, body) {
    const context = await this.context.browser().newContext(settings);
    try {
      return await body(await context.newPage());
    } finally {
      await context.close();
    }
  }

  /** Lets problems that match `pattern` pass: the flow provokes them. */
  expect(pattern) {
    this.expected.push(pattern);
  }

  /** The problems that nobody expected. */
  unexpected() {
    return this.problems.filter((problem) => !this.expected.some((pattern) => pattern.test(problem)));
  }

  /**
   * Fails the flow unless `truth`: a value, or a function that looks. What a function finds is waited for, as a page
   * need not have redrawn yet; `what` may be one, too.
   */
  async check(truth, what) {
    const holds = await this.waited(truth, (found) => found);
    if (!holds.fits) throw new Error(typeof what === 'function' ? await what() : what);
  }

  /** Fails the flow unless both print alike; `actual` is a value, or a function that looks, which is waited for. */
  async equal(actual, wanted, what) {
    const print = (value) => JSON.stringify(value);
    const { fits, found } = await this.waited(actual, (value) => print(value) === print(wanted));
    if (fits) return;
    const [one, other] = [print(found) ?? 'undefined', print(wanted) ?? 'undefined'];
    // Of long values, that where they part.
    const at = [...one].findIndex((letter, place) => letter !== other[place]);
    const from = Math.max(0, (at < 0 ? one.length : at) - 200);
    const part = (text) => `${from > 0 ? '…' : ''}${text.slice(from, from + 400)}${text.length > from + 400 ? '…' : ''}`;
    throw new Error(`${what}: ${part(one)}, wanted ${part(other)}`);
  }

  /** Looks until what is found `fits`, or the time is up; a plain value cannot change. */
  async waited(look, fits, seconds = PATIENCE) {
    const end = Date.now() + seconds * 1000;
    for (;;) {
      const found = typeof look === 'function' ? await look() : look;
      if (fits(found) || typeof look !== 'function' || Date.now() > end) return { fits: fits(found), found };
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  /** Waits until `probe` returns something true and returns that; fails after `seconds`. */
  async until(what, probe, seconds = PATIENCE) {
    const end = Date.now() + seconds * 1000;
    for (;;) {
      const found = await probe();
      if (found) return found;
      if (Date.now() > end) throw new Error(`not within ${seconds} s: ${what}`);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  /** A screenshot of the whole page into target/e2e. */
  async shot(name, settings = {}) {
    await mkdir(OUT, { recursive: true });
    return this.page.screenshot({ path: path.join(OUT, `${name}.png`), fullPage: true, ...settings });
  }

  /** Holds an element's picture against its golden. */
  async golden(name, locator, tolerance) {
    const look = async () => matchGolden(name, await locator.screenshot({ animations: 'disabled' }), tolerance);
    const { fits, found } = await this.waited(look, (wrong) => !wrong);
    if (!fits) throw new Error(`picture ${name}: ${found}`);
  }

  /** Fails on any violation that axe finds in the view as it stands. */
  async accessible(view) {
    await this.page.evaluate(await readFile(axeFile, 'utf8'));
    const look = () => this.page.evaluate(async () => {
      const { violations } = await globalThis.axe.run(document, { resultTypes: ['violations'] });
      return violations.map(({ id, help, nodes }) => `${id}: ${help}: ${nodes.map((n) => n.html).join(' | ')}`);
    });
    await this.equal(look, [], `axe on ${view}`);
  }

  /** Fails when the page is wider than its window. */
  async fits(view) {
    const look = () => this.page.evaluate(() => [
      document.documentElement.clientWidth,
      document.documentElement.scrollWidth,
    ]);
    const { fits, found: [inner, wide] } = await this.waited(look, ([window, page]) => page <= window);
    if (!fits) throw new Error(`${view} is ${wide} pixels wide in a window of ${inner}`);
  }

  /** Runs the native command line; returns what it wrote and its exit status. */
  async groundling(...args) {
    const binary = path.join(process.env.CARGO_TARGET_DIR ?? path.join(root, 'target'), 'debug/groundling');
    try {
      const { stdout, stderr } = await promisify(execFile)(binary, args, { cwd: root, maxBuffer: 1 << 28 });
      return { status: 0, stdout, stderr };
    } catch (error) {
      if (typeof error.code !== 'number') throw error;
      return { status: error.code, stdout: error.stdout, stderr: error.stderr };
    }
  }
}

/** Runs in the page before any of its scripts: reports broken content policy, remembers the workers and what is said aloud. */
function watch() {
  document.addEventListener('securitypolicyviolation', (event) => {
    console.error(`content policy: ${event.effectiveDirective} ${event.blockedURI} ${event.sourceFile}:${event.lineNumber} ${event.sample}`);
  });
  const Original = globalThis.Worker;
  globalThis.flowWorkers = [];
  globalThis.Worker = class extends Original {
    constructor(...args) {
      super(...args);
      globalThis.flowWorkers.push(this);
    }
  };
  globalThis.flowSaid = [];
  const note = (element) => {
    if (element.textContent !== '') globalThis.flowSaid.push(element.textContent);
  };
  new MutationObserver((_, finding) => {
    const element = document.querySelector('[data-testid="announcement"]');
    if (!element) return;
    finding.disconnect();
    note(element);
    new MutationObserver(() => note(element)).observe(element, { subtree: true, childList: true, characterData: true });
  }).observe(document, { subtree: true, childList: true });
}
