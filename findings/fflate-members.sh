#!/usr/bin/env bash
# fflate-members: fflate's one-call gunzip gives, of a gzip file with two members, the first member cut to the
# length of the last.
#
# Versions: npm fflate 0.8.3, with npm pako 3.0.3 as the peer.
# Guess: members are joined, as gzip does, and as pako does and fflate's own streaming Gunzip does; or, at worst, the
#   whole first member is given.
# Behaviour: gunzipSync makes a buffer of the length that stands in the file's last four bytes, which are those of
#   the last member, and fills it from the first: of "the red block" followed by "robot" it gives "the r". No error.
# Why it matters: a corpus or log that is compressed in pieces and appended to is valid gzip; it comes out short in
#   the browser.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
npm install --prefix "$tmp" --loglevel error --no-audit --no-fund --ignore-scripts fflate@0.8.3 pako@3.0.3 >/dev/null

cat > "$tmp/run.mjs" <<'JS'
import { Gunzip, gunzipSync, gzipSync, strFromU8, strToU8 } from 'fflate';
import { ungzip } from 'pako';
for (const parts of [['the red block', 'robot'], ['robot', 'the red block']]) {
  const file = Buffer.concat(parts.map((part) => gzipSync(strToU8(part))));
  let streamed = '';
  new Gunzip((chunk) => { streamed += strFromU8(chunk); }).push(file, true);
  console.log(`${parts.join(' + ')}: pako "${strFromU8(ungzip(file))}", fflate streamed "${streamed}", `
    + `fflate in one call "${strFromU8(gunzipSync(file))}"`);
}
JS
seen=$(cd "$tmp" && node run.mjs)
expected=$(cat <<'EOF'
the red block + robot: pako "the red blockrobot", fflate streamed "the red blockrobot", fflate in one call "the r"
robot + the red block: pako "robotthe red block", fflate streamed "robotthe red block", fflate in one call "robot"
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'fflate-members: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
