#!/usr/bin/env bash
# nltk-alpha-hash: NLTK's logical forms that are equal have unequal hashes, and forms that print alike are unequal.
#
# Version: PyPI nltk 3.10.4 (nltk.sem.logic).
# Guess: == is equality up to renaming of bound variables (it is), so a set keeps one of two such forms; and a
#   form that is printed and read again is the same form.
# Behaviour: the hash is that of the printed text, bound names and all, so a set or a dict keeps both of two equal
#   forms. The printer leaves out the nesting of & and of |, which == does compare: "a & (b & c)" comes back from
#   its own print as "(a & b) & c" and no longer equals itself.
# Why it matters: counting distinct readings, caching by logical form, or judging a parse against a gold form that
#   went through a file, counts wrong, silently and differently by luck of the variable names.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check nltk==3.10.4

seen=$("$tmp/venv/bin/python" - <<'PY'
from nltk.sem.logic import Expression
read = Expression.fromstring
a, b = read(r"\x.red(x)"), read(r"\y.red(y)")
print("renamed: equal", a == b, "| same hash", hash(a) == hash(b), "| kept by a set", len({a, b}))
a = read("big(b1) & (red(b1) & block(b1))")
b = read(str(a))
print("printed and read again: same text", str(a) == str(b), "| equal", a == b, "| text", a)
PY
)
expected=$(cat <<'EOF'
renamed: equal True | same hash False | kept by a set 2
printed and read again: same text True | equal False | text (big(b1) & red(b1) & block(b1))
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'nltk-alpha-hash: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
