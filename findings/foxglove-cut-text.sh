#!/usr/bin/env bash
# foxglove-cut-text: Foxglove's writer of ROS 2 messages cuts text that is not ASCII, by one byte for each byte more
# than letters, and writes a single accented letter as a zero byte.
#
# Versions: npm @foxglove/rosmsg2-serialization 3.1.0 with @foxglove/cdr 3.5.0 and @foxglove/rosmsg 5.0.5.
# Guess: a string field is written as UTF-8 with its length in bytes, as the reader of the same package expects.
# Behaviour: the room made is of as many bytes as the text has UTF-16 units, and UTF-8 is written into it as far as
#   whole characters fit; what is left over stays zero. There is no error, the fields after it are intact, and the
#   reader gives the shorter text back, with zero characters at its end.
# Why it matters: a command is text; "cafe" with its accent loses the last letter on the way to the robot.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
npm install --prefix "$tmp" --loglevel error --no-audit --no-fund --ignore-scripts \
  @foxglove/rosmsg2-serialization@3.1.0 @foxglove/cdr@3.5.0 @foxglove/rosmsg@5.0.5 >/dev/null

cat > "$tmp/run.mjs" <<'JS'
import { parse } from '@foxglove/rosmsg';
import { MessageReader, MessageWriter } from '@foxglove/rosmsg2-serialization';
const definition = parse('string text\nuint8 after', { ros2: true });
const writer = new MessageWriter(definition), reader = new MessageReader(definition);
for (const text of ['hello', 'na\u00efve robot', 'caf\u00e9', '\u00e9', '\u65e5\u672c']) {
  const bytes = writer.writeMessage({ text, after: 7 });
  const back = reader.readMessage(bytes);
  const written = new DataView(bytes.buffer, bytes.byteOffset).getUint32(4, true) - 1;
  console.log(`${JSON.stringify(text)} comes back as ${JSON.stringify(back.text)}, after it ${back.after}; `
    + `bytes ${Buffer.from(text).length}, written ${written}`);
}
JS
seen=$(cd "$tmp" && node run.mjs)
expected=$(cat <<'EOF'
"hello" comes back as "hello", after it 7; bytes 5, written 5
"naïve robot" comes back as "naïve robo", after it 7; bytes 12, written 11
"café" comes back as "caf\u0000", after it 7; bytes 5, written 4
"é" comes back as "\u0000", after it 7; bytes 2, written 1
"日本" comes back as "\u0000\u0000", after it 7; bytes 6, written 2
EOF
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'foxglove-cut-text: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
