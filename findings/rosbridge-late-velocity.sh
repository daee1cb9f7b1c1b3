#!/usr/bin/env bash
# rosbridge-late-velocity: both usual clients of rosbridge keep what is published while there is no link, and send it when
# there is one again; and of a topic that is used both ways they get back one way only.
#
# Version: npm roslib 2.1.0 with ws 8.23.0, PyPI roslibpy 2.1.0.
# Guess: a velocity that is published while the link is down is lost, as one on a topic without a listener is; and after an
#   outage all that was advertised and subscribed to is so again.
# Behaviour: roslib's publish waits for the next connection, and so does roslibpy's: the bridge is then told all of them, in
#   order, however old; roslibpy's even before the topic is advertised again. Of the topic used both ways roslib comes back
#   as a publisher alone, roslibpy as a listener alone.
# Why it matters: a robot drives on by commands of a minute ago; or a page no longer sees where the robot is.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
cd "$tmp"
npm init -y >/dev/null
npm install --silent --ignore-scripts --no-audit --no-fund roslib@2.1.0 ws@8.23.0
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check roslibpy==2.1.0

# A bridge that says what it hears; it goes away at `down` and comes back at `up`.
cat >bridge.mjs <<'JS'
import { createInterface } from 'node:readline';
import { WebSocketServer } from 'ws';
let [server, port, seen] = [null, 0, []];
const up = () => new Promise((resolve) => {
  server = new WebSocketServer({ port, host: '127.0.0.1' }, resolve);
  server.on('connection', (socket) => socket.on('message', (text) => {
    const { op, topic, msg } = JSON.parse(text);
    seen.push(`${op} ${topic}${msg ? ` ${msg.linear.x}` : ''}`);
  }));
});
await up();
({ port } = server.address());
console.log(port);
createInterface({ input: process.stdin }).on('line', async (line) => {
  if (line === 'down') {
    for (const client of server.clients) client.terminate();
    server.close();
  } else if (line === 'up') {
    seen = [];
    await up();
  } else console.log(seen.join(', '));
});
JS
cat >roslib.mjs <<'JS'
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';
import { Ros, Topic } from 'roslib';
const wait = (ms) => new Promise((resolve) => { setTimeout(resolve, ms); });
const bridge = spawn('node', ['bridge.mjs'], { stdio: ['pipe', 'pipe', 'inherit'] });
const lines = createInterface({ input: bridge.stdout })[Symbol.asyncIterator]();
const url = `ws://127.0.0.1:${(await lines.next()).value}`;
const ros = new Ros({ url });
ros.on('error', () => {});
await new Promise((resolve) => { ros.on('connection', resolve); });
const velocity = new Topic({ ros, name: '/cmd_vel', messageType: 'geometry_msgs/Twist' });
const both = new Topic({ ros, name: '/both', messageType: 'std_msgs/String' });
velocity.advertise();
both.advertise();
both.subscribe(() => {});
await wait(300);
bridge.stdin.write('down\n');
await wait(500);
for (const x of [1, 2, 3]) velocity.publish({ linear: { x } });
await wait(1000);
bridge.stdin.write('up\n');
await wait(300);
ros.connect(url);
await wait(1500);
bridge.stdin.write('seen\n');
console.log(`roslib: ${(await lines.next()).value}`);
bridge.kill();
process.exit(0);
JS
cat >client.py <<'PY'
import subprocess
import time
import roslibpy
bridge = subprocess.Popen(["node", "bridge.mjs"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def tell(line):
    bridge.stdin.write(line + "\n")
    bridge.stdin.flush()


ros = roslibpy.Ros("127.0.0.1", int(bridge.stdout.readline()))
ros.run()
velocity = roslibpy.Topic(ros, "/cmd_vel", "geometry_msgs/Twist")
both = roslibpy.Topic(ros, "/both", "std_msgs/String")
velocity.advertise()
both.advertise()
both.subscribe(lambda message: None)
time.sleep(0.5)
tell("down")
time.sleep(1)
for x in (1, 2, 3):
    velocity.publish(roslibpy.Message({"linear": {"x": x}}))
time.sleep(1)
tell("up")
time.sleep(12)
tell("seen")
print("roslibpy:", bridge.stdout.readline().strip())
ros.close()
bridge.kill()
PY
seen=$(node roslib.mjs; venv/bin/python client.py 2>/dev/null)
expected=$(cat <<'TXT'
roslib: advertise /cmd_vel, advertise /both, publish /cmd_vel 1, publish /cmd_vel 2, publish /cmd_vel 3
roslibpy: publish /cmd_vel 1, publish /cmd_vel 2, publish /cmd_vel 3, advertise /cmd_vel, subscribe /both
TXT
)
printf '%s\n' "$seen"
if [ "$seen" != "$expected" ]; then
  printf 'rosbridge-late-velocity: this has changed; it was:\n%s\n' "$expected" >&2
  exit 1
fi
