// Lighthouse's audits of the built site: `node lighthouse.mjs FOLDER` prints the score of each view on a phone and on
// a desk, and every audit that is not passed. Accessibility and best practices must be at 100.

import { execFileSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import net from 'node:net';
import path from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { chromium, lighthouse, root } from './packages.mjs';
import { serve } from './server.mjs';

/** Audits that may fail, each with the reason. */
const EXPLAINED = {};

/** A study inside a link, as the page makes it. */
function studyLink() {
  const command = path.join(root, 'target/debug/groundling');
  const study = execFileSync(command, ['generate', '--study', 'Six', '--from', 'assets/corpus/six.csv'], { cwd: root });
  return `collect.html#study=${deflateRawSync(study).toString('base64url')}`;
}

/** What is looked at, each with its address. */
const VIEWS = { 'the first view': '', 'the workbench': '#train', 'the page that asks': studyLink(), 'the page that drives a robot': 'robot.html' };
const DEVICES = {
  phone: {},
  desk: {
    formFactor: 'desktop',
    screenEmulation: { mobile: false, width: 1350, height: 940, deviceScaleFactor: 1, disabled: false },
  },
};

/** A port that nothing listens on. */
function freePort() {
  return new Promise((resolve) => {
    const server = net.createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

const options = JSON.parse(await readFile(path.join(root, 'tests/browser/webdriver.json'), 'utf8'));
const { binary, args } = options['goog:chromeOptions'];
const port = await freePort();
const browser = await chromium.launch({
  executablePath: binary, headless: true, args: [...args, `--remote-debugging-port=${port}`],
});
const site = await serve(process.argv[2], { under: '/some/sub-path/' });
let [passed, failed] = [0, 0];
for (const [device, settings] of Object.entries(DEVICES)) {
  for (const [name, view] of Object.entries(VIEWS)) {
    const { lhr } = await lighthouse(`${site.address}${view}`, {
      port, logLevel: 'error', throttlingMethod: 'provided', onlyCategories: ['accessibility', 'best-practices'], ...settings,
    });
    for (const { id, score, auditRefs } of Object.values(lhr.categories)) {
      const counts = auditRefs.filter(({ weight }) => weight > 0).map((ref) => lhr.audits[ref.id]);
      const missed = counts.filter((audit) => audit.score !== null && audit.score < 1);
      const bad = missed.filter((audit) => !(audit.id in EXPLAINED));
      if (bad.length > 0 || score === null) failed += 1; else passed += 1;
      console.log(`${bad.length > 0 ? 'FAILED' : 'ok    '} ${id} of ${name} on a ${device}: ${Math.round(score * 100)}`);
      for (const audit of missed) {
        const items = (audit.details?.items ?? []).map((item) => item.node?.snippet ?? item.description ?? item.source ?? '');
        console.log(`       ${audit.id}: ${EXPLAINED[audit.id] ?? audit.title} ${items.join(' | ')}`);
      }
    }
  }
}
await browser.close();
await site.close();
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed === 0 ? 0 : 1;
