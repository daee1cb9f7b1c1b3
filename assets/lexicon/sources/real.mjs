// Real words that are spelt like words of the seed lexicon, so that none is taken for a misspelling (src/ccg/spelling.rs):
// those of WordNet that people know, by its counts and its glosses, and what real.txt adds.

import { compared, withEd, withIng, withS } from './forms.mjs';

/** Letters below which a word is taken as it stands, and from which it may be two edits away. */
const [SHORTEST, LONG] = [4, 8];
/** How often a word is written to be one that people know. */
const OFTEN = 2;

/** A lemma's regular forms. */
function forms(kind, lemma) {
  if (kind === 'n') return lemma.endsWith('ing') ? [] : [withS(lemma)];
  if (kind === 'v') return [withS(lemma), withIng(lemma), withEd(lemma)];
  return kind === 'a' ? compared(lemma) : [];
}

/** Edits between two words: insertions, deletions, substitutions, swaps of neighbours (Damerau and Levenshtein). */
function edits(a, b) {
  const most = a.length + b.length;
  const table = Array.from({ length: a.length + 2 }, () => new Array(b.length + 2).fill(most));
  for (let i = 0; i <= a.length; i += 1) table[i + 1][1] = i;
  for (let j = 0; j <= b.length; j += 1) table[1][j + 1] = j;
  const rows = new Map();
  for (let i = 1; i <= a.length; i += 1) {
    let column = 0;
    for (let j = 1; j <= b.length; j += 1) {
      const row = rows.get(b[j - 1]) ?? 0;
      const swapped = table[row][column] + (i - row - 1) + 1 + (j - column - 1);
      const isSame = a[i - 1] === b[j - 1];
      table[i + 1][j + 1] = Math.min(table[i][j] + (isSame ? 0 : 1), table[i + 1][j] + 1, table[i][j + 1] + 1, swapped);
      if (isSame) column = j;
    }
    rows.set(a[i - 1], i);
  }
  return table[a.length + 1][b.length + 1];
}

/** The letters of a word, a bit each: two words of which more differ than edits change are not compared at all. */
const letters = (word) => [...word].reduce((bits, letter) => bits | (1 << (letter.charCodeAt(0) & 31)), 0);
const bits = (set) => (set ? (set & 1) + bits(set >>> 1) : 0);

/**
 * The real words that would be heard as others, of those `known` to the seed lexicon: WordNet's, and `more`, but for those
 * that are `misspelt`.
 */
export function realWords(net, known, more, misspelt) {
  const targets = [...known].filter((word) => word.length >= SHORTEST).map((word) => ({ word, letters: letters(word) }));
  const [real, lemmas] = [new Set(more), new Map()];
  for (const kind of ['n', 'v', 'a', 'r']) {
    for (const lemma of net.lemmas(kind)) {
      const [isKnown, times] = [net.total(kind, lemma) > 0, net.written.get(lemma) ?? 0];
      if (isKnown || times > 0) real.add(lemma);
      for (const form of [lemma, ...forms(kind, lemma)]) {
        if (isKnown && times >= OFTEN && kind !== 'a' || net.written.has(form)) real.add(form);
        lemmas.set(form, (lemmas.get(form) ?? new Set()).add(lemma));
      }
    }
  }
  for (const [word, times] of net.written) if (times >= OFTEN && /^[a-z]+$/.test(word)) real.add(word);
  // "Chairs" may be heard as "chair": a form of a word is no other. Nor is "centre" another than "center".
  const first = (word) => ['n', 'v', 'a', 'r'].flatMap((kind) => net.senses(kind, word).slice(0, 1));
  const isSame = (word, other) => first(word).some((id) => first(other).includes(id))
    || [...lemmas.get(word) ?? []].some((lemma) => lemmas.get(other)?.has(lemma));
  return [...real].filter((word) => {
    if (!/^[a-z']+$/.test(word) || word.length < SHORTEST || known.has(word) || misspelt.has(word)) return false;
    const bound = word.length < LONG ? 1 : 2;
    const own = letters(word);
    const near = targets.filter((target) => bits(target.letters ^ own) <= 2 * bound && edits(word, target.word) <= bound);
    return near.some((target) => !isSame(word, target.word));
  });
}
