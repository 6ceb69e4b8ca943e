// Worlds in files and links, in both directions: the page has the bits of the JVM, and refuses what is broken.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { inflateRawSync } from 'node:zlib';
import { sleep } from '../site.mjs';

const STEPS = 60; // from NAME-30.circles2d to NAME-90.circles2d

const text = (page, selector) => page.$eval(selector, e => e.textContent);
const hash = page => text(page, '#hash');
const figure = (page, k) => page.$$eval('#figures b', (all, n) => Number(all[n].textContent.replaceAll(',', '')), k);
const says = (page, words) => page.waitForFunction(
  pattern => new RegExp(pattern).test(document.getElementById('notice').textContent), { timeout: 30_000 }, words);

/** `folder` has worlds at two times, their hashes on the JVM in hashes.txt, and a link of each of some. */
export async function playWorlds(browser, address, folder, picture) {
  const hashes = new Map(readFileSync(join(folder, 'hashes.txt'), 'utf8').trim().split('\n')
    .map(line => line.match(/^(.*?): .*hash ([0-9a-f]{16})$/)).map(([, file, value]) => [basename(file), value]));
  const page = await browser.newPage();
  await page.evaluateOnNewDocument(() => { // instead of downloads and of a clipboard that nobody can read
    const make = URL.createObjectURL.bind(URL);
    URL.createObjectURL = blob => {
      window.savedFile = blob;
      return make(blob);
    };
    Object.defineProperty(navigator, 'clipboard', { value: { writeText: async link => { window.copied = link; } } });
  });
  const errors = [];
  page.on('pageerror', e => errors.push(e.message));
  await page.setViewport({ width: 1100, height: 900 });
  await page.goto(address);
  await page.waitForSelector('#hash', { timeout: 60_000 });
  await page.click('#pause');

  const names = readdirSync(folder).filter(name => name.endsWith('-30.circles2d')).map(name => name.slice(0, -13));
  assert.ok(names.length >= 10, `${names}`);
  for (const name of names) {
    const file = join(folder, `${name}-30.circles2d`);
    await openFile(page, file);
    await says(page, `^${name}-30.circles2d is opened`);
    await page.waitForFunction(is => document.getElementById('hash').textContent === is, {}, hashes.get(basename(file)));
    assert.equal(await figure(page, 1), 0);
    await makeSteps(page);
    const later = `${name}-${30 + STEPS}.circles2d`;
    assert.equal(await hash(page), hashes.get(later), `${name} after ${STEPS} steps`);
    assert.deepEqual(await savedFile(page), readFileSync(join(folder, later)), `${name} as the page saves it`);
    await page.click('[data-mode="1"]');
    await sleep(100);
    await picture(page, `world-${name}`);
  }
  await checkEdges(page, folder, picture);
  await checkBack(page);
  await checkTools(page, folder);
  await checkLinks(page, folder, names, hashes);
  await refuseBroken(page, folder);
  await checkAddressBar(browser, address, folder);
  assert.deepEqual(errors, []);
  await page.close();
}

async function openFile(page, file) {
  await (await page.$('#file')).uploadFile(file);
}

/** By so many clicks on the button, of which none waits for another. */
async function makeSteps(page) {
  const from = await figure(page, 1);
  await page.$eval('#step', (button, steps) => {
    for (let k = 0; k < steps; k++) {
      button.click();
    }
  }, STEPS);
  await page.waitForFunction(to => Number(document.querySelectorAll('#figures b')[1].textContent) === to, {}, from + STEPS);
}

async function savedFile(page) {
  await page.evaluate(() => { window.savedFile = undefined; });
  await page.click('#save');
  await page.waitForFunction(() => window.savedFile);
  return Buffer.from(await page.evaluate(async () => [...new Uint8Array(await window.savedFile.arrayBuffer())]));
}

async function copiedLink(page) {
  await page.evaluate(() => { window.copied = undefined; });
  await page.click('#link');
  await page.waitForFunction(() => window.copied);
  return page.evaluate(() => window.copied);
}

/** All that is there is shown, and a line says what is not shown as it is. */
async function checkEdges(page, folder, picture) {
  await openFile(page, join(folder, 'edges-30.circles2d'));
  await says(page, 'one side only.*Sensors.*passed from behind');
  await sleep(200);
  const lit = await page.$eval('#arena', canvas => {
    const { data, width, height } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const rows = new Set();
    for (let k = 0; k < data.length; k += 4) {
      if (data[k + 2] > 100) {
        rows.add(Math.floor(8 * Math.floor(k / 4 / width) / height));
      }
    }
    return rows.size;
  });
  assert.ok(lit >= 5, `circles are in ${lit} of 8 parts of the height`);
  await picture(page, 'world-with-open-edges');
}

/** Going back leads to the same bits, also in a world with a pin whose force has a limit, as that of the pointer has. */
async function checkBack(page) {
  assert.equal(await figure(page, 1), 0);
  const first = await hash(page);
  await page.$eval('#step', button => button.click());
  await page.waitForFunction(() => document.querySelectorAll('#figures b')[1].textContent === '1');
  assert.notEqual(await hash(page), first);
  await (await page.$('#back')).hover();
  await page.mouse.down();
  await page.waitForFunction(() => document.querySelectorAll('#figures b')[1].textContent === '0');
  await page.mouse.up();
  assert.equal(await hash(page), first, 'the step before');
}

/** In a world of another size than the stages of the page, tools act where the pointer is. */
async function checkTools(page, folder) {
  await openFile(page, join(folder, 'pyramid-30.circles2d'));
  await says(page, '^pyramid');
  const box = await (await page.$('#arena')).boundingBox();
  const before = await figure(page, 0);
  await page.click('[data-tool=pour]');
  await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.2);
  await page.mouse.down();
  await page.$eval('#step', button => button.click());
  await page.waitForFunction(least => Number(document.querySelector('#figures b').textContent) > least, {}, before);
  await page.mouse.up();
  await page.click('[data-tool=explode]');
  const calm = await hash(page);
  await page.mouse.click(box.x + box.width / 2, box.y + box.height * 0.2);
  await page.waitForFunction(was => document.getElementById('hash').textContent !== was, {}, calm);
  assert.equal(await text(page, '#notice'), 'pyramid-30.circles2d is opened. ');
}

async function checkLinks(page, folder, names, hashes) {
  const links = names.filter(name => readdirSync(folder).includes(`${name}-30.link`));
  assert.ok(links.length >= 4, `${links}`);
  for (const name of links) {
    const link = readFileSync(join(folder, `${name}-30.link`), 'utf8').trim();
    await follow(page, link);
    await page.waitForFunction(is => document.getElementById('hash').textContent === is, {}, hashes.get(`${name}-30.circles2d`));
    const copied = await copiedLink(page);
    const [address, fragment] = copied.split('#');
    assert.equal(address, page.url().split('#')[0]);
    const bytes = Buffer.from(fragment.slice('world='.length), 'base64url');
    assert.equal(bytes[0], 1);
    assert.deepEqual(inflateRawSync(bytes.subarray(1)), readFileSync(join(folder, `${name}-30.circles2d`)));
  }
  const again = links[links.length - 1];
  await openFile(page, join(folder, 'gas-30.circles2d'));
  await says(page, '^gas');
  await follow(page, readFileSync(join(folder, `${again}-30.link`), 'utf8').trim());
  await says(page, '^The link is opened');
  await page.waitForFunction(is => document.getElementById('hash').textContent === is, {}, hashes.get(`${again}-30.circles2d`));
  await openFile(page, join(folder, 'gas-30.circles2d'));
  await says(page, '^gas');
  await page.click('#link');
  await says(page, 'No link is made: a link would have [0-9,]+ characters, and may have 32,000 characters: save a file instead');
}

async function follow(page, fragment) {
  await page.evaluate(to => { location.hash = to; }, fragment);
}

/** Nothing that is broken is opened, each with its reason, and the world goes on. */
async function refuseBroken(page, folder) {
  const good = readFileSync(join(folder, 'bridge-30.circles2d'));
  const link = readFileSync(join(folder, 'bridge-30.link'), 'utf8').trim();
  const changed = (at, value) => Buffer.from(good).fill(value, at, at + 1);
  const kept = await hash(page);
  const files = [
    [Buffer.from('no world at all'), 'it has no room for the header'],
    [Buffer.alloc(500, 'text'), 'it does not begin as one'],
    [good.subarray(0, good.length / 2), 'its length is'],
    [changed(300, 0x55), 'it is damaged'],
    [changed(4, 2), 'from a later version of circles2d, or damaged: its version is 2'],
    [Buffer.alloc(0), 'it has no room for the header: 0 bytes'],
  ];
  for (const [bytes, reason] of files) {
    await drop(page, bytes);
    await says(page, `^dropped.circles2d is not opened: .*${reason}`);
  }
  const links = [
    ['#world=', 'it has no world'],
    ['#world=a+b!', 'not all of its characters'],
    [link.replace('#world=A', '#world=C'), 'from a later version of circles2d, or damaged: its format is 9'],
    [link.slice(0, link.length - 400), 'it is damaged or cut off'],
    ['#world=AQMA', 'it has no room for the header: 0 bytes'],
    [`#world=${'A'.repeat(40_000)}`, 'it has 40,007 characters, and may have 32,000 characters'],
  ];
  for (const [fragment, reason] of links) {
    await follow(page, fragment);
    await says(page, `^The link is not opened: .*${reason}`);
  }
  await sleep(200);
  assert.equal(await hash(page), kept, 'nothing is lost');
  const steps = await figure(page, 1);
  await makeSteps(page);
  assert.equal(await figure(page, 1), steps + STEPS, 'the world goes on');
  await drop(page, good);
  await says(page, '^dropped.circles2d is opened');
}

async function drop(page, bytes) {
  await page.evaluate(numbers => {
    const dropped = new DataTransfer();
    dropped.items.add(new File([new Uint8Array(numbers)], 'dropped.circles2d'));
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: dropped, bubbles: true, cancelable: true }));
  }, [...bytes]);
}

/** Without a clipboard the link comes into the address bar; whoever loads it has the world. */
async function checkAddressBar(browser, address, folder) {
  const page = await browser.newPage();
  await page.evaluateOnNewDocument(() => {
    Object.defineProperty(navigator, 'clipboard', { value: undefined });
  });
  await page.goto(address + readFileSync(join(folder, 'bridge-30.link'), 'utf8').trim());
  await says(page, '^The link is opened');
  await page.waitForSelector('#hash');
  await sleep(300); // the picture comes behind the line
  const count = await figure(page, 0);
  await page.click('#pause');
  await page.click('#link');
  await says(page, 'in the address bar');
  const kept = await hash(page);
  await page.reload();
  await says(page, '^The link is opened');
  await page.click('#pause');
  await page.waitForSelector('#hash');
  await sleep(300);
  assert.equal(await figure(page, 0), count);
  assert.notEqual(await hash(page), kept, 'it has gone on since');
  await page.close();
}
