// The world, beside the page: one message from the page a frame, one picture back.
import { load } from './wasm-gc-module-runtime.min.js';

let toy;
let mode = 0;

const commands = {
  open: ({ scene }) => toy.open(scene),
  mode: message => { mode = message.mode; },
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
      postMessage({ restored: true, name, undrawn: toy.undrawn() });
    }
  },
  save: ({ as }) => postMessage({ saved: new Uint8Array(toy.snapshot().buffer), as }),
  surface: ({ friction, rolling }) => toy.setSurface(friction, rolling),
  gravity: ({ gravity }) => toy.setGravity(gravity),
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
  const pieces = toy.terrain();
  const joints = toy.joints();
  const view = toy.view();
  const open = [toy.isOpenX(), toy.isOpenY()];
  const sliders = { gravity: toy.gravity(), friction: toy.friction(), rolling: toy.rollingResistance() };
  const figures = { steps: toy.steps(), hash: toy.hash(), millis, made: steps };
  postMessage({ circles, pieces, joints, view, open, sliders, ...figures }, [circles.buffer, pieces.buffer, joints.buffer]);
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
