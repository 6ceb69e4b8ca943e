// Two peers of one game side by side, with a slow network between them: what the sample game rollback shows in a window.
const [WIDTH, HEIGHT] = [600, 400];
const STEP_MILLIS = 1000 / 60;
const MOST_STEPS = 3; // a frame
const SIDES = ['#ffb454', '#4cc2ff'];
const [ICE, LINE, PUCK, WRONG] = ['#151c26', '#2b3745', '#c9d4df', '#ff5f6d'];
const [HEAD, OF_CORRECTION, OF_CIRCLE] = [5, 5, 3]; // numbers

const $ = id => document.getElementById(id);
const figures = [...document.querySelectorAll('#peers figure')];
const canvases = figures.map(figure => figure.querySelector('canvas'));

const worker = new Worker('worker.js', { type: 'module' });
let waiting = true; // for the worker
let last;
let owed = 0;
let slowest = 9; // ticks that a packet takes at most
const hands = [null, null]; // where each player is wanted

function tick(now) {
  requestAnimationFrame(tick);
  owed = Math.min(owed + now - (last ?? now), MOST_STEPS * STEP_MILLIS);
  last = now;
  const steps = Math.floor(owed / STEP_MILLIS + 0.25); // a frame that comes a little early makes its step, too
  if (steps > 0 && !waiting) {
    owed = Math.max(0, owed - steps * STEP_MILLIS);
    waiting = true;
    worker.postMessage({ match: { steps, hands, slowest } });
  }
}

function received({ data }) {
  if (data.failure) {
    $('message').textContent = `The game has failed: ${data.failure}`;
    return;
  }
  waiting = false;
  if (data.ready) {
    $('message').textContent = '';
    requestAnimationFrame(tick);
  } else {
    data.peers.forEach((numbers, side) => draw(canvases[side], side, numbers));
  }
}

function draw(canvas, side, numbers) {
  const [orange, blue, guessed, wrong, corrections] = numbers;
  write(figures[side].querySelector('.points'), `${orange} : ${blue}`);
  write(figures[side].querySelector('span'), `guesses ${guessed} frames, ${wrong} times wrong`);
  const ratio = Math.min(devicePixelRatio || 1, 2);
  const width = Math.round(canvas.clientWidth * ratio);
  if (canvas.width !== width) {
    canvas.width = width;
    canvas.height = Math.round(width * HEIGHT / WIDTH);
  }
  const context = canvas.getContext('2d', { alpha: false });
  context.setTransform(width / WIDTH, 0, 0, width / WIDTH, 0, 0);
  const box = (x, w, colour) => {
    context.fillStyle = colour;
    context.fillRect(x, 0, w, HEIGHT);
  };
  box(0, WIDTH, ICE);
  box(WIDTH / 2 - 1, 2, LINE);
  box(0, 5, SIDES[0]); // the walls to defend
  box(WIDTH - 5, 5, SIDES[1]);
  const first = HEAD + corrections * OF_CORRECTION;
  for (let k = first; k < numbers.length; k += OF_CIRCLE) {
    const player = (k - first) / OF_CIRCLE;
    context.fillStyle = SIDES[player] ?? PUCK;
    for (const seam of [-HEIGHT, 0, HEIGHT]) { // the lower edge is joined to the upper one
      disc(context, numbers[k], numbers[k + 1] + seam, numbers[k + 2]);
      context.fill();
    }
  }
  context.strokeStyle = WRONG;
  context.lineWidth = 3;
  for (let k = HEAD; k < first; k += OF_CORRECTION) {
    const [x, y, toX, toY, left] = numbers.subarray(k, k + OF_CORRECTION);
    context.globalAlpha = Math.max(0, left);
    disc(context, x, y, 5);
    context.moveTo(x, y);
    context.lineTo(toX, toY);
    context.stroke();
  }
  context.globalAlpha = 1;
}

function disc(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, 7);
}

function write(element, text) {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}

canvases.forEach((canvas, side) => {
  const point = event => {
    const box = canvas.getBoundingClientRect();
    const inside = (value, end) => Math.max(0, Math.min(end - 1, Math.floor(value)));
    hands[side] = [inside((event.clientX - box.left) / box.width * WIDTH, WIDTH), inside((event.clientY - box.top) / box.height * HEIGHT, HEIGHT)];
  };
  canvas.addEventListener('pointerdown', point);
  canvas.addEventListener('pointermove', point);
  for (const end of ['pointerleave', 'pointercancel']) {
    canvas.addEventListener(end, () => { hands[side] = null; });
  }
});

function setDelay() {
  slowest = Number($('delay').value);
  $('delay-value').textContent = `${slowest} frames, ${Math.round(slowest * STEP_MILLIS)} ms`;
}
$('delay').addEventListener('input', setDelay);
setDelay();

worker.onmessage = received;
worker.onerror = event => received({ data: { failure: event.message ?? 'is it served over HTTP?' } });
