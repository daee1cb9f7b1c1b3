#!/usr/bin/env bash
# colour-without-teal: of the 147 colour names of CSS 3, the PyPI package colour knows all but one, and that is teal.
#
# Versions: PyPI colour 0.1.5, PyPI webcolors 25.10.0 for the list.
# Guess: a package of the web's colour names has all of them, or lacks only what came later (rebeccapurple); and a
#   colour of which two can be compared can also be put in a set.
# Behaviour: teal, one of the sixteen names since HTML 3.2, raises a ValueError, and #008080 has no name; the other
#   names agree with CSS. A Color has == but no hash, so a set or a dict of colours raises a TypeError.
# Why it matters: a vocabulary of colour words checked by this table loses a basic one, and only that one.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check colour==0.1.5 webcolors==25.10.0

seen=$("$tmp/venv/bin/python" - <<'PY'
import webcolors
from colour import Color
names = sorted(webcolors.names(webcolors.CSS3))
unknown, other = [], []
for name in names:
    try:
        if Color(name).hex_l != webcolors.name_to_hex(name):
            other.append(name)
    except ValueError:
        unknown.append(name)
print(len(names), "names; unknown to colour:", unknown, "| of another value:", other)
print("#008080 is called", Color("#008080").web, "| #000080 is called", Color("#000080").web)
print("equal:", Color("red") == Color("#f00"))
try:
    print("in a set:", len({Color("red"), Color("#f00")}))
except TypeError as error:
    print("in a set:", type(error).__name__)
PY
)
expected=$(cat <<'EOF'
147 names; unknown to colour: ['teal'] | of another value: []
#008080 is called #008080 | #000080 is called navy
equal: True
in a set: TypeError
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'colour-without-teal: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
