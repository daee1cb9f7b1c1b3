#!/bin/sh
# Draws the golden images of tests/browser/picture.rs anew, from what its failing tests print. Needs what
# `make test` has installed on PATH.
set -eu
cd "$(dirname "$0")/../.."
names=$(sed -n 's/.*is_golden("\([a-z-]*\.png\)".*/\1/p' tests/browser/picture.rs)
out=$(mktemp)
trap 'rm -f "$out"' EXIT
for name in $names; do
    : > "tests/data/golden/$name"
done
cargo test --target wasm32-unknown-unknown --test browser_picture > "$out" 2>&1 || true
for name in $names; do
    sed -n "s/.*golden $name data:image.png;base64,//p" "$out" | head -n 1 | tr -d ' \r' |
        base64 -d > "tests/data/golden/$name"
    ls -l "tests/data/golden/$name"
done
