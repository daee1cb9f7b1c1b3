// Pictures kept as goldens beside the flows, compared with a tolerance; `UPDATE=1` takes them anew.

import { mkdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { PNG, pixelmatch, root } from './packages.mjs';

const GOLDENS = path.join(root, 'tests/e2e/goldens');
const OUT = path.join(root, 'target/e2e');

/**
 * Compares two PNG files' bytes. Colours may differ by `colour` (0 to 1, perceived), and `share` of the
 * pixels by more than that. Returns what is wrong in words (null for nothing) and the picture of it.
 */
export function compare(expected, actual, { colour = 0.1, share = 0.01 } = {}) {
  const [a, b] = [PNG.sync.read(expected), PNG.sync.read(actual)];
  if (a.width !== b.width || a.height !== b.height) {
    return { wrong: `${b.width}×${b.height} pixels, the golden has ${a.width}×${a.height}`, picture: null };
  }
  const picture = new PNG({ width: a.width, height: a.height });
  const other = pixelmatch(a.data, b.data, picture.data, a.width, a.height, { threshold: colour });
  const most = Math.floor(a.width * a.height * share);
  const wrong = other > most ? `${other} pixels differ, at most ${most} may` : null;
  return { wrong, picture: PNG.sync.write(picture) };
}

/** The number of distinct colours in a PNG, to tell a drawing from a blank. */
export function colours(bytes) {
  const { data } = PNG.sync.read(bytes);
  const seen = new Set();
  for (let i = 0; i < data.length; i += 4) seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
  return seen.size;
}

/** Holds `actual` (a PNG) against the golden of this name; returns what is wrong, or null. */
export async function matchGolden(name, actual, tolerance) {
  const golden = path.join(GOLDENS, `${name}.png`);
  await mkdir(OUT, { recursive: true });
  await writeFile(path.join(OUT, `${name}.png`), actual);
  if (process.env.UPDATE) {
    await mkdir(GOLDENS, { recursive: true });
    await writeFile(golden, actual);
    return null;
  }
  let expected;
  try {
    expected = await readFile(golden);
  } catch {
    return `there is no golden ${name}.png; \`make update-goldens\` takes it`;
  }
  const { wrong, picture } = compare(expected, actual, tolerance);
  if (wrong && picture) await writeFile(path.join(OUT, `${name}.diff.png`), picture);
  return wrong && `${wrong} (see target/e2e/${name}.png)`;
}
