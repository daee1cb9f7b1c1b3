// Part of building the site for release (finish.mjs): what a program and its script give each other gets short names in
// both, and scripts (by terser) and styles lose what only people read. Half of wasm-bindgen's names are hashes, which nothing packs.

import { readFile, readdir, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const CUSTOM = 0;
const IMPORTS = 2;
const EXPORTS = 7;
/** The names that wasm-bindgen makes. */
const MADE = /\b(?:__wb|wasm_bindgen__)\w+/g;

/** Reads a program's bytes from a place on. */
class Reader {
  constructor(bytes, at) {
    this.bytes = bytes;
    this.at = at;
  }

  byte() {
    return this.bytes[this.at++];
  }

  number() {
    let [sum, shift, byte] = [0, 0, 0];
    do {
      byte = this.byte();
      sum += (byte & 127) * 2 ** shift;
      shift += 7;
    } while (byte > 127);
    return sum;
  }

  name() {
    const length = this.number();
    this.at += length;
    return this.bytes.subarray(this.at - length, this.at).toString();
  }

  /** Goes over least and perhaps most. */
  limits() {
    const has = this.byte() & 1;
    this.number();
    if (has) this.number();
  }

  /** Goes over what an import is: a function, a table, a memory, or a global. */
  kind() {
    switch (this.byte()) {
      case 0: return this.number();
      case 1: return [this.byte(), this.limits()];
      case 2: return this.limits();
      case 3: return [this.byte(), this.byte()];
      default: throw new Error('an import of no known kind');
    }
  }
}

/** A number as a program writes it. */
function number(value) {
  const bytes = [];
  for (; value > 127; value = Math.floor(value / 128)) bytes.push((value & 127) | 128);
  return Buffer.from([...bytes, value]);
}

const name = (text) => Buffer.concat([number(Buffer.byteLength(text)), Buffer.from(text)]);

/** A program with short names and without what only tools read, and the name that each has now. */
function shortened(program) {
  const names = new Map();
  const short = (long) => {
    if (!long.match(MADE)) return long;
    if (!names.has(long)) names.set(long, `$${names.size.toString(36)}`);
    return names.get(long);
  };
  const entry = (reader, section) => {
    const from = section === IMPORTS ? name(reader.name()) : Buffer.alloc(0);
    const own = name(short(reader.name()));
    const start = reader.at;
    if (section === IMPORTS) reader.kind();
    else [reader.byte(), reader.number()];
    return Buffer.concat([from, own, program.subarray(start, reader.at)]);
  };
  const parts = [program.subarray(0, 8)];
  for (const reader = new Reader(program, 8); reader.at < program.length;) {
    const start = reader.at;
    const section = reader.byte();
    const end = reader.number() + reader.at;
    if (section === IMPORTS || section === EXPORTS) {
      const count = reader.number();
      const body = [number(count), ...Array.from({ length: count }, () => entry(reader, section))];
      const bytes = Buffer.concat(body);
      parts.push(Buffer.from([section]), number(bytes.length), bytes);
    } else if (section !== CUSTOM) {
      parts.push(program.subarray(start, end));
    }
    reader.at = end;
  }
  return { program: Buffer.concat(parts), names };
}

/** A script with these names, as short as it can be said. */
async function shortest(script, names) {
  // Terser is among the packages of tests/e2e (`make packages`), which are not beside this file.
  const tools = path.resolve(process.env.TOOLS ?? fileURLToPath(new URL('../target/tools', import.meta.url)));
  const { minify } = createRequire(path.join(tools, 'node/package.json'))('terser');
  const named = script.replaceAll(MADE, (long) => names.get(long) ?? long);
  return (await minify(named, { module: true, compress: { passes: 2 } })).code;
}

/** Styles without what only people read, in which no text holds such signs. */
const plain = (styles) => styles.replaceAll(/\/\*[^]*?\*\//g, '').replaceAll(/^\s+/gm, '').replaceAll(/(?<=[:;,{]) | (?=\{)/g, '');

const folder = process.env.TRUNK_STAGING_DIR;
if (process.env.TRUNK_PROFILE === 'release') {
  const files = await readdir(folder);
  await Promise.all(files.filter((file) => file.endsWith('.js')).map(async (file) => {
    const at = path.join(folder, file);
    const beside = file.replace(/\.js$/, '_bg.wasm');
    const has = files.includes(beside);
    // The page holds the digest of a script that has a hash for a name (whose zeros at the front are not written) and no
    // program.
    if (!has && /-[0-9a-f]{8,16}\.js$/.test(file)) return;
    const { program, names } = has ? shortened(await readFile(path.join(folder, beside))) : { names: new Map() };
    if (has) await writeFile(path.join(folder, beside), program);
    await writeFile(at, await shortest(await readFile(at, 'utf8'), names));
  }));
  // Those with a hash for a name Trunk has made small.
  await Promise.all(files.filter((file) => /^[a-z]+\.css$/.test(file)).map(async (file) => {
    const at = path.join(folder, file);
    await writeFile(at, plain(await readFile(at, 'utf8')));
  }));
}
