#!/usr/bin/env bash
# ros-byte-sign: the ROS 2 type byte is signed in rosbags and unsigned in Foxglove's reader, so one message has two
# values.
#
# Versions: PyPI rosbags 0.11.9 with numpy 2.2.6; npm @foxglove/rosmsg2-serialization 3.1.0 with @foxglove/cdr 3.5.0
#   and @foxglove/rosmsg 5.0.5.
# Guess: byte is an octet, 0 to 255; the signed type is called int8. (In ROS 1 byte was an old name of int8; in ROS 2
#   it maps to an octet.)
# Behaviour: rosbags takes byte for int8: it refuses 200, writes -56 as c8 and reads it back as -56. Foxglove's
#   reader makes 200 of the same bytes. Both agree on char (unsigned) and int8 (signed).
# Why it matters: logs of robots are recorded with the one and looked at in the other; a state or level in a byte
#   field differs by 256 from 128 on.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
python3 -m venv "$tmp/venv"
"$tmp/venv/bin/pip" install -q --disable-pip-version-check rosbags==0.11.9 numpy==2.2.6
npm install --prefix "$tmp" --loglevel error --no-audit --no-fund --ignore-scripts \
  @foxglove/rosmsg2-serialization@3.1.0 @foxglove/cdr@3.5.0 @foxglove/rosmsg@5.0.5 >/dev/null

cat > "$tmp/write.py" <<'PY'
from rosbags.typesys import Stores, get_typestore
store = get_typestore(Stores.ROS2_HUMBLE)
for name, value in (("Byte", -56), ("Byte", 200), ("Char", 200), ("Int8", -56)):
    kind = f"std_msgs/msg/{name}"
    try:
        raw = bytes(store.serialize_cdr(store.types[kind](data=value), kind))
        print(name.lower(), value, raw.hex(), store.deserialize_cdr(raw, kind).data)
    except Exception:
        print(name.lower(), value, "-", "refuses")
PY
cat > "$tmp/read.mjs" <<'JS'
import { readFileSync } from 'node:fs';
import { parse } from '@foxglove/rosmsg';
import { MessageReader } from '@foxglove/rosmsg2-serialization';
for (const line of readFileSync(0, 'utf8').trim().split('\n')) {
  const [type, value, hex, back] = line.split(' ');
  const read = () => new MessageReader(parse(`${type} data`, { ros2: true }))
    .readMessage(Uint8Array.from(Buffer.from(hex, 'hex'))).data;
  console.log(`${type} ${value}: rosbags ${back}` + (hex === '-' ? '' : `, bytes ${hex}, foxglove ${read()}`));
}
JS
"$tmp/venv/bin/python" "$tmp/write.py" > "$tmp/messages"
seen=$(cd "$tmp" && node read.mjs < messages)
expected=$(cat <<'EOF'
byte -56: rosbags -56, bytes 00010000c8, foxglove 200
byte 200: rosbags refuses
char 200: rosbags 200, bytes 00010000c8, foxglove 200
int8 -56: rosbags -56, bytes 00010000c8, foxglove -56
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'ros-byte-sign: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
