// The page: it draws what the worker sends, and tells it what the pointer does.
import { Discs, shadesOf } from './discs.js';

const WIDTH = 160;
const HEIGHT = 100;
const STEP_MILLIS = 1000 / 60;
const MOST_STEPS = 3; // a frame; a slow machine falls behind instead of choking
const SHADES = 24;
const SCENES = [['thesis', 300], ['gas', 300], ['wrapped', 300], ['barrel', 300], ['balls2', 100], ['no-collide', 300],
  ['billiards', 1000], ['mixed-100', 100], ['boulder', 100]]; // and steps
const GROUND = '#131922';
const STATIC = '#5a6878';
const BELT = '#8a6a3a';
const STRIDE = 5; // numbers a circle: x, y, radius, shade and angle
const PIECE_STRIDE = 8; // numbers a piece: form, shade, and then ends and thickness, or centre, radius, angles and side
const [SEGMENT, ARC] = [1, 3]; // forms
const JOINT_STRIDE = 5; // numbers a joint: ends and shade
const TENSION = ['#6f8aa3', '#b9c7d3', '#ffd166', '#ff7a45', '#e8505b'];
const DOT = 2.5; // pixels: the radius of a joint without length
const BAND = 4; // pixels of the solid side of a chain
const MARK = 0.3; // of the colour's light
const MARK_AT = 0.52; // in radii of the circle, from its centre
const MARK_RADIUS = 0.26; // likewise
const MARK_FROM = 2.5; // pixels: the mark on a smaller circle would be a speck
const SLIDING_MILLIS = 400; // for so long after an input, a slider is the hand's
const RAMPS = [
  ['#4aa8d8', '#5bc0be', '#7fb7e6', '#9b8cf0', '#6d9eeb', '#48c9b0', '#8fd3f4', '#74a9cf'],
  ['#2c4a7c', '#3178b8', '#35b6c4', '#9fdc7c', '#ffd166', '#ff7a45', '#ffe9dc'],
  ['#26415e', '#4b4a9a', '#9a3f9d', '#e0526f', '#ff9a56', '#fff1b8'],
];

const $ = id => document.getElementById(id);
const canvas = $('arena');
const context = canvas.getContext('2d', { alpha: false });

let worker;
let tool = 'grab';
let mode = 0;
let paused = false;
let rewinding = false;
let single = 0;
let waiting = true; // for the worker
let owed = 0;
let last;
let actions = [];
let picture = { circles: new Float32Array(0), pieces: new Float32Array(0), joints: new Float32Array(0), steps: 0, hash: '', millis: 0 };
let dirty = true;
let blasts = [];
let pointer = null;
let frames = [];
let stepMillis = 0;
let testing = false;

// ---- Drawing

const rgb = colour => [16, 8, 0].map(shift => parseInt(colour.slice(1), 16) >> shift & 255);

/** The colours of static circles and of belts, then those of a ramp. */
function coloursOf(ramp) {
  const stops = ramp.map(rgb);
  const colours = Array.from({ length: SHADES }, (_, k) => {
    const place = k / (SHADES - 1) * (stops.length - 1);
    const stop = Math.min(Math.floor(place), stops.length - 2);
    return stops[stop].map((part, channel) => part + (stops[stop + 1][channel] - part) * (place - stop));
  });
  return [rgb(STATIC), rgb(BELT), ...colours];
}

const palettes = RAMPS.map(ramp => shadesOf(coloursOf(ramp)));
const markPalettes = RAMPS.map(ramp => shadesOf(coloursOf(ramp).map(colour => colour.map(part => MARK * part))));
let discs;

function draw() {
  const ratio = Math.min(devicePixelRatio || 1, 2);
  const width = Math.round(canvas.clientWidth * ratio);
  const height = Math.round(width * HEIGHT / WIDTH);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
    discs = new Discs(width, height, rgb(GROUND));
  }
  const scale = width / WIDTH;
  const { circles } = picture;
  const palette = palettes[mode];
  const marks = markPalettes[mode];
  discs.clear();
  for (let k = 0; k < circles.length; k += STRIDE) {
    const shade = circles[k + 3];
    const colour = shade < 0 ? -1 - shade : 2 + Math.round(shade * (SHADES - 1));
    const x = circles[k] * scale;
    const y = height - circles[k + 1] * scale;
    const radius = circles[k + 2] * scale;
    discs.draw(x, y, radius, palette, colour);
    const angle = circles[k + 4]; // NaN if the circle has no mark
    if (angle === angle && radius >= MARK_FROM) {
      const reach = MARK_AT * radius;
      discs.draw(x + reach * Math.cos(angle), y - reach * Math.sin(angle), MARK_RADIUS * radius, marks, colour);
    }
  }
  context.putImageData(discs.image, 0, 0);
  drawJoints(scale, height, ratio);
  drawTerrain(scale, height, ratio);
  if (pointer?.joins) {
    context.strokeStyle = '#ffb454';
    context.lineWidth = 2 * ratio;
    context.beginPath();
    context.moveTo(pointer.x * scale, height - pointer.y * scale);
    context.lineTo(pointer.toX * scale, height - pointer.toY * scale);
    context.stroke();
  }
  for (const blast of blasts) {
    const age = (performance.now() - blast.at) / 400;
    context.strokeStyle = `rgba(255,180,84,${Math.max(0, 1 - age)})`;
    context.lineWidth = 3 * ratio;
    context.beginPath();
    context.arc(blast.x * scale, height - blast.y * scale, 20 * Math.sqrt(age) * scale, 0, 7);
    context.stroke();
  }
  blasts = blasts.filter(blast => performance.now() - blast.at < 400);
  dirty = blasts.length > 0;
}

/** All joints of a colour at once. */
function drawJoints(scale, height, ratio) {
  const { joints } = picture;
  context.lineWidth = 1.5 * ratio;
  TENSION.forEach((colour, shade) => {
    context.strokeStyle = context.fillStyle = colour;
    context.beginPath();
    for (let k = 0; k < joints.length; k += JOINT_STRIDE) {
      if (Math.round(joints[k + 4] * (TENSION.length - 1)) === shade) {
        const [x, y, x2, y2] = [joints[k] * scale, height - joints[k + 1] * scale, joints[k + 2] * scale, height - joints[k + 3] * scale];
        if (Math.hypot(x2 - x, y2 - y) < DOT) {
          context.fillRect(x - DOT * ratio, y - DOT * ratio, 2 * DOT * ratio, 2 * DOT * ratio);
        }
        context.moveTo(x, y);
        context.lineTo(x2, y2);
      }
    }
    context.stroke();
  });
}

function drawTerrain(scale, height, ratio) {
  const { pieces } = picture;
  const band = BAND * ratio;
  context.lineCap = 'round';
  for (let k = 0; k < pieces.length; k += PIECE_STRIDE) {
    const [form, shade, x, y, x2, y2, , inside] = pieces.subarray(k, k + PIECE_STRIDE);
    context.strokeStyle = shade === -2 ? BELT : STATIC;
    context.lineWidth = form === SEGMENT ? Math.max(2 * pieces[k + 6] * scale, band) : band;
    context.beginPath();
    if (form === ARC) { // y points down, so angles do, too
      const radius = x2 * scale + (inside ? band / 2 : -band / 2);
      context.arc(x * scale, height - y * scale, radius, -y2, -pieces[k + 6], true);
    } else { // a line of a chain is solid on its left
      const factor = form === SEGMENT ? 0 : band / 2 / Math.hypot(x2 - x, y2 - y);
      const [left, up] = [(y - y2) * factor, (x2 - x) * factor];
      context.moveTo(x * scale + left, height - y * scale - up);
      context.lineTo(x2 * scale + left, height - y2 * scale - up);
    }
    context.stroke();
  }
}

function tell() {
  const n = picture.circles.length / STRIDE;
  const fps = frames.length > 1 ? (frames.length - 1) * 1000 / (frames[frames.length - 1] - frames[0]) : 0;
  $('figures').innerHTML = `<b>${n.toLocaleString('en')}</b> circles  step <b>${picture.steps}</b>  `
    + `<b>${stepMillis.toFixed(1)}</b> ms a step  <b>${fps.toFixed(0)}</b> fps  hash <b id="hash">${picture.hash}</b>`;
}

// ---- Time

function tick(now) {
  requestAnimationFrame(tick);
  const passed = last === undefined ? STEP_MILLIS : now - last;
  last = now;
  if (!worker || testing) {
    return;
  }
  owed = Math.min(owed + passed, MOST_STEPS * STEP_MILLIS);
  if (!waiting) {
    let steps = 0;
    if (rewinding) {
      steps = -1;
      owed = 0;
    } else if (paused) {
      steps = single;
      single = 0;
      owed = 0;
    } else {
      steps = Math.floor(owed / STEP_MILLIS + 0.25); // a frame that comes a little early makes its step, too
      owed = Math.max(0, owed - steps * STEP_MILLIS);
    }
    if (steps !== 0 || actions.length > 0) {
      waiting = true;
      worker.postMessage({ steps, actions });
      actions = [];
    }
  }
  if (dirty) {
    draw();
    frames.push(now);
    frames = frames.filter(at => now - at < 1000);
  }
}

function received({ data }) {
  if (data.failure) {
    fail(data.failure);
  } else if (data.ready) {
    $('message').textContent = '';
    waiting = false;
    act({ what: 'open', stage: $('stage').value });
  } else if (data.scene !== undefined) {
    reported(data);
  } else {
    waiting = false;
    picture = data;
    dirty = true;
    if (data.made > 0) {
      stepMillis += 0.1 * (data.millis / data.made - stepMillis);
    }
    tell();
    showSurface();
  }
}

function act(action) {
  actions.push(action);
}

// ---- Pointer: mouse, pen and finger alike

function place(event) {
  const box = canvas.getBoundingClientRect();
  return { x: (event.clientX - box.left) / box.width * WIDTH, y: (1 - (event.clientY - box.top) / box.height) * HEIGHT };
}

canvas.addEventListener('pointerdown', event => {
  canvas.setPointerCapture(event.pointerId);
  const at = place(event);
  pointer = { id: event.pointerId, ...at };
  act({ what: 'move', ...at });
  if (tool === 'explode') {
    blasts.push({ ...at, at: performance.now() });
    act({ what: 'explode' });
  } else if (tool === 'rope' || tool === 'spring') {
    pointer = { ...pointer, joins: tool, toX: at.x, toY: at.y };
    act({ what: 'begin' });
  } else if (tool !== 'wall') {
    act({ what: tool });
  }
});
canvas.addEventListener('pointermove', event => {
  if (pointer?.id !== event.pointerId) {
    return;
  }
  const at = place(event);
  if (tool === 'wall') {
    if (Math.hypot(at.x - pointer.x, at.y - pointer.y) > 2) {
      act({ what: 'move', ...at });
      act({ what: 'wall', x: pointer.x, y: pointer.y });
      pointer = { ...pointer, ...at };
    }
  } else {
    act({ what: 'move', ...at });
    if (tool === 'cut') {
      act({ what: 'cut' });
    }
    if (pointer.joins) {
      pointer = { ...pointer, toX: at.x, toY: at.y };
      dirty = true;
    }
  }
});
for (const end of ['pointerup', 'pointercancel']) {
  canvas.addEventListener(end, event => {
    if (pointer?.id === event.pointerId) {
      if (pointer.joins && end === 'pointerup') {
        act({ what: pointer.joins });
      }
      pointer = null;
      act({ what: 'release' });
    }
  });
}

// ---- Buttons

function choose(group, name, button) {
  for (const other of $(group).querySelectorAll('button')) {
    other.setAttribute('aria-pressed', String(other === button));
  }
  return button.dataset[name];
}
function setPaused(on) {
  paused = on;
  $('pause').textContent = on ? 'go on' : 'pause';
  $('pause').setAttribute('aria-pressed', String(on));
}

$('tools').addEventListener('click', event => {
  if (event.target.dataset.tool) {
    tool = choose('tools', 'tool', event.target);
  }
});
$('modes').addEventListener('click', event => {
  if (event.target.dataset.mode) {
    mode = Number(choose('modes', 'mode', event.target));
    act({ what: 'mode', mode });
  }
});
$('pause').addEventListener('click', () => setPaused(!paused));
$('step').addEventListener('click', () => { setPaused(true); single++; });
$('back').addEventListener('pointerdown', event => {
  event.target.setPointerCapture(event.pointerId);
  rewinding = true;
});
for (const end of ['pointerup', 'pointercancel']) {
  $('back').addEventListener(end, () => { rewinding = false; setPaused(true); });
}
for (const slider of ['friction', 'rolling']) {
  $(slider).addEventListener('input', () => {
    slid = performance.now();
    act({ what: 'surface', friction: Number($('friction').value), rolling: Number($('rolling').value) });
  });
}
let slid = -SLIDING_MILLIS;

/** The sliders show the surface of the world, which a stage or a rewind changes, too. */
function showSurface() {
  for (const [slider, value] of Object.entries(picture.surface)) {
    $(`${slider}-value`).textContent = value.toFixed(2);
    if (performance.now() - slid > SLIDING_MILLIS) {
      $(slider).value = value;
    }
  }
}
$('stage').addEventListener('change', () => act({ what: 'open', stage: $('stage').value }));
addEventListener('resize', () => { dirty = true; });

// ---- The same bits

async function sameBits() {
  const text = await (await fetch('world.txt')).text();
  const golden = text.split('\n').map(line => line.split(' '))
    .filter(([name, steps]) => SCENES.some(scene => scene[0] === name && scene[1] === Number(steps)));
  testing = true;
  $('bits').disabled = true;
  $('report').hidden = false;
  $('scenes').replaceChildren(...golden.map(([name, steps]) => {
    const row = document.createElement('tr');
    row.dataset.scene = name;
    for (const text of [name, steps, '…', '']) {
      row.append(Object.assign(document.createElement('td'), { textContent: text }));
    }
    return row;
  }));
  $('report').scrollIntoView({ behavior: 'smooth', block: 'nearest' });
  expected = new Map(golden.map(([name, , hash]) => [name, hash]));
  worker.postMessage({ scenes: golden.map(([name, steps]) => ({ name, steps: Number(steps) })) });
}
let expected;

function reported({ scene, hash, millis }) {
  if (scene === null) {
    testing = false;
    $('bits').disabled = false;
    return;
  }
  const cells = $('scenes').querySelector(`[data-scene="${scene}"]`).children;
  const same = hash === expected.get(scene);
  cells[2].textContent = hash;
  cells[3].textContent = same ? `the JVM's, in ${Math.round(millis)} ms` : `the JVM has ${expected.get(scene)}`;
  cells[3].className = same ? 'same' : 'other';
}

$('bits').addEventListener('click', sameBits);

// ---- Start

function fail(text) {
  $('message').textContent = text;
}

// A module with a struct and an exception reference: a browser that accepts it has what the page needs.
const NEEDED = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 9, 2, 95, 1, 120, 0, 96, 1, 105, 0]);

if (typeof WebAssembly !== 'object' || !WebAssembly.validate(NEEDED)) {
  fail('This browser is too old for the page. It needs Chrome or Edge 137, Firefox 131 or Safari 18.4, or a later one.');
} else {
  worker = new Worker('worker.js', { type: 'module' });
  worker.onmessage = received;
  worker.onerror = event => fail(`The world could not be loaded: ${event.message ?? 'is it served over HTTP?'}`);
  requestAnimationFrame(tick);
}
