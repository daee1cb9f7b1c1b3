#!/usr/bin/env bash
# compromise-two-seconds: compromise reads "two seconds" as two halves, so the number in "wait two seconds" is 1.
#
# Version: npm compromise 14.17.0.
# Guess: "wait two seconds" holds the number 2, as "wait two minutes" does.
# Behaviour: "seconds" is taken for a denominator, as in "two thirds". The number of "two seconds" is 1, of "three
#   seconds" 1.5, of "ten seconds" and "10 seconds" 5; "two and a half seconds" is 2.5 and minutes and hours are right.
# Why it matters: every duration in a robot command given in seconds is halved, with no sign of it.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
npm install --prefix "$tmp" --loglevel error --no-audit --no-fund --ignore-scripts compromise@14.17.0 >/dev/null

cat > "$tmp/run.js" <<'JS'
const nlp = require('compromise');
for (const text of ['wait two minutes', 'wait two seconds', 'wait three seconds', 'wait ten seconds',
  'wait 10 seconds', 'wait two and a half seconds', 'wait two hours', 'two thirds']) {
  console.log(`${text}: ${JSON.stringify(nlp(text).numbers().get())}`);
}
JS
seen=$(node "$tmp/run.js")
expected=$(cat <<'EOF'
wait two minutes: [2]
wait two seconds: [1]
wait three seconds: [1.5]
wait ten seconds: [5]
wait 10 seconds: [5]
wait two and a half seconds: [2.5]
wait two hours: [2]
two thirds: [0.667]
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'compromise-two-seconds: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
