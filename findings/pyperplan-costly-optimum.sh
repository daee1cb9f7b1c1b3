#!/usr/bin/env bash
# pyperplan-costly-optimum: unified-planning's optimal pyperplan does not look at what actions cost, and says "solved
# optimally" of a plan that costs more than three times the least.
#
# Version: PyPI unified-planning 1.3.0, up-pyperplan 1.1.0 with pyperplan 2.1, up-fast-downward 1.0.0.
# Guess: an engine that takes a problem with a metric over costs and answers SOLVED_OPTIMALLY gives a plan that costs
#   least; one that cannot see costs refuses the problem, or says SOLVED_SATISFICING.
# Behaviour: pyperplan-opt gives the plan of fewest actions, costs or not: one flight for 10 where three steps cost 3.
#   Its status is SOLVED_OPTIMALLY, as is that of fast-downward-opt, which gives the three steps. A Python warning says
#   beforehand that it cannot be established whether the engine can solve the problem (supports() is false); the answer
#   keeps nothing of that. The library's own validator calls both plans valid, which says nothing of their cost.
# Why it matters: who compares planners by that status, or takes a length so proved as the reference for another
#   planner's, compares with a wrong number.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check unified-planning==1.3.0 up-pyperplan==1.1.0 pyperplan==2.1 \
    up-fast-downward==1.0.0

cat >"$tmp/domain.pddl" <<'EOF'
(define (domain walk) (:requirements :strips :typing :action-costs)
 (:types place) (:predicates (at ?p - place) (way ?a ?b - place)) (:functions (total-cost) - number)
 (:action go :parameters (?a ?b - place) :precondition (and (at ?a) (way ?a ?b))
  :effect (and (not (at ?a)) (at ?b) (increase (total-cost) 1)))
 (:action fly :parameters (?a ?b - place) :precondition (at ?a)
  :effect (and (not (at ?a)) (at ?b) (increase (total-cost) 10))))
EOF
cat >"$tmp/problem.pddl" <<'EOF'
(define (problem p) (:domain walk) (:objects a b c d - place)
 (:init (at a) (way a b) (way b c) (way c d) (= (total-cost) 0))
 (:goal (at d)) (:metric minimize (total-cost)))
EOF
seen=$("$tmp/venv/bin/python" -W ignore - "$tmp" <<'PY'
import sys
from unified_planning.io import PDDLReader
from unified_planning.shortcuts import OneshotPlanner, PlanValidator, get_environment
get_environment().credits_stream = None
for name in ["fast-downward-opt", "pyperplan-opt"]:
    problem = PDDLReader().parse_problem(f"{sys.argv[1]}/domain.pddl", f"{sys.argv[1]}/problem.pddl")
    with OneshotPlanner(name=name) as planner:
        result = planner.solve(problem)
    with PlanValidator(problem_kind=problem.kind, plan_kind=result.plan.kind) as validator:
        said = validator.validate(problem, result.plan).status.name
    actions = [str(action) for action in result.plan.actions]
    cost = sum(10 if action.startswith("fly") else 1 for action in actions)
    print(f"{name}: {result.status.name}, {said}, cost {cost}: {' '.join(actions)}")
PY
)
expected=$(cat <<'EOF'
fast-downward-opt: SOLVED_OPTIMALLY, VALID, cost 3: go(a, b) go(b, c) go(c, d)
pyperplan-opt: SOLVED_OPTIMALLY, VALID, cost 10: fly(a, d)
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'pyperplan-costly-optimum: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
