#!/usr/bin/env bash
# nltk-binder-scope: in NLTK's logic notation a binder reaches over one term only, so the rest falls outside it.
#
# Version: PyPI nltk 3.10.4 (nltk.sem.logic.Expression.fromstring).
# Guess: the dot of "exists x." and of a lambda reaches as far right as it can, the usual convention; so
#   "exists x.red(x) & block(x)" is closed, and a lambda whose body is an application is still a lambda.
# Behaviour: the body ends at the first connective and even before an argument list. The second x of the first
#   example is free, and a lambda followed by an argument in its own body is read as that lambda applied to it:
#   the x that was meant to be bound escapes, with no error.
# Why it matters: lexicon entries written for another lambda reader load without complaint and mean other things.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check nltk==3.10.4

seen=$("$tmp/venv/bin/python" - <<'PY'
from nltk.sem.logic import Expression
for text in (
    r"exists x.red(x) & block(x)",
    r"exists x.(red(x) & block(x))",
    r"all x.block(x) -> red(x)",
    r"\x.(\y.on(y,x))(x)",
    r"\x.((\y.on(y,x))(x))",
):
    e = Expression.fromstring(text)
    free = ",".join(sorted(v.name for v in e.free())) or "none"
    print(f"{text}  is {type(e).__name__}, free: {free}, simplified: {e.simplify()}")
PY
)
expected=$(cat <<'EOF'
exists x.red(x) & block(x)  is AndExpression, free: x, simplified: (exists x.red(x) & block(x))
exists x.(red(x) & block(x))  is ExistsExpression, free: none, simplified: exists x.(red(x) & block(x))
all x.block(x) -> red(x)  is ImpExpression, free: x, simplified: (all x.block(x) -> red(x))
\x.(\y.on(y,x))(x)  is ApplicationExpression, free: x, simplified: \y.on(y,x)
\x.((\y.on(y,x))(x))  is LambdaExpression, free: none, simplified: \x.on(x,x)
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'nltk-binder-scope: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
