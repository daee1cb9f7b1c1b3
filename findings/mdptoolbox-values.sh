#!/usr/bin/env bash
# mdptoolbox-values: pymdptoolbox's value iteration stops with values far from the optimal ones, and a smaller
# epsilon does not help.
#
# Version: PyPI pymdptoolbox 4.0b3 with numpy 2.2.6 and scipy 1.15.3.
# Guess: after ValueIteration(..., epsilon) ran, V is within about epsilon of the optimal values, as its
#   documentation calls it the optimal value function, and agrees with PolicyIteration.
# Behaviour: it stops once one sweep changes all states alike (the span of the change), which is enough for the
#   policy, and returns V as it then is: short by a constant. On the package's own forest example at a discount of
#   0.9 every value is short by 21, after 4 sweeps, with epsilon 0.01 as with 1e-10.
# Why it matters: the policy is right, so tests of behaviour pass; values shown, compared between planners or used
#   as a heuristic are wrong.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check setuptools numpy==2.2.6 scipy==1.15.3 pymdptoolbox==4.0b3

seen=$("$tmp/venv/bin/python" - <<'PY'
import numpy as np
from mdptoolbox import example, mdp
P, R = example.forest()

def show(name, solver):
    solver.run()
    print(f"{name}: {' '.join(f'{v:.3f}' for v in solver.V)}, policy {tuple(int(a) for a in solver.policy)}, "
          f"{solver.iter} iterations")
    return solver

show("value iteration, epsilon 1e-2", mdp.ValueIteration(P, R, 0.9, epsilon=1e-2))
show("value iteration, epsilon 1e-10", mdp.ValueIteration(P, R, 0.9, epsilon=1e-10))
best = show("policy iteration", mdp.PolicyIteration(P, R, 0.9)).policy
chosen = np.array([P[a][s] for s, a in enumerate(best)])
reward = np.array([R[s][a] for s, a in enumerate(best)])
exact = np.linalg.solve(np.eye(3) - 0.9 * chosen, reward)
print("that policy, solved exactly:", " ".join(f"{v:.3f}" for v in exact))
PY
)
expected=$(cat <<'EOF'
value iteration, epsilon 1e-2: 5.052 8.292 12.292, policy (0, 0, 0), 4 iterations
value iteration, epsilon 1e-10: 5.052 8.292 12.292, policy (0, 0, 0), 4 iterations
policy iteration: 26.244 29.484 33.484, policy (0, 0, 0), 2 iterations
that policy, solved exactly: 26.244 29.484 33.484
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'mdptoolbox-values: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
