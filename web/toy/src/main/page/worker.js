// The world, beside the page: one message from the page a frame, one picture back.
import { load } from './wasm-gc-module-runtime.min.js';

let toy;
let mode = 0;
let matching = false; // whether two peers play
let fresh = false; // whether the page is to forget all circles
let last = { hashStep: 0 }; // what of the last frame is needed to see that nothing changes

const OFTEN_HASHED = 20_000; // circles: the hash of more is taken more seldom, for that is a look at the whole state
const HASH_STEPS = 30;

const commands = {
  open: ({ scene }) => {
    toy.open(scene);
    fresh = true;
  },
  mode: message => {
    fresh ||= mode !== message.mode;
    mode = message.mode;
  },
  move: ({ x, y }) => toy.moveTo(x, y),
  grab: () => toy.grab(),
  pour: () => toy.pour(),
  explode: () => toy.explode(),
  wall: ({ x, y }) => toy.wallFrom(x, y),
  begin: () => toy.beginJoint(),
  rope: () => toy.endJoint(true),
  spring: () => toy.endJoint(false),
  pin: () => toy.pin(),
  cut: () => toy.cut(),
  release: () => toy.release(),
  restore: ({ snapshot, name }) => {
    const reason = reasonAgainst(snapshot);
    if (reason !== '') {
      postMessage({ notice: `${name} is not opened: ${reason}.` });
    } else {
      fresh = true;
      postMessage({ restored: true, name, undrawn: toy.undrawn() });
    }
  },
  save: ({ as }) => postMessage({ saved: new Uint8Array(toy.snapshot().buffer), as }),
  surface: ({ friction, rolling }) => toy.setSurface(friction, rolling),
  gravity: ({ gravity }) => toy.setGravity(gravity),
  sleep: ({ sleeps }) => toy.setSleeps(sleeps),
};

/** Opens a snapshot, or says why it cannot be opened. */
function reasonAgainst(snapshot) {
  try {
    return toy.restore(new Int8Array(snapshot.buffer));
  } catch (e) {
    return String(e.message ?? e);
  }
}

/** What a tool cannot do in this world is left out, and said; the world goes on. */
function attempt(work) {
  try {
    work();
  } catch (e) {
    postMessage({ notice: `Not done: ${e.message ?? e}.` });
    toy.release();
  }
}

function frame({ steps, actions }) {
  for (const action of actions) {
    attempt(() => commands[action.what](action));
  }
  const begin = performance.now();
  attempt(() => {
    for (let k = 0; k < steps; k++) {
      toy.step();
    }
    for (let k = 0; k > steps; k--) {
      toy.back();
    }
  });
  const millis = performance.now() - begin;
  const circles = toy.picture(mode);
  const changes = { circles, rested: toy.rested(), woken: toy.woken(), pieces: toy.terrain(), blobs: toy.blobs(), joints: toy.joints() };
  const size = toy.size();
  const awake = toy.awake();
  const view = toy.view();
  const now = { awake, numbers: [circles, changes.pieces, changes.joints, view] };
  const isStill = awake === 0 && !fresh && changes.rested.length === 0 && changes.woken.length === 0 && isSame(now, last);
  const isLate = size < OFTEN_HASHED || steps <= 0 || fresh || toy.steps() >= last.hashStep + HASH_STEPS;
  const isDue = actions.length > 0 || !isStill && isLate;
  now.hash = isDue ? toy.hash() : last.hash;
  now.hashStep = isDue ? toy.steps() : last.hashStep;
  const open = [toy.isOpenX(), toy.isOpenY()];
  const sliders = { gravity: toy.gravity(), friction: toy.friction(), rolling: toy.rollingResistance() };
  const figures = { size, awake, steps: toy.steps(), hash: now.hash, millis, made: steps };
  const more = { ...figures, sliders, canSleep: toy.canSleep(), sleeps: toy.sleeps() };
  if (isStill) {
    postMessage(more);
  } else {
    if (awake === 0) { // else they are never compared
      now.numbers = now.numbers.map(numbers => numbers.slice());
    }
    const buffers = Object.values(changes).map(numbers => numbers.buffer);
    postMessage({ ...changes, ...more, fresh, view, open }, buffers);
  }
  last = now;
  fresh = false;
}

/** Whether two frames look the same but for the circles that sleep. */
function isSame(one, other) {
  return other.awake === 0 && one.numbers.every((numbers, k) =>
    numbers.length === other.numbers[k].length && numbers.every((number, at) => Object.is(number, other.numbers[k][at])));
}

/** A frame of the page of two peers. */
function match({ steps, hands, slowest }) {
  if (!matching) {
    toy.openMatch();
    matching = true;
  }
  toy.setSlowest(slowest);
  for (let k = 0; k < steps; k++) {
    hands.forEach((at, side) => at && toy.steer(side, ...at));
    toy.tickMatch();
  }
  const peers = [0, 1].map(side => toy.seen(side));
  postMessage({ peers }, peers.map(numbers => numbers.buffer));
}

function sameBits({ scenes }) {
  for (const { name, steps } of scenes) {
    const begin = performance.now();
    const hash = toy.sameBits(name, steps);
    postMessage({ scene: name, hash, millis: performance.now() - begin });
  }
  postMessage({ scene: null });
}

onmessage = ({ data }) => {
  try {
    if (data.scenes) {
      sameBits(data);
    } else if (data.match) {
      match(data.match);
    } else {
      frame(data);
    }
  } catch (e) {
    postMessage({ failure: String(e.message ?? e) });
  }
};

try {
  toy = (await load('toy.wasm')).exports;
  postMessage({ ready: true });
} catch (e) {
  postMessage({ failure: String(e.message ?? e) });
}
