#!/usr/bin/env bash
# ltlf2dfa-without-mona: where the program MONA is missing, ltlf2dfa answers every formula with one and the same
# well-formed automaton.
#
# Version: PyPI ltlf2dfa 2.0.0.
# Guess: MONA does the work, so without it to_dfa raises an error, or returns nothing.
# Behaviour: it returns a Graphviz digraph, the same for "F a", "G a", "a U b" and "false": an accepting node that
#   no edge reaches and a start node with no edge. What went wrong is only printed, as values that could not be
#   found in a text.
# Why it matters: pip installs no MONA. A pipeline from commands to automata runs to its end, and every command has
#   the same unreachable goal.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check ltlf2dfa==2.0.0
mkdir "$tmp/no-programs"

# A PATH with nothing in it stands for a machine without MONA, whatever this one has.
seen=$(PATH="$tmp/no-programs" "$tmp/venv/bin/python" - <<'PY'
import contextlib
import io
from ltlf2dfa.parser.ltlf import LTLfParser
answers = {}
for text in ("F a", "G a", "a U b", "false"):
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        answers[text] = LTLfParser()(text).to_dfa()
    print(f"{text}: a {type(answers[text]).__name__} that starts with {answers[text].split(' ')[0]}, "
          f"names accepting states {'Accepting states' in printed.getvalue()}")
print("different automata:", len(set(answers.values())))
edges = [line.strip() for line in answers["F a"].splitlines() if "->" in line]
print("edges:", edges, "accepting:", answers["F a"].split("doublecircle];")[1].split(";")[0].strip())
PY
)
expected=$(cat <<'EOF'
F a: a str that starts with digraph, names accepting states True
G a: a str that starts with digraph, names accepting states True
a U b: a str that starts with digraph, names accepting states True
false: a str that starts with digraph, names accepting states True
different automata: 1
edges: ['init -> 1;'] accepting: 0.0
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'ltlf2dfa-without-mona: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
