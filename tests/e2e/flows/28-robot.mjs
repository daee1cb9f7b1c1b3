// Driving a robot: the page's own, and one behind a rosbridge; what stops it; and that the stop is always in reach.

import { flow } from '../flow.mjs';
import { openPage } from '../page.mjs';
import { openRobot, startPeer } from '../robot.mjs';

/** A flow with a peer. */
function peered(title, settings, body) {
  flow(title, settings, async (t) => {
    const peer = await startPeer();
    try {
      await body(t, peer);
    } finally {
      peer.end();
    }
  });
}

/** Linked, calibrated, and allowed to drive. */
async function ready(t, peer) {
  const robot = await openRobot(t);
  await robot.link(peer);
  await robot.press('here');
  await robot.finds('placed', 'good');
  await robot.arm();
  return robot;
}

/** On its way to the blue room. */
async function driving(t, peer) {
  const robot = await ready(t, peer);
  await robot.ask('go to the blue room');
  await moves(robot, peer);
  return robot;
}

/** Holds the key until the base is seen to move: whoever stops it then waits for what is on its way to it. */
async function moves(robot, peer) {
  await robot.drive();
  await robot.underway('the base moves', () => isMoving(peer));
}

const isMoving = async (peer) => (await peer.report()).linear > 0.1;

/** The base stands, and what it was told last is that, three times over. */
async function stands(t, peer) {
  await t.until('the base stands', async () => (await peer.report()).stands, 5);
  const isStopped = () => peer.velocities().slice(-3).flat().every((speed) => speed === 0);
  await t.check(isStopped, () => `told last: ${JSON.stringify(peer.frames.slice(-12))}`);
  const told = peer.velocities().length;
  await new Promise((resolve) => { setTimeout(resolve, 700); });
  // A busy machine may stop it once more.
  const moves = peer.velocities().slice(told).filter(([ahead, turning]) => ahead !== 0 || turning !== 0);
  await t.equal(moves, [], 'it is told to move no more');
}

flow('a simulated robot is looked at, then drives as long as the key is held', { seconds: 300 }, async (t) => {
  const robot = await openRobot(t);
  await t.equal(() => robot.stage(), 'off', 'it is off');
  await t.check(() => robot.by('stop').isDisabled(), 'there is nothing to stop');
  await t.check(() => robot.by('arm').isDisabled(), 'nothing drives before a dry run');
  await t.accessible('the page as it opens');
  await t.shot('robot-first');
  await robot.press('link');
  await robot.finds('placed', 'good');
  await robot.arm();
  await robot.ask('go to the blue room');
  await t.equal(() => robot.by('meant').textContent(), 'The robot is in the blue room.', 'how it was understood');
  await robot.press('rehearse');
  await robot.by('rehearsed').waitFor();
  await t.check(async () => /took \d+ seconds/.test(await robot.by('rehearsed').textContent()), () => robot.by('rehearsed').textContent());
  await robot.drive();
  await t.shot('robot-driving');
  await t.accessible('the page while it drives');
  await robot.pause();
  const [x] = await robot.place();
  await robot.hold();
  await robot.underway('it is there', async () => (await robot.stage()) === 'ready' && (await robot.place())[0] < 3.4, 200);
  await robot.letGo();
  await t.check(x > 3.4, 'it stood on the way');
  await t.check(async () => /Done/.test(await robot.by('stage').textContent()), () => robot.by('stage').textContent());
});

peered('what was done of a sequence is not done again behind a surprise', { seconds: 300 }, async (t, peer) => {
  const robot = await ready(t, peer);
  await robot.ask('go to the red room, then to the blue room');
  await robot.hold();
  const isRed = async () => {
    const { agent: [column, row] } = await peer.report();
    return column > 4 && row > 4;
  };
  await robot.underway('it is in the red room', isRed, 200);
  await robot.underway('it has left it', async () => !(await isRed()), 200);
  // The base is put elsewhere: the page stops, and who has looked lets it go on.
  peer.tell('carry 8 2 west');
  await robot.at('halted');
  await robot.letGo();
  await robot.press('release');
  await robot.finds('placed', 'good');
  await robot.allow();
  await robot.hold();
  let again = false;
  await robot.underway('it is in the blue room', async () => {
    again ||= await isRed();
    return (await robot.stage()) === 'ready' && (await peer.report()).agent[0] < 4;
  }, 200);
  await robot.letGo();
  await t.check(!again, 'it was in the red room once');
});

peered('a robot behind a rosbridge is calibrated by four corners and drives', { seconds: 300 }, async (t, peer) => {
  peer.tell('origin 2 -1 0.7');
  const robot = await openRobot(t);
  await robot.link(peer);
  await t.check(async () => (await robot.found('calibrated')) === 'bad', 'it is not calibrated');
  await robot.press('corners');
  for (const [at, [column, row]] of [[1, 1], [9, 1], [9, 7], [1, 7]].entries()) {
    await t.check(async () => (await robot.by('corner').textContent()).includes(`column ${column}, row ${row}`),
      () => robot.by('corner').textContent());
    peer.tell(`carry ${column} ${row} east`);
    await robot.page.waitForTimeout(1800);
    if (at === 1) await t.accessible('calibration');
    await robot.press('note');
  }
  await t.check(async () => /0\.(49|50|51) m/.test(await robot.by('calibrated').textContent()), () => robot.by('calibrated').textContent());
  peer.tell('carry 8 2 west');
  await robot.finds('placed', 'good');
  await robot.page.waitForTimeout(1500);
  await robot.arm();
  await robot.ask('go to the red room');
  await robot.drive();
  await robot.underway('it is there', async () => (await robot.stage()) === 'ready', 200);
  await robot.letGo();
  const { agent: [column, row], touches } = await peer.report();
  await t.check(column > 4 && row > 4, `it is at ${column}, ${row}`);
  await t.equal(touches, 0, 'walls touched');
  const fastest = Math.max(...peer.velocities().map(([ahead]) => ahead));
  await t.check(fastest > 0.1 && fastest <= 0.18, `at most ${fastest} m/s`);
});

peered('an emergency stop by key, by button and by letting go stops it', { seconds: 300 }, async (t, peer) => {
  const robot = await driving(t, peer);
  await robot.page.keyboard.press('Escape');
  await robot.at('halted');
  await stands(t, peer);
  await t.accessible('a robot that was stopped');
  await t.shot('robot-stopped');
  await robot.letGo();
  await robot.press('release');
  await robot.at('off');
  await robot.allow();
  await moves(robot, peer);
  await robot.press('stop');
  await robot.at('halted');
  await stands(t, peer);
  await robot.letGo();
  await robot.press('release');
  await robot.allow();
  // The button on the page is a dead man's key, too.
  await robot.holdButton();
  await t.until('it drives by the button', async () => {
    if (await robot.stage() === 'driving') return isMoving(peer);
    if (await robot.isTooSlow()) {
      await robot.page.mouse.up();
      await robot.press('release');
      await robot.allow();
      await robot.holdButton();
    }
    return false;
  }, 120);
  await robot.page.mouse.up();
  await t.until('it drives no more', async () => (await robot.stage()) !== 'driving');
  await stands(t, peer);
});

peered('a cable that is pulled stops it, and nothing of before comes after', { seconds: 300 }, async (t, peer) => {
  t.expect(/WebSocket/);
  const robot = await driving(t, peer);
  peer.tell('cut');
  await robot.at('halted', 5);
  await t.check(async () => /No pose came/.test(await robot.by('stage').textContent()), () => robot.by('stage').textContent());
  await t.until('the base stops by itself', async () => (await peer.report()).stands, 5);
  await robot.page.waitForTimeout(1500);
  const from = peer.frames.length;
  peer.tell('mend');
  await robot.page.waitForTimeout(1500);
  const late = peer.velocities(from);
  await t.check(late.length < 12, `${late.length} velocities were on their way`);
  await t.equal(late.slice(-3), [[0, 0], [0, 0], [0, 0]], 'the last of what was on its way');
  await t.check(async () => (await peer.report()).stands, 'it stands');
  await robot.letGo();
  await robot.press('release');
  // A link that closes is opened again, and all is asked for anew.
  peer.tell('close');
  await t.until('the link is gone', async () => (await robot.page.locator('.drive').getAttribute('data-link')) !== 'open');
  const before = peer.frames.length;
  await robot.finds('poses', 'good');
  const ops = () => peer.frames.slice(before).map(({ frame }) => frame.op).sort();
  await t.equal(ops, ['call_service', 'call_service', 'subscribe'], 'what is asked anew');
  await t.equal(() => robot.found('stops'), 'open', 'the base is to be seen to again');
});

peered('a page that is hidden or closed stops it', { seconds: 300 }, async (t, peer) => {
  const robot = await driving(t, peer);
  await robot.page.evaluate(() => {
    Object.defineProperty(document, 'hidden', { configurable: true, get: () => true });
    document.dispatchEvent(new Event('visibilitychange'));
  });
  await robot.at('halted');
  await t.check(async () => /not to be seen/.test(await robot.by('stage').textContent()), () => robot.by('stage').textContent());
  await stands(t, peer);
  await robot.page.evaluate(() => { delete document.hidden; });
  await robot.letGo();
  await robot.press('release');
  await robot.press('arm');
  await moves(robot, peer);
  await robot.page.goto('about:blank');
  await stands(t, peer);
});

peered('what comes in wrong is told apart', {}, async (t, peer) => {
  const robot = await openRobot(t);
  await robot.link(peer);
  const pose = (x) => `{"op":"publish","topic":"/odom","msg":{"pose":{"pose":{"position":{"x":${x},"y":0},"orientation":{"x":0,"y":0,"z":0,"w":1}}}}}`;
  for (const [said, words] of [
    [pose('NaN'), /bare NaN/],
    [pose('null'), /null where a number belongs, in pose\.pose\.position\.x/],
    ['{"op":"status","level":"error","msg":"no such type"}', /the bridge says: no such type/],
  ]) {
    peer.tell(`say ${said}`);
    await t.check(async () => words.test(await robot.by('bad').textContent()), () => robot.by('bad').textContent());
  }
});

peered('a robot is found as it was set up, and it is listed with all that is kept', {}, async (t, peer) => {
  const robot = await openRobot(t);
  await robot.link(peer);
  await robot.press('here');
  await robot.finds('placed', 'good');
  await robot.by('topics').locator('summary').click();
  await robot.press('link');
  await robot.by('velocity').fill('/turtle/cmd_vel');
  // It is kept once nothing has changed for a moment.
  await robot.page.waitForTimeout(1500);
  await robot.page.reload();
  await robot.by('recalled').waitFor();
  await t.check(() => robot.by('real').isChecked(), 'which robot');
  await t.equal(() => robot.by('address').inputValue(), peer.address, 'its address');
  await robot.by('topics').locator('summary').click();
  await t.equal(() => robot.by('velocity').inputValue(), '/turtle/cmd_vel', 'its topic');
  await t.equal(() => robot.stage(), 'off', 'it is off');
  await t.equal(() => robot.found('stops'), 'open', 'and to be looked at again');
  await t.accessible('a robot as it was set up');
  const demo = await openPage(t);
  await demo.press('view-kept');
  const row = demo.by('kept-item').filter({ hasText: 'How your robot is set up' });
  await row.waitFor();
  await row.getByTestId('delete').click();
  await t.until('it is gone', async () => (await row.count()) === 0);
  await robot.page.reload();
  await robot.by('stage').waitFor();
  await robot.page.waitForTimeout(1500);
  await t.check(async () => !(await robot.by('real').isChecked()), 'the page as it is at first');
});

flow('an address that is none is told', {}, async (t) => {
  const robot = await openRobot(t);
  await robot.press('real');
  await robot.by('address').fill('http://robot:9090');
  await robot.press('link');
  await t.check(async () => /ws:\/\//.test(await robot.by('address-fault').textContent()), 'what an address is');
  await t.accessible('a bad address');
});

flow('the stop is always in reach on a phone, in German and in the dark', { viewport: { width: 390, height: 780 }, colorScheme: 'dark', locale: 'de-DE' }, async (t) => {
  const robot = await openRobot(t, { german: true });
  await t.fits('the page');
  await robot.press('link');
  await robot.finds('placed', 'good');
  const seen = () => robot.page.evaluate(() => {
    const { top, bottom, left, right, height } = document.querySelector('[data-testid="stop"]').getBoundingClientRect();
    return top >= 0 && bottom <= innerHeight && left >= 0 && right <= innerWidth && height >= 44;
  });
  for (const share of [0, 0.3, 0.6, 1]) {
    await robot.page.evaluate((part) => scrollTo(0, part * document.documentElement.scrollHeight), share);
    await t.check(seen, `the stop is seen at ${share}`);
  }
  await t.accessible('the page on a phone');
  await t.shot('robot-phone');
  await robot.page.evaluate(() => scrollTo(0, 0));
  await robot.page.screenshot({ path: 'target/e2e/robot-phone-top.png' });
  await robot.press('stop');
  await robot.at('halted');
});
