#!/usr/bin/env bash
# nltk-undefined-true: NLTK's model checker answers "Undefined" as a text, which Python takes for true, and whether
# a disjunction is undefined depends on the order of its parts.
#
# Version: PyPI nltk 3.10.4 (nltk.sem.evaluate.Model.evaluate).
# Guess: a formula with a word that the model does not know raises an error, or is None, or false; and | is
#   commutative.
# Behaviour: the answer is the non-empty string "Undefined", for a formula and for its negation alike, so both pass
#   an `if`. "red(b1) | purple(b1)" is True where red(b1) holds; the same with its sides swapped is "Undefined".
# Why it matters: weak supervision tests candidate meanings by their truth in a world; a candidate with an unknown
#   word then passes every test, and so does its opposite.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check nltk==3.10.4

seen=$("$tmp/venv/bin/python" - <<'PY'
from nltk.sem.evaluate import Assignment, Model, Valuation
world = Valuation([("b1", "o1"), ("b2", "o2"), ("red", {"o1"}), ("block", {"o1", "o2"})])
model, empty = Model(world.domain, world), Assignment(world.domain)
for text in ("red(b1)", "red(b2)", "purple(b1)", "-purple(b1)", "red(b9)",
             "red(b1) | purple(b1)", "purple(b1) | red(b1)"):
    answer = model.evaluate(text, empty)
    print(f"{text}: {answer!r}, taken as {bool(answer)}")
PY
)
expected=$(cat <<'EOF'
red(b1): True, taken as True
red(b2): False, taken as False
purple(b1): 'Undefined', taken as True
-purple(b1): 'Undefined', taken as True
red(b9): 'Undefined', taken as True
red(b1) | purple(b1): True, taken as True
purple(b1) | red(b1): 'Undefined', taken as True
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'nltk-undefined-true: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
