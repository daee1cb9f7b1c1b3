// The regular forms of English words.

/** A noun's plural, a verb's third person. */
export function withS(word) {
  if (/(s|x|z|ch|sh)$/.test(word)) return `${word}es`;
  return /[^aeiou]y$/.test(word) ? word.replace(/y$/, 'ies') : `${word}s`;
}

// A short vowel doubles the consonant behind it, where the last syllable is stressed: here, in words of one.
const doubled = (word) => (/^[^aeiou]*[aeiou][bdgmnprt]$/.test(word) ? word + word.at(-1) : word);

/** A verb as in "moving". */
export const withIng = (word) => `${doubled(word).replace(/([^eo])e$/, '$1')}ing`;

/** A verb's past. */
export const withEd = (word) => (word.endsWith('e') ? `${word}d` : `${doubled(word).replace(/([^aeiou])y$/, '$1i')}ed`);

/** An adjective's comparative and superlative, if it is one that has them: it has one syllable, or ends in y. */
export const compared = (word) =>
  /^[^aeiou]*[aeiou]+[^aeiou]*e?$|[^aeiou]y$/.test(word) ? ['r', 'st'].map((end) => withEd(word).replace(/d$/, end)) : [];
