#!/usr/bin/env bash
# fast-downward-no-metric: Fast Downward counts every action as 1, whatever it costs, where the problem names no metric.
#
# Version: PyPI up-fast-downward 1.0.0.
# Guess: `(:requirements :action-costs)` and an `(increase (total-cost) N)` in every action make the optimal search look
#   for the plan of least cost.
# Behaviour: without `(:metric minimize (total-cost))` in the problem the costs are dropped by the translator, with
#   no warning: A* calls a flight for 10 the optimum, "cost 1", where three steps cost 3. With that line it finds those.
#   PDDL has it so (without a metric all plans are as good); many problems' authors and generators do not know.
# Why it matters: lengths and costs compared between planners are of another problem than the one that was meant.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check up-fast-downward==1.0.0

cat >"$tmp/domain.pddl" <<'EOF'
(define (domain walk) (:requirements :strips :typing :action-costs)
 (:types place) (:predicates (at ?p - place) (way ?a ?b - place)) (:functions (total-cost) - number)
 (:action go :parameters (?a ?b - place) :precondition (and (at ?a) (way ?a ?b))
  :effect (and (not (at ?a)) (at ?b) (increase (total-cost) 1)))
 (:action fly :parameters (?a ?b - place) :precondition (at ?a)
  :effect (and (not (at ?a)) (at ?b) (increase (total-cost) 10))))
EOF
cat >"$tmp/without.pddl" <<'EOF'
(define (problem p) (:domain walk) (:objects a b c d - place)
 (:init (at a) (way a b) (way b c) (way c d) (= (total-cost) 0))
 (:goal (at d)))
EOF
sed 's/(:goal (at d))/& (:metric minimize (total-cost))/' "$tmp/without.pddl" >"$tmp/with.pddl"
packages=$("$tmp/venv/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
seen=$(for metric in without with; do
  "$tmp/venv/bin/python" "$packages/up_fast_downward/downward/fast-downward.py" --sas-file "$tmp/$metric.sas" \
      --plan-file "$tmp/$metric.plan" "$tmp/domain.pddl" "$tmp/$metric.pddl" --search 'astar(blind())' >"$tmp/log" 2>&1
  echo "$metric a metric: $(tr '\n' ' ' <"$tmp/$metric.plan")"
  grep -ci 'warning' "$tmp/log" | sed 's/^/  warnings: /' || true
done)
expected=$(cat <<'EOF'
without a metric: (fly a d) ; cost = 1 (unit cost) 
  warnings: 0
with a metric: (go a b) (go b c) (go c d) ; cost = 3 (general cost) 
  warnings: 0
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'fast-downward-no-metric: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
