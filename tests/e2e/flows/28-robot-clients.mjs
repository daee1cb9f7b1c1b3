// The frames of roslib, the usual client in JavaScript: the same as the page's, and either reads what the other sends.

import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { flow } from '../flow.mjs';
import { packageFolder, root } from '../packages.mjs';
import { openRobot, startPeer } from '../robot.mjs';

/** What a frame is made of: its fields with the kinds of their values, those of a message left out; and what its id begins with. */
function shape({ id, msg, ...frame }) {
  const fields = Object.entries({ ...frame, ...(msg && { msg }) }).map(([name, value]) => `${name}:${typeof value}`);
  return [...fields.sort(), id?.split(':').slice(0, -1).join(':')].join(' ');
}

flow('roslib and the page send the same frames, and each reads the other’s', async (t) => {
  const { Ros, Service, Topic } = await import(pathToFileURL(path.join(packageFolder('roslib'), 'dist/RosLib.js')));
  const ours = (await readFile(path.join(root, 'tests/data/robot/frames.jsonl'), 'utf8')).trim().split('\n').map((line) => JSON.parse(line));
  const peer = await startPeer();
  const ros = new Ros({ url: peer.address });
  try {
    await new Promise((resolve, reject) => {
      ros.on('connection', resolve);
      ros.on('error', reject);
    });
    // Produced: what it sends for the same is the same.
    const from = peer.frames.length;
    const typeOf = new Service({ ros, name: '/rosapi/topic_type', serviceType: 'rosapi/TopicType' });
    const asked = (topic) => new Promise((resolve, reject) => { typeOf.callService({ topic }, resolve, reject); });
    // Accepted: an answer that the page's own code has written.
    const answers = [await asked('/cmd_vel'), await asked('/odom')].map(({ type }) => type);
    await t.equal(answers, ['geometry_msgs/msg/TwistStamped', 'nav_msgs/msg/Odometry'], 'its answers');
    const odometry = new Topic({ ros, name: '/odom', messageType: 'nav_msgs/msg/Odometry', queue_length: 1 });
    const seen = await new Promise((resolve) => { odometry.subscribe(resolve); });
    await t.check(Math.abs(seen.pose.pose.position.x - 3) < 0.2, `a pose of ${JSON.stringify(seen)}`);
    const velocity = new Topic({ ros, name: '/cmd_vel', messageType: 'geometry_msgs/msg/TwistStamped', queue_size: 1 });
    velocity.advertise();
    velocity.publish(ours.find(({ op }) => op === 'publish').msg);
    velocity.unadvertise();
    await t.equal(() => peer.frames.slice(from).map(({ frame }) => shape(frame)), ours.map(shape), 'its frames');
    const sent = peer.frames.slice(from).find(({ frame }) => frame.op === 'publish').frame.msg;
    await t.equal(sent, ours.find(({ op }) => op === 'publish').msg, 'a velocity, as it came in');

    // The page reads poses that it sends, and it reads velocities that the page sends.
    const camera = new Topic({ ros, name: '/camera/pose', messageType: 'geometry_msgs/msg/PoseStamped' });
    camera.advertise();
    const shown = setInterval(() => camera.publish({
      header: { stamp: { sec: 0, nanosec: 0 }, frame_id: 'world' },
      pose: { position: { x: 4, y: 1, z: 0 }, orientation: { x: 0, y: 0, z: 1, w: 0 } },
    }), 50);
    const heard = [];
    new Topic({ ros, name: '/cmd_vel', messageType: 'geometry_msgs/msg/TwistStamped' }).subscribe((message) => heard.push(message));
    const robot = await openRobot(t);
    await robot.press('real');
    await robot.by('topics').locator('summary').click();
    await robot.by('pose').fill('/camera/pose');
    await robot.by('address').fill(peer.address);
    await robot.press('link');
    await robot.finds('poses', 'good');
    await robot.press('here');
    await robot.finds('placed', 'good');
    await robot.press('try');
    await robot.hold();
    await robot.underway('it is turned, as roslib sees it', () => heard.some(({ twist }) => twist.angular.z === 0.5));
    clearInterval(shown);
    await robot.at('halted');
    await t.equal(() => heard.slice(-3).map(({ twist }) => [twist.linear.x, twist.angular.z]), [[0, 0], [0, 0], [0, 0]], 'and stopped');
  } finally {
    ros.close();
    peer.end();
  }
});
