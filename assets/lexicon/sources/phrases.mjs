// The words before an entry of a lexicon: `|` parts phrases, and in parentheses ways to go on with one.

/** Every phrase that a text stands for: "(go|move) in | enter" for three. */
export function phrases(text) {
  const expanded = (phrase) => {
    const group = /\(([^()]*)\)/.exec(phrase);
    return group ? group[1].split('|').flatMap((part) => expanded(phrase.replace(group[0], part))) : [phrase];
  };
  return text.split(/\|(?![^(]*\))/).flatMap(expanded).map((phrase) => phrase.trim().replace(/ +/g, ' '));
}
