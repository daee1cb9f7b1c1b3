#!/usr/bin/env bash
# Every check, one after another; a failure does not stop the rest. A suite's own counts are taken, anything
# else counts as one. Ends with "N passed, N failed" (kept in target/logs/total). Called by `make test`.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

logs=target/logs
wasm=wasm32-unknown-unknown
passed=0
failed=0
mkdir -p "$logs"
rm -f "$logs/total"

# check NAME COMMAND: runs it with its output in NAME's log, adds up what it counted.
check() {
    local name=$1 log="$logs/${1// /-}.log" start=$SECONDS status=0 good bad
    printf '%-28s' "$name"
    bash -euo pipefail -c "$2" >"$log" 2>&1 </dev/null || status=$?
    read -r good bad < <(counts "$log")
    if [ "$((good + bad))" -eq 0 ]; then
        [ "$status" -eq 0 ] && good=1
    fi
    if [ "$status" -ne 0 ] && [ "$bad" -eq 0 ]; then
        bad=1
    fi
    passed=$((passed + good))
    failed=$((failed + bad))
    if [ "$bad" -eq 0 ]; then
        printf 'ok      %4d passed  %4d s\n' "$good" "$((SECONDS - start))"
    else
        printf 'FAILED  %4d passed, %d failed  %4d s  (%s)\n' "$good" "$bad" "$((SECONDS - start))" "$log"
        tail -n 100 "$log" | sed 's/^/    /'
    fi
}

# The counts of a log: Rust's "test result: …" lines, or the last "N passed, N failed".
counts() {
    awk '
        /^test result: / { good += $4; bad += $6; rust = 1 }
        /^[0-9]+ passed, [0-9]+ failed$/ { last_good = $1; last_bad = $3 }
        END { if (rust) print good + 0, bad + 0; else print last_good + 0, last_bad + 0 }
    ' "$1"
}

# The release site takes one core for minutes: it is built beside the checks that need none of it.
built="$logs/built"
rm -f "$built"
{
    trunk build --release --dist "$SITE" >"$logs/building.log" 2>&1 </dev/null
    echo $? >"$built"
} &

check "formatting" "cargo fmt --check"
check "clippy" "cargo clippy --all-targets -- -D warnings"
check "clippy wasm32" "cargo clippy --target $wasm --all-targets -- -D warnings"
check "native tests" "cargo test --no-fail-fast --lib --bins --test suite --test memory && cargo test --doc"
check "documentation" "
    export RUSTDOCFLAGS='-D warnings'
    cargo doc --no-deps --lib --document-private-items
    cargo doc --no-deps --lib --document-private-items --target $wasm"
check "no browser natively" "
    cargo tree --edges normal,build --prefix none >$logs/tree
    ! grep -E '^(wasm-bindgen|web-sys|js-sys|yew|wgpu|gloo)' $logs/tree"
check "browser tests" "cargo test --no-fail-fast --target $wasm --test 'browser_*'"
check "release site" "
    until [ -s '$built' ]; do sleep 1; done
    cat '$logs/building.log'
    test \"\$(cat '$built')\" -eq 0 && test -s '$SITE/index.html'"
check "sizes" "node tests/e2e/sizes.mjs '$SITE'"
# These also run the command line, which the native tests have built; the last a rosbridge of its own, too.
check "lighthouse" "node tests/e2e/lighthouse.mjs '$SITE'"
# One try more keeps a machine that stumbles once among so many pages from refusing a change; who needed it is told.
check "end to end" "cargo build --example peer; AGAIN=1 node tests/e2e/run.mjs"
grep '^needed two tries' "$logs/end-to-end.log" | sed 's/^/    /'

echo "$passed passed, $failed failed" | tee "$logs/total"
[ "$failed" -eq 0 ]
