#!/bin/bash
# fast-downward.sh NAME SEARCH [SECONDS]: Fast Downward on NAME.pddl as worlds.py wrote it: CPU seconds of translator and
# search, length of the plan. PY is the Python of an environment with up-fast-downward 1.0.0 in it.
set -eu
name=$1 search=$2 seconds=${3:-120}
packages=$(${PY:-python3} -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
driver=$packages/up_fast_downward/downward/fast-downward.py
said=$(timeout "$seconds" /usr/bin/time -f 'cpu %U+%S' "${PY:-python3}" "$driver" --sas-file "$name.sas" \
    --plan-file "$name.plan" "$name.domain.pddl" "$name.pddl" --search "$search" 2>&1) || true
echo "$name | $search | $(grep -oE 'Plan length: [0-9]+|Search time: [0-9.]+|Expanded [0-9]+ state|cpu .*|unsolvable' <<<"$said" | tr '\n' ';')"
