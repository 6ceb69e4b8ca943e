// Plays with the page in headless browsers, with real clicks: `node browsers.mjs SITE PICTURES WORLDS BROWSER=PROGRAM...`, where WORLDS is
// a folder of worlds that the JVM has saved, and BROWSER is chrome or firefox. Writes screenshots, and fails if something does not do what it should.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { puppeteer, serve, sleep } from '../site.mjs';
import { playWorlds } from './worlds.mjs';

const [site, pictures, worlds, ...browsers] = process.argv.slice(2);

mkdirSync(pictures, { recursive: true });
const server = await serve(site);
const { address } = server;

const text = (page, selector) => page.$eval(selector, e => e.textContent);
const figure = async (page, k) =>
  Number((await page.$$eval('#figures b', all => all.map(e => e.textContent)))[k].replaceAll(',', ''));
const circles = page => figure(page, 0);
const steps = page => figure(page, 1);
const awake = async page => Number((await text(page, '#awake')).replaceAll(',', ''));
const hash = page => text(page, '#hash');

async function at(page, x, y) {
  const box = await (await page.$('#arena')).boundingBox();
  return [box.x + x / 160 * box.width, box.y + (1 - y / 100) * box.height];
}
async function drag(page, ...points) {
  await page.mouse.move(...await at(page, ...points[0]));
  await page.mouse.down();
  for (const point of points.slice(1)) {
    await page.mouse.move(...await at(page, ...point), { steps: 8 });
    await sleep(60);
  }
  await page.mouse.up();
  await sleep(200);
}

async function play(name, program) {
  const browser = await puppeteer.launch({
    browser: name,
    executablePath: program,
    headless: true,
    args: name === 'chrome' ? ['--no-sandbox'] : [],
    protocolTimeout: 120_000,
  });
  const page = await browser.newPage();
  const errors = [];
  page.on('pageerror', e => errors.push(e.message));
  page.on('requestfailed', r => errors.push(`failed: ${r.url()}`));
  page.on('request', r => assert.ok(/^(data|blob):/.test(r.url()) || r.url().startsWith(address), r.url()));
  const picture = what => page.screenshot({ path: join(pictures, `${name}-${what}.png`) });
  await page.setViewport({ width: 1100, height: 860 });
  await page.goto(address);
  await page.waitForSelector('#hash', { timeout: 60_000 });

  await sleep(300); // until it is drawn
  assert.deepEqual(await colourAt(page, 4, 72), [90, 104, 120], 'the end of a wall');
  assert.deepEqual(await colourAt(page, 159, 99), [19, 25, 34], 'where nothing is');

  await page.click('[data-tool=pour]');
  const before = await circles(page);
  await drag(page, [80, 85], [82, 85], [84, 85], [80, 85]);
  assert.ok(await circles(page) > before, 'pouring adds circles');

  await page.click('[data-tool=wall]');
  await drag(page, [20, 30], [60, 34]);
  assert.deepEqual(await colourAt(page, 40, 32), [90, 104, 120], 'a wall is drawn');
  await picture('walls');

  await page.click('#pause');
  await sleep(300);
  const [paused, pausedHash] = [await steps(page), await hash(page)];
  await sleep(300);
  assert.equal(await steps(page), paused, 'nothing moves while it is paused');
  for (let k = 1; k <= 3; k++) {
    await page.click('#step');
    await sleep(150);
    assert.equal(await steps(page), paused + k, 'a step is one step');
  }
  assert.notEqual(await hash(page), pausedHash);
  await page.mouse.move(...await centre(page, '#back'));
  await page.mouse.down();
  await page.waitForFunction(to => Number(document.querySelectorAll('#figures b')[1].textContent) < to, {}, paused);
  await page.mouse.up();
  await sleep(300);
  for (let k = await steps(page); k < paused; k++) {
    await page.click('#step');
    await sleep(100);
  }
  assert.equal(await steps(page), paused);
  assert.equal(await hash(page), pausedHash, 'rewinding and going on gives the same bits');
  await page.click('#pause');

  await page.click('[data-mode="1"]');
  await page.click('[data-tool=explode]');
  await page.mouse.click(...await at(page, 120, 10));
  await sleep(250);
  await picture('explosion');

  await page.click('#gallery [data-scene=hourglass]');
  await sleep(1500);
  await picture('hourglass');
  await page.click('#gallery [data-scene=drum]');
  await sleep(2500);
  await picture('drum');

  await page.click('#gallery [data-scene=bridge]');
  await sleep(1500);
  await picture('bridge');
  await page.click('[data-tool=rope]');
  const loose = await circles(page);
  await drag(page, [20, 98], [50, 85]);
  assert.ok(await circles(page) > loose + 5, 'a rope is drawn');
  await page.click('#gallery [data-scene=blobs]');
  await sleep(2000);
  assert.ok((await filled(page)).length >= 3, 'soft bodies are filled');
  await picture('blobs');
  await page.click('#gallery [data-scene=wrecking]');
  await sleep(1500);
  await picture('wrecking');

  await page.click('#gallery [data-scene=marbles]');
  await sleep(1500);
  assert.equal(await circles(page), 40);
  await page.click('[data-mode="0"]');
  await page.click('[data-tool=grab]');
  await drag(page, [80, 10], [80, 60], [120, 80]);
  await picture('marbles');

  await page.click('#gallery [data-scene=ramps]');
  await sleep(500);
  assert.equal(await text(page, '#friction-value'), '0.00', 'a scene without friction');
  await page.mouse.click(...await centre(page, '#friction'));
  await sleep(1000);
  assert.equal(await text(page, '#friction-value'), '0.50', 'the slider sets the friction of the world');
  await picture('friction');
  assert.equal(await text(page, '#gravity-value'), '60.00');
  await page.$eval('#gravity', slider => { slider.value = 0; slider.dispatchEvent(new Event('input')); });
  await page.waitForFunction(() => document.getElementById('gravity-value').textContent === '0.00');

  await page.click('#gallery [data-scene=slopes]');
  await page.waitForFunction(() => document.getElementById('friction').value === '0.6');
  await sleep(2000);
  assert.deepEqual(await colourAt(page, 82, 62 + 10 * 28 / 58), [138, 106, 58], 'a belt');
  const [one, other] = [await marksOfRoller(page), (await sleep(130), await marksOfRoller(page))];
  assert.ok(one.length > 0 && other.length > 0, 'a roller shows how it has turned');
  assert.notDeepEqual(one, other, 'and turns');
  await picture('slopes');

  await page.click('#gallery [data-scene=crowd]');
  await page.click('[data-mode="2"]');
  await sleep(3000); // the pile falls, and V8 compiles
  const framesASecond = await meanOf(5, async () => {
    await sleep(1000);
    return figure(page, 3);
  });
  console.log(`${name} ${await browser.version()}: ${framesASecond.toFixed(0)} frames a second; ${await text(page, '#figures')}`);
  assert.equal(await circles(page), 5000);
  await picture('crowd');

  await page.mouse.click(...await centre(page, '#friction'));
  await page.click('[data-mode="0"]');
  await sleep(3000);
  const marked = await meanOf(5, async () => {
    await sleep(1000);
    return figure(page, 3);
  });
  console.log(`${name}: with friction ${marked.toFixed(0)} frames a second; ${await text(page, '#figures')}`);
  await picture('crowd-turns');

  await page.click('#gallery [data-scene=rest]');
  const opened = Date.now();
  await page.waitForFunction(() => document.querySelector('#figures b').textContent === '100,001', { timeout: 60_000 });
  console.log(`${name}: 100,000 circles at rest are there after ${Date.now() - opened} ms`);
  await sleep(2000);
  assert.ok(await awake(page) < 20_000, 'most circles sleep');
  const dim = await brightness(page);
  await picture('rest');
  await page.click('#pause');
  await page.click('#sleep');
  await page.waitForFunction(() => document.getElementById('awake').textContent === '100,001');
  await sleep(200);
  assert.ok(await brightness(page) > 1.4 * dim, 'circles that sleep are dim');
  assert.equal(await page.$eval('#sleep', button => button.getAttribute('aria-pressed')), 'false');
  await page.click('#gallery [data-scene=marbles]');
  await page.click('#pause');

  await page.click('#bits');
  await page.waitForFunction(
    () => document.querySelectorAll('#scenes tr').length > 0 && !document.getElementById('bits').disabled,
    { timeout: 120_000 });
  const verdicts = await page.$$eval('#scenes td:last-child', cells => cells.map(c => [c.className, c.textContent]));
  assert.ok(verdicts.length >= 8);
  for (const [kind, words] of verdicts) {
    assert.equal(kind, 'same', words);
  }
  assert.match(await text(page, '#verdict'), /^(\d+) of \1 scenes have the JVM's bits$/);
  await page.screenshot({ path: join(pictures, `${name}-bits.png`), fullPage: true });

  for (const [width, height] of [[390, 844], [844, 390], [1280, 800]]) {
    await page.setViewport({ width, height });
    await page.evaluate(() => scrollTo(0, 0)); // clicks on lower scenes have scrolled it
    await sleep(400);
    for (const selector of ['#arena', '#bits', '#gallery [data-scene=hourglass]']) {
      const { x, y, width: w, height: h } = await (await page.$(selector)).boundingBox();
      const seen = x >= 0 && y >= 0 && x + w <= width && y + (selector === '#arena' ? h : 0) <= height;
      assert.ok(seen, `${selector} is in the first screen of ${width} x ${height}: ${[x, y, w, h]}`);
    }
    await picture(`${width}x${height}`);
  }

  await page.setViewport({ width: 390, height: 780, hasTouch: name === 'chrome', isMobile: name === 'chrome' });
  await page.goto(address);
  await page.waitForSelector('#hash', { timeout: 60_000 });
  if (name === 'chrome') { // puppeteer's touches are Chrome's alone
    await page.tap('[data-tool=pour]');
    const few = await circles(page);
    await page.touchscreen.touchStart(...await at(page, 80, 90));
    await sleep(700);
    await page.touchscreen.touchEnd();
    assert.ok(await circles(page) > few, 'a finger pours');
  }
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 390, `nothing is cut off on a phone: ${width}`);
  await picture('phone');
  assert.deepEqual(errors, []);

  await playWorlds(browser, address, worlds, (of, what) => of.screenshot({ path: join(pictures, `${name}-${what}.png`) }));

  await playRollback(browser, name);

  const old = await browser.newPage();
  await old.evaluateOnNewDocument(() => { WebAssembly.validate = () => false; });
  await old.goto(address);
  assert.match(await text(old, '#message'), /too old/);
  await browser.close();
}

async function colourAt(page, x, y) {
  return page.$eval('#arena', (canvas, u, v) => {
    const { data } = canvas.getContext('2d').getImageData(Math.floor(u * canvas.width), Math.floor(v * canvas.height), 1, 1);
    return [...data.subarray(0, 3)];
  }, x / 160, 1 - y / 100);
}

/** Where on a ring inside of the first roller its mark is, in 24ths of a turn. All at once, for the roller turns. */
async function marksOfRoller(page) {
  return page.$eval('#arena', canvas => {
    const scale = canvas.width / 160;
    const marked = [];
    for (let k = 0; k < 24; k++) {
      const x = (150 + 1.66 * Math.cos(k * Math.PI / 12)) * scale;
      const y = canvas.height - (56 + 1.66 * Math.sin(k * Math.PI / 12)) * scale;
      const [red, green, blue] = canvas.getContext('2d').getImageData(Math.floor(x), Math.floor(y), 1, 1).data;
      if (red === 27 && green === 31 && blue === 36) {
        marked.push(k);
      }
    }
    return marked;
  });
}

/** The colours of which the arena has many pixels, but those of ground and terrain. */
async function filled(page) {
  return page.$eval('#arena', canvas => {
    const pixels = new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer);
    const counts = new Map();
    for (const pixel of pixels) {
      counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
    }
    return [...counts].filter(([pixel, count]) => count > 800 && pixel !== 0xff221913 && pixel !== 0xff78685a);
  });
}

/** The page of two peers: both play by themselves, and a slow network makes them guess more. */
async function playRollback(browser, name) {
  const page = await browser.newPage();
  const errors = [];
  page.on('pageerror', e => errors.push(e.message));
  await page.setViewport({ width: 1100, height: 700 });
  await page.goto(`${address}rollback.html`);
  await page.waitForFunction(() => /, [1-9]\d* times wrong/.test(document.querySelector('figure.blue span').textContent), { timeout: 60_000 });
  assert.equal(await text(page, '#delay-value'), '9 frames, 150 ms');
  await page.$eval('#delay', slider => { slider.value = 30; slider.dispatchEvent(new Event('input')); });
  await page.waitForFunction(() => Number(document.querySelector('figure.orange span').textContent.match(/\d+/)[0]) >= 9);
  const box = await (await page.$('figure.orange canvas')).boundingBox();
  await page.mouse.move(box.x + box.width / 4, box.y + box.height / 4);
  await page.waitForFunction(() => { // the player has come
    const canvas = document.querySelector('figure.orange canvas');
    const [red, green, blue] = canvas.getContext('2d').getImageData(canvas.width / 4, canvas.height / 4, 1, 1).data;
    return red === 255 && green === 180 && blue === 84;
  });
  await page.screenshot({ path: join(pictures, `${name}-rollback.png`) });
  assert.deepEqual(errors, []);
  await page.close();
}

/** Of all pixels above the ball of the scene of circles at rest. */
async function brightness(page) {
  return page.$eval('#arena', canvas => {
    const { data } = canvas.getContext('2d').getImageData(0, 10, canvas.width, Math.floor(canvas.height / 4));
    let sum = 0;
    for (let k = 0; k < data.length; k += 4) {
      sum += data[k] + data[k + 1] + data[k + 2] - 0x13 - 0x19 - 0x22; // the ground
    }
    return sum;
  });
}

async function meanOf(count, measure) {
  let sum = 0;
  for (let k = 0; k < count; k++) {
    sum += await measure();
  }
  return sum / count;
}

async function centre(page, selector) {
  const box = await (await page.$(selector)).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

try {
  for (const browser of browsers) {
    const [name, program] = browser.split('=');
    await play(name, program);
  }
} finally {
  server.close();
}
