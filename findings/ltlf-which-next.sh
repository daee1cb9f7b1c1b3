#!/usr/bin/env bash
# ltlf-which-next: "X a" is the strong next in flloat and the weak next in pylogics, two readers of LTL on finite
# traces.
#
# Versions: PyPI flloat 0.3.0 with lark-parser 0.12.0, PyPI pylogics 0.2.1. Each has a virtual environment of its own,
#   as both bring a Python package named lark.
# Guess: X is the strong next (there is a next step, and a holds there) in both, as in De Giacomo and Vardi's LTLf,
#   and the weak one has another name.
# Behaviour: flloat's X is strong and its weak next is WX. In pylogics X is the weak next, true at the end of every
#   trace, the strong one is "X[!]", and WX is not read at all. So the one text both accept has opposite values
#   at the last step.
# Why it matters: a goal said in one tool's text and planned for with the other's is met by stopping at once.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/flloat"
python3 -m venv "$tmp/pylogics"
"$tmp/flloat/bin/pip" install -q --disable-pip-version-check flloat==0.3.0 lark-parser==0.12.0
"$tmp/pylogics/bin/pip" install -q --disable-pip-version-check pylogics==0.2.1

seen=$("$tmp/flloat/bin/python" - <<'PY'
from flloat.parser.ltlf import LTLfParser
read = LTLfParser()
last_step = [{"a": True}]
for text in ("X a", "WX a"):
    print(f"flloat {text}: at the last step {read(text).truth(last_step, 0)}")
PY
"$tmp/pylogics/bin/python" - <<'PY'
from pylogics.parsers import parse_ltl
for text in ("X a", "X[!] a", "WX a"):
    try:
        print(f"pylogics {text}: {type(parse_ltl(text)).__name__}")
    except Exception as error:
        print(f"pylogics {text}: {type(error).__name__}")
PY
)
expected=$(cat <<'EOF'
flloat X a: at the last step False
flloat WX a: at the last step True
pylogics X a: WeakNext
pylogics X[!] a: Next
pylogics WX a: UnexpectedCharacters
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'ltlf-which-next: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
