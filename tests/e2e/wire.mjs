// Messages to and from an engine, as far as the flows that measure need them: postcard's form (`protocol/wire.rs`), fields
// in order without names. A test that reads wrong bytes fails loudly, so nothing here is checked.

const VERSION = 13;
/** Places of the kinds in `Request` and `Event`. */
const REQUESTS = { plan: 6, values: 7, roll_out: 8 };
const EVENTS = { 9: 'planning', 10: 'planned', 11: 'values', 12: 'rolling_out', 13: 'rolled_out' };

/** Kinds of events that answer nothing: news of planning, or of runs. */
export const NEWS = ['planning', 'rolling_out'].map((name) => Number(Object.keys(EVENTS).find((kind) => EVENTS[kind] === name)));

/** A whole number, seven bits a byte, the lowest first. */
function whole(n) {
  return n < 128 ? [n] : [(n & 127) | 128, ...whole(Math.floor(n / 128))];
}

/** A number that may be negative: its sign in the lowest bit. */
const signed = (n) => whole(n < 0 ? -2 * n - 1 : 2 * n);
const text = (string) => { const bytes = new TextEncoder().encode(string); return [...whole(bytes.length), ...bytes]; };
const float = (x) => [...new Uint8Array(new Float64Array([x]).buffer)];
const flag = (yes) => [Number(yes)];
const option = (value, write) => (value === undefined ? [0] : [1, ...write(value)]);
const list = (all, write) => [...whole(all.length), ...all.flatMap(write)];
const bounds = ({ left, bottom, right, top }) => [left, bottom, right, top].flatMap(signed);

const state = ({ agent, rooms, doors, objects }) => [
  ...signed(agent.x), ...signed(agent.y), ...text(agent.direction),
  ...list(rooms, (room) => [...text(room.name), ...text(room.color), ...bounds(room)]),
  ...list(doors, (door) => [...text(door.name), ...bounds(door), ...text(door.lock)]),
  ...list(objects, ({ name, shape, color, size, x, y }) =>
    [...text(name), ...text(shape), ...text(color), ...option(size, text), ...signed(x), ...signed(y)]),
];

const rules = ({ pull, robot, landmarks_stay, slip, lock, loss, luck }) =>
  [...[pull, robot, landmarks_stay].flatMap(flag), ...[slip, lock, loss].flatMap(float), ...whole(luck)];

const BODIES = {
  // From where it was said.
  plan: (body) => [...text(body.form), ...list([body.state], state), ...rules(body.rules)],
  // Of no task over time: no step of one is done.
  values: (body) => [...state(body.state), 0],
  roll_out: (body) => [...whole(body.runs), ...whole(body.seed)],
};

/** The bytes of a request such as `{ values: { state } }`. */
export function encode(request) {
  const [[kind, body]] = Object.entries(request);
  return [...whole(VERSION), 1, REQUESTS[kind], ...BODIES[kind](body)];
}

/** An event's kind, and the whole numbers that it begins with: how many actions, cells, or runs and successes. */
export function decode(bytes) {
  let at = 0;
  const next = () => {
    let n = 0;
    for (let scale = 1; ; scale *= 128) {
      n += (bytes[at] & 127) * scale;
      if (bytes[at++] < 128) return n;
    }
  };
  next();
  next();
  return { kind: EVENTS[next()], first: next(), second: next() };
}
