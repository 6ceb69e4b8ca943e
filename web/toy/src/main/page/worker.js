// The world, beside the page: one message from the page a frame, one picture back.
import { load } from './wasm-gc-module-runtime.min.js';

let toy;
let mode = 0;

const commands = {
  open: ({ stage }) => toy.open(stage),
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
  surface: ({ friction, rolling }) => toy.setSurface(friction, rolling),
};

function frame({ steps, actions }) {
  for (const action of actions) {
    commands[action.what](action);
  }
  const begin = performance.now();
  for (let k = 0; k < steps; k++) {
    toy.step();
  }
  for (let k = 0; k > steps; k--) {
    toy.back();
  }
  const millis = performance.now() - begin;
  const circles = toy.picture(mode);
  const pieces = toy.terrain();
  const joints = toy.joints();
  const surface = { friction: toy.friction(), rolling: toy.rollingResistance() };
  const figures = { steps: toy.steps(), hash: toy.hash(), millis, made: steps };
  postMessage({ circles, pieces, joints, surface, ...figures }, [circles.buffer, pieces.buffer, joints.buffer]);
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
