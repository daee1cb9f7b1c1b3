#!/usr/bin/env bash
# ltlf-chained-arrow: "a -> b -> c" is read from the left by NLTK and flloat, and a chain of <-> means different
# things in the two.
#
# Versions: PyPI nltk 3.10.4 (nltk.sem.logic), PyPI flloat 0.3.0 (LTL on finite traces) with lark-parser 0.12.0.
# Guess: implication associates to the right, as in most textbooks and proof assistants, so the chain is
#   a -> (b -> c); and a chain of <-> may be bracketed either way, as equivalence is associative.
# Behaviour: both read (a -> b) -> c, which is false where nothing holds, where the usual reading is true. flloat
#   prints the chain flat, as it was written, so the print does not tell. Its "a <-> b <-> c" is "all three alike",
#   which is neither bracketing; NLTK's is the left bracketing.
# Why it matters: conditions in a task's specification are just such chains.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check nltk==3.10.4 flloat==0.3.0 lark-parser==0.12.0

seen=$("$tmp/venv/bin/python" - <<'PY'
from itertools import product
from flloat.parser.ltlf import LTLfParser
from nltk.sem.logic import Expression
read = LTLfParser()

def true_in(text):
    """The one-step traces, as the values of a, b and c, in which it holds."""
    rows = ("".join(bits) for bits in product("FT", repeat=3))
    return " ".join(r for r in rows if read(text).truth([dict(zip("abc", (x == "T" for x in r)))], 0))

for op in ("->", "<->"):
    chain, left, right = (t.replace("o", op) for t in ("a o b o c", "(a o b) o c", "a o (b o c)"))
    print("nltk", chain, "is", Expression.fromstring(chain))
    print("flloat prints", read(chain))
    for text in (chain, left, right):
        print("flloat", text, "holds in", true_in(text))
PY
)
expected=$(cat <<'EOF'
nltk a -> b -> c is ((a -> b) -> c)
flloat prints (a -> b -> c)
flloat a -> b -> c holds in FFT FTT TFF TFT TTT
flloat (a -> b) -> c holds in FFT FTT TFF TFT TTT
flloat a -> (b -> c) holds in FFF FFT FTF FTT TFF TFT TTT
nltk a <-> b <-> c is ((a <-> b) <-> c)
flloat prints (a <-> b <-> c)
flloat a <-> b <-> c holds in FFF TTT
flloat (a <-> b) <-> c holds in FFT FTF TFF TTT
flloat a <-> (b <-> c) holds in FFT FTF TFF TTT
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'ltlf-chained-arrow: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
