#!/usr/bin/env bash
# storm-loose-eventually: in Storm's properties F, G, X and U reach over a whole conjunction, even where brackets follow them.
#
# Versions: PyPI stormpy 2.0.0 (Storm), PyPI flloat 0.3.0 (LTL on finite traces) with lark-parser 0.12.0.
# Guess: a temporal operator of one argument binds tighter than "&", as a negation does and as in Spot, flloat and the
#   grammar of most texts: F a & G !b is (F a) & (G !b), and F(a) & G(!(b)) cannot be anything else.
# Behaviour: Storm reads both as F (a & G !b): the second part is asked for only from where the first holds, so "reach a,
#   never enter b" may pass b on the way. No word of warning; only brackets around each operator with its argument help.
#   A negation in front keeps to one atom: !"b" U … is (!"b") U ….
# Why it matters: public data sets of commands write their formulas as "F(a) & G(!(b))"; exported so, a checker answers
#   another question with a plausible number.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check stormpy==2.0.0 flloat==0.3.0 lark-parser==0.12.0

seen=$("$tmp/venv/bin/python" - <<'PY'
import re
import stormpy
from flloat.parser.ltlf import LTLfParser
read = LTLfParser()

# b at first, then a and no b.
trace = [{"a": False, "b": True, "c": False}, {"a": True, "b": False, "c": False}]
for text in ("F a & G !b", "F(a) & G(!(b))", "(F a) & (G !b)", "F (a & G !b)", "!b U a & F c"):
    quoted = re.sub(r"\b([abc])\b", r'"\1"', text)
    storm = re.search(r"\[.*\]", str(stormpy.parse_properties(f"P=? [{quoted}]")[0])).group()
    print(text, "is", storm, "for Storm;", end=" ")
    print("after b, then a, flloat says", read(text).truth(trace, 0))
PY
)
expected=$(cat <<'EOF'
F a & G !b is [F ("a" & (G !"b"))] for Storm; after b, then a, flloat says False
F(a) & G(!(b)) is [F ("a" & (G !"b"))] for Storm; after b, then a, flloat says False
(F a) & (G !b) is [(F "a") & (G !"b")] for Storm; after b, then a, flloat says False
F (a & G !b) is [F ("a" & (G !"b"))] for Storm; after b, then a, flloat says True
!b U a & F c is [(!"b") U ("a" & (F "c"))] for Storm; after b, then a, flloat says False
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'storm-loose-eventually: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
