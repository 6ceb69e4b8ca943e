// The page: it draws what the worker sends, and tells it what the pointer does.
import { Drawing } from './drawing.js';
import { fragmentOf, isLink, snapshotOf } from './links.js';

const STEP_MILLIS = 1000 / 60;
const MOST_STEPS = 3; // a frame; a slow machine falls behind instead of choking
const FRAME_MILLIS = 20; // for the steps of a frame, if it has more than one
const SCENES = [['thesis', 300], ['gas', 300], ['wrapped', 300], ['barrel', 300], ['balls2', 100], ['no-collide', 300],
  ['billiards', 1000], ['mixed-100', 100], ['boulder', 100]]; // and steps
const TOLD_MILLIS = 250; // figures of a world that rests are written so often
const SLIDING_MILLIS = 400; // for so long after an input, a slider is the hand's
const GREATEST_FILE = 32; // megabytes
const THE_LINK = 'The link'; // as the name of a world that came by one
const WALL_EVERY = 2.3; // radii of usual circles

const $ = id => document.getElementById(id);
const canvas = $('arena');
const drawing = new Drawing(canvas);

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
let picture; // none before the world has come
let told = 0; // when the figures were written
let arrived = false;
let dirty = false;
let blasts = [];
let pointer = null;
let frames = [];
let stepMillis = 0;
let testing = false;

// ---- What there is to be seen

function draw() {
  const line = pointer?.joins ? pointer : null;
  dirty = drawing.draw(picture, mode, line, blasts);
  if (!dirty) {
    blasts = [];
  }
}

function tell() {
  told = performance.now();
  const fps = frames.length > 1 ? (frames.length - 1) * 1000 / (frames[frames.length - 1] - frames[0]) : 0;
  $('figures').innerHTML = `<b>${picture.size.toLocaleString('en')}</b> circles  <em id="awake">${picture.awake.toLocaleString('en')}</em> awake  step <b>${picture.steps}</b>  `
    + `<b>${stepMillis.toFixed(1)}</b> ms a step  <b>${fps.toFixed(0)}</b> fps  <span id="state">hash <b id="hash">${picture.hash}</b></span>`;
}

// ---- Time

function tick(now) {
  requestAnimationFrame(tick);
  const passed = last === undefined ? STEP_MILLIS : now - last;
  last = now;
  if (!worker || testing) {
    return;
  }
  const most = Math.max(1, Math.min(MOST_STEPS, Math.floor(FRAME_MILLIS / stepMillis)));
  owed = Math.min(owed + passed, most * STEP_MILLIS);
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
  if (dirty || arrived) { // a frame in which nothing has changed is one, too
    frames.push(now);
    frames = frames.filter(at => now - at < 1000);
    arrived = false;
  }
  if (dirty) {
    draw();
  }
}

function received({ data }) {
  if (data.failure) {
    fail(data.failure);
  } else if (data.ready) {
    $('message').textContent = '';
    waiting = false;
    show(scene);
    openLink();
  } else if (data.notice !== undefined) {
    say(data.notice);
  } else if (data.restored) {
    restored(data);
  } else if (data.saved) {
    saved(data);
  } else if (data.scene !== undefined) {
    reported(data);
  } else {
    waiting = false;
    arrived = true;
    picture = { ...picture, ...data };
    if (data.circles) {
      drawing.sleepers.take(data);
      dirty = true;
    }
    if (data.made > 0) {
      stepMillis += 0.1 * (data.millis / data.made - stepMillis);
    }
    if (data.circles || paused || performance.now() - told > TOLD_MILLIS) {
      tell();
    }
    showSliders();
    showSleep();
  }
}

function act(action) {
  actions.push(action);
}

// ---- Pointer: mouse, pen and finger alike

canvas.addEventListener('pointerdown', event => {
  if (!picture) {
    return;
  }
  canvas.setPointerCapture(event.pointerId);
  const at = drawing.place(event);
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
  const at = drawing.place(event);
  if (tool === 'wall') {
    if (Math.hypot(at.x - pointer.x, at.y - pointer.y) > WALL_EVERY * picture.view[4]) {
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
for (const slider of ['gravity', 'friction', 'rolling']) {
  $(slider).addEventListener('input', () => {
    slid = performance.now();
    const value = name => Number($(name).value);
    act(slider === 'gravity'
      ? { what: 'gravity', gravity: value('gravity') }
      : { what: 'surface', friction: value('friction'), rolling: value('rolling') });
  });
}
let slid = -SLIDING_MILLIS;

/** Puts a text in place of another: a page that is written to is laid out anew. */
function write(id, text) {
  if ($(id).textContent !== text) {
    $(id).textContent = text;
  }
}

/** The sliders show the numbers of the world, which a scene or a rewind changes, too. */
function showSliders() {
  for (const [slider, value] of Object.entries(picture.sliders)) {
    write(`${slider}-value`, value.toFixed(2));
    if (performance.now() - slid > SLIDING_MILLIS && Number($(slider).value).toFixed(2) !== value.toFixed(2)) {
      $(slider).value = value;
    }
  }
}

$('sleep').addEventListener('click', () => act({ what: 'sleep', sleeps: !picture.sleeps }));

/** Shows whether circles of the world fall asleep. */
function showSleep() {
  const { sleeps, canSleep } = picture;
  if ($('sleep').disabled !== !canSleep || $('sleep').getAttribute('aria-pressed') !== String(sleeps)) {
    $('sleep').setAttribute('aria-pressed', String(sleeps));
    $('sleep').disabled = !canSleep;
    $('sleep').title = canSleep ? 'circles that lie still fall asleep, and are dim' : 'this world was made without sleep';
  }
}

// ---- Scenes

let scene = 'ramps';

for (const button of $('gallery').querySelectorAll('button')) {
  const name = button.dataset.picture ?? button.dataset.scene;
  button.prepend(Object.assign(new Image(), { src: `scenes/${name}.png`, alt: '', width: 208, height: 130 }));
}
for (const link of $('gallery').querySelectorAll('a')) {
  const picture = { src: `samples/${link.dataset.sample}/picture.png`, alt: '', width: 208, height: 130 };
  link.prepend(Object.assign(new Image(), picture));
  link.hidden = !isBuilt(link);
}
function show(name) {
  scene = name;
  mark(name);
  act({ what: 'open', scene });
}
/** Marks a scene; a world from a file is none of them. */
function mark(name) {
  for (const button of $('gallery').querySelectorAll('button')) {
    button.setAttribute('aria-pressed', String(button.dataset.scene === name));
  }
}
$('gallery').addEventListener('click', event => {
  if (event.target.dataset.scene) {
    say('');
    leaveLink();
    show(event.target.dataset.scene);
  }
});
addEventListener('resize', () => { dirty = picture !== undefined; });

// ---- Worlds in files and links

/** A line below the world. */
function say(text) {
  $('notice').textContent = text;
}

async function openFile(file) {
  if (file.size > GREATEST_FILE << 20) {
    say(`${file.name} is not opened: it has ${Math.ceil(file.size / (1 << 20))} MB, and a world may have ${GREATEST_FILE}.`);
    return;
  }
  try {
    restore(new Uint8Array(await file.arrayBuffer()), file.name);
  } catch (e) {
    say(`${file.name} is not opened: ${e.message}.`);
  }
}

async function openLink() {
  if (isLink(location.hash)) {
    try {
      restore(await snapshotOf(location.hash), THE_LINK);
    } catch (e) {
      say(`The link is not opened: ${e.message}.`);
    }
  }
}

/** The address no longer has the world that is shown; a link that is followed once more is then another address. */
function leaveLink() {
  if (isLink(location.hash)) {
    history.replaceState(null, '', location.href.split('#')[0]);
  }
}

function restore(snapshot, name) {
  act({ what: 'restore', snapshot, name });
}

function restored({ name, undrawn }) {
  pointer = null;
  if (name !== THE_LINK) {
    leaveLink();
  }
  mark(undefined);
  say(`${name} is opened. ${undrawn}`);
}

async function saved({ saved: snapshot, as }) {
  if (as === 'file') {
    const url = URL.createObjectURL(new Blob([snapshot]));
    Object.assign(document.createElement('a'), { href: url, download: 'world.circles2d' }).click();
    setTimeout(() => URL.revokeObjectURL(url), 60_000);
    return;
  }
  let link;
  try {
    link = location.href.split('#')[0] + await fragmentOf(snapshot);
  } catch (e) {
    say(`No link is made: ${e.message}.`);
    return;
  }
  try {
    await navigator.clipboard.writeText(link);
    say(`A link of ${link.length.toLocaleString('en')} characters is in the clipboard.`);
  } catch { // not allowed, or there is no clipboard without HTTPS
    history.replaceState(null, '', link);
    say('The link is in the address bar: copy it from there.');
  }
}

$('open').addEventListener('click', () => $('file').click());
$('file').addEventListener('change', () => {
  const [file] = $('file').files;
  if (file) {
    openFile(file);
  }
  $('file').value = ''; // so that the same file can be chosen again
});
$('save').addEventListener('click', () => act({ what: 'save', as: 'file' }));
$('link').addEventListener('click', () => act({ what: 'save', as: 'link' }));
addEventListener('hashchange', openLink);
addEventListener('dragover', event => event.preventDefault());
addEventListener('drop', event => {
  event.preventDefault();
  const [file] = event.dataTransfer.files;
  if (file) {
    openFile(file);
  }
});

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
  verdict('', `runs ${golden.length} scenes ...`);
  expected = new Map(golden.map(([name, , hash]) => [name, hash]));
  worker.postMessage({ scenes: golden.map(([name, steps]) => ({ name, steps: Number(steps) })) });
}
let expected;

function reported({ scene, hash, millis }) {
  if (scene === null) {
    testing = false;
    $('bits').disabled = false;
    const all = $('scenes').querySelectorAll('tr').length;
    const same = $('scenes').querySelectorAll('td.same').length;
    verdict(same === all ? 'same' : 'other', `${same} of ${all} scenes have the JVM's bits`);
    return;
  }
  const cells = $('scenes').querySelector(`[data-scene="${scene}"]`).children;
  const same = hash === expected.get(scene);
  cells[2].textContent = hash;
  cells[3].textContent = same ? `the JVM's, in ${Math.round(millis)} ms` : `the JVM has ${expected.get(scene)}`;
  cells[3].className = same ? 'same' : 'other';
}

function verdict(kind, words) {
  $('verdict').className = kind;
  $('verdict').textContent = words;
}

$('bits').addEventListener('click', sameBits);

// ---- What to copy, and where to go

$('copy').addEventListener('click', async () => {
  try {
    await navigator.clipboard.writeText($('dependency').textContent);
    $('copy').textContent = 'copied';
  } catch { // not allowed, or there is no clipboard without HTTPS
    getSelection().selectAllChildren($('dependency'));
  }
});
$('links').hidden = !isBuilt($('links').querySelector('a'));

/** Whether a link leads somewhere: a build without the address of the repository has no links to it. */
function isBuilt(link) {
  return !link.getAttribute('href').startsWith('$');
}

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
