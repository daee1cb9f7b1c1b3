// Sizes of the built site as it travels (brotli): `node sizes.mjs FOLDER` prints them and fails over the limits.
// First view: the HTML, the styles, the app and the engine that talks. What of the app comes late, the renderer, the
// engine that learns, the keeper, the workbench, models and corpora come after it.

import { readdir, readFile } from 'node:fs/promises';
import path from 'node:path';
import zlib from 'node:zlib';

const KB = 1000;
const LIMITS = [
  { what: 'first view', most: 400 * KB, counts: (kind) => kind === 'first' || kind === 'base' },
  { what: 'models', most: 150 * KB, counts: (kind) => kind === 'model' },
  // Aim: 1,800. The workbench and what it asks of the learner came on top of it, what it keeps, studies, driving a
  // robot (200), goals in time, what must not be said the other way round (60), a planner made for speed (50), and messages in people's words (10).
  { what: 'everything the app can load', most: 2775 * KB, counts: (kind) => kind !== 'guide' && kind !== 'collect' },
  // A page of its own, for people who take part in a study: it loads these and nothing else. Aim: 200; what is wrong with a
  // study that was written by hand is said in people's words (1).
  { what: 'first view of collect.html', most: 201 * KB, counts: (kind) => kind === 'collect' || kind === 'base' },
  // Another of its own; the engine that talks comes when it is wanted.
  { what: 'first view of robot.html', most: 250 * KB, counts: (kind, name) => kind === 'robot' || kind === 'base' || name === 'boot.js' },
];

/** When a file of the site is loaded. */
function kindOf(name) {
  if (/^(guide|docs)\//.test(name)) return 'guide';
  if (/_late\./.test(name)) return 'late';
  if (/renderer|scene/.test(name)) return 'renderer';
  if (/learner/.test(name)) return 'learner';
  if (/keeper/.test(name)) return 'keeper';
  if (/workbench/.test(name)) return 'workbench';
  if (/^robot/.test(name)) return 'robot';
  if (name === 'base.css') return 'base';
  if (/^collect|^boot\.js$/.test(name)) return 'collect';
  if (/\.(model|groundling)$|(^|\/)model/.test(name)) return 'model';
  if (/\.(csv|jsonl)$|(^|\/)(worlds|corpus)\//.test(name)) return 'data';
  if (/^help\./.test(name)) return 'later';
  return /\.(html|css|js|wasm)$/.test(name) ? 'first' : 'later';
}

const folder = process.argv[2];
const names = (await readdir(folder, { recursive: true, withFileTypes: true }))
  .filter((entry) => entry.isFile())
  .map((entry) => path.relative(folder, path.join(entry.parentPath, entry.name)))
  .sort();
const files = await Promise.all(names.map(async (name) => {
  const bytes = await readFile(path.join(folder, name));
  return { name, kind: kindOf(name), raw: bytes.length, brotli: zlib.brotliCompressSync(bytes).length };
}));

const kb = (bytes) => `${(bytes / KB).toFixed(1).padStart(8)} KB`;
for (const { name, kind, raw, brotli } of files) {
  console.log(`${kb(raw)} ${kb(brotli)} brotli  ${kind.padEnd(9)} ${name}`);
}
let failed = 0;
for (const { what, most, counts } of LIMITS) {
  const sum = files.filter((file) => counts(file.kind, file.name)).reduce((all, file) => all + file.brotli, 0);
  if (sum > most) failed += 1;
  console.log(`${kb(sum)} of ${kb(most)} brotli  ${what}${sum > most ? ': TOO MUCH' : ''}`);
}
// A site without an app is small and wrong.
const PARTS = [
  /app.*_bg\.wasm$/, /app.*_late\.wasm$/, /learner.*\.wasm$/, /renderer.*\.wasm$/, /keeper.*\.wasm$/, /workbench.*\.wasm$/, /collect.*\.wasm$/, /robot.*\.wasm$/, /\.model$/,
];
for (const part of PARTS) {
  if (!names.some((name) => part.test(name))) {
    failed += 1;
    console.log(`missing: a file like ${part.source}`);
  }
}
console.log(`${LIMITS.length + PARTS.length - failed} passed, ${failed} failed`);
process.exitCode = failed === 0 ? 0 : 1;
