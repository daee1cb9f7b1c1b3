// Makes the table of shades: `node shades.mjs NODE_MODULES PALETTE` writes the file to standard output. A shade is a
// name of CSS's (npm color-name); what it is like are the nine colours as the page paints things of them (PALETTE is
// src/render/palette.rs). How much: 1000 for the very colour, nothing for what no one takes it for.

import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';
import path from 'node:path';

const [modules, palette] = process.argv.slice(2);
const from = createRequire(path.resolve(modules, 'shades.cjs'));
const names = from('color-name').default;
const { version } = JSON.parse(readFileSync(path.join(modules, 'color-name/package.json'), 'utf8'));

/** The distance beyond which a shade is not like a colour at all. */
const FAR = 0.58;
/** How much lightness counts beside hue and chroma: a name of a colour covers light and dark. */
const LIGHTNESS = 0.8;
/** The least chroma (of CIELAB, in hundreds) of a shade; what has less is grey, black or white, like none of the nine. */
const LEAST_CHROMA = 0.1;
/** The weight of chroma beside lightness. */
const CHROMA = 0.7;

/** The components of a colour of sRGB in CIELAB (D65), in hundreds. */
function lab(rgb) {
  const [r, g, b] = rgb.map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
  const [x, y, z] = [
    (0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047,
    0.2126729 * r + 0.7151522 * g + 0.072175 * b,
    (0.0193339 * r + 0.119192 * g + 0.9503041 * b) / 1.08883,
  ].map((t) => (t > 216 / 24389 ? Math.cbrt(t) : ((24389 / 27) * t + 16) / 116));
  return { l: (116 * y - 16) / 100, a: 5 * (x - y), b: 2 * (y - z) };
}

/** A place in which distances are like those between names: the root of chroma, so that pale pinks are pinks. */
function place({ l, a, b }) {
  const chroma = Math.hypot(a, b);
  const root = chroma > 0 ? Math.sqrt(CHROMA / chroma) : 0;
  return [LIGHTNESS * l, a * root, b * root];
}

const rows = readFileSync(palette, 'utf8').split('pub const fn object')[1].split('pub const fn')[0];
const painted = [...rows.matchAll(/Color::(\w+) => self\.pick\(0x(\w{6})/g)].map(([, name, hex]) => {
  const rgb = [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16));
  return { name: name.toLowerCase(), place: place(lab(rgb)) };
});

function likeness(shade, own, color) {
  const distance = Math.hypot(...own.map((part, at) => part - color.place[at]));
  // A light blue is a blue: what the name ends in says the kind.
  const far = shade.endsWith(color.name) ? distance / 2 : distance;
  return Math.round(1000 * (1 - far / FAR));
}

const lines = Object.entries(names)
  .filter(([shade]) => !painted.some(({ name }) => name === shade))
  .map(([shade, rgb]) => [shade, lab(rgb)])
  .filter(([, { a, b }]) => Math.hypot(a, b) >= LEAST_CHROMA)
  .map(([shade, own]) => {
    const like = painted
      .map((color) => [color.name, likeness(shade, place(own), color)])
      .filter(([, value]) => value > 0)
      .sort(([, a], [, b]) => b - a);
    return `${shade} ${like.map(([name, value]) => `${name}:${value}`).join(' ')}`;
  })
  .sort();

console.log(`# Shades, and how much each is like the nine colours, of 1000: made by \`make words\`, not to be changed by hand.
# The names are CSS's, from npm color-name ${version}, Copyright (c) 2015 Dmitry Ivanov, MIT: COLOR-NAME-LICENSE.`);
console.log(lines.join('\n'));
