// Plays the game in headless browsers, with real clicks: `node browsers.mjs SITE EXPECTED PICTURES BROWSER=PROGRAM...`, where BROWSER
// is chrome or firefox, and EXPECTED is a file with what the game on the JVM says of 300 frames. Writes screenshots, and fails if
// something is not as it should be.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { puppeteer, serve, sleep } from '../site.mjs';

const [site, expected, pictures, ...browsers] = process.argv.slice(2);
const MOST_CLICKS = 60;

mkdirSync(pictures, { recursive: true });
const server = await serve(site);
const { address, missing } = server;

async function until(holds, millis, what) {
  for (const end = Date.now() + millis; !(await holds()); await sleep(100)) {
    assert.ok(Date.now() < end, what);
  }
}

/** Opens the page. Collects what it says on the console, and its errors. */
async function open(browser, query) {
  const page = await browser.newPage();
  const [lines, errors] = [[], []];
  page.on('console', message => lines.push(message.text()));
  page.on('pageerror', error => errors.push(error.message));
  page.on('request', r => assert.ok(/^(data|blob|about):/.test(r.url()) || r.url().startsWith(address), r.url()));
  await page.setViewport({ width: 620, height: 860 });
  await page.goto(address + query);
  return { page, lines, errors };
}

/** The points in the title, or -1 before the first frame. */
const points = async page => Number((await page.title()).match(/^Merge: (\d+) points$/)?.[1] ?? -1);

async function play(name, program) {
  const browser = await puppeteer.launch({
    browser: name,
    executablePath: program,
    headless: true,
    args: name === 'chrome' ? ['--no-sandbox', '--enable-unsafe-swiftshader'] : [],
    protocolTimeout: 120_000,
  });
  const version = await browser.version();

  const alone = await open(browser, '?frames=300');
  const line = () => alone.lines.find(text => text.startsWith('merge: '));
  await until(line, 60_000, 'the game plays by itself');
  assert.equal(line(), readFileSync(expected, 'utf8').trim(), "the hash is the JVM's");
  if (name === 'firefox' && !await alone.page.evaluate(() => document.createElement('canvas').getContext('webgl'))) {
    console.log(`${version}: ${line()}; not drawn, for there is no WebGL in this Firefox without a window`);
    await browser.close();
    return;
  }
  await until(async () => await points(alone.page) >= 0, 60_000, 'the game is drawn');
  assert.ok(await points(alone.page) >= Number(line().match(/(\d+) points/)[1]), 'the game goes on from there');
  assert.deepEqual(alone.errors, []);
  await alone.page.close();

  const { page, errors } = await open(browser, '');
  await until(async () => await points(page) === 0, 60_000, 'a new game begins');
  const box = await (await page.$('#canvas')).boundingBox();
  let clicks = 0;
  for (; await points(page) === 0 && clicks < MOST_CLICKS; clicks++) {
    await page.mouse.click(box.x + 250 + 100 * (clicks % 2), box.y + 300);
    await sleep(700);
  }
  assert.ok(await points(page) > 0, `balls merge within ${MOST_CLICKS} clicks`);
  await page.screenshot({ path: join(pictures, `${name}-merge.png`) });
  for (const [width, height] of [[390, 844], [844, 390], [1280, 800]]) {
    await page.setViewport({ width, height });
    await sleep(500);
    const { x, y, width: w, height: h } = await (await page.$('#canvas')).boundingBox();
    assert.ok(x >= 0 && y >= 0 && x + w <= width && y + h <= height, `all of the game is seen in ${width} x ${height}`);
    assert.ok(Math.abs(w / h - 0.75) < 0.01, 'and is not stretched');
    await page.screenshot({ path: join(pictures, `${name}-merge-${width}.png`) });
  }
  const won = await points(page);
  await page.goto('about:blank');
  assert.deepEqual(errors, []);
  const left = await open(browser, '');
  await left.page.goto('about:blank'); // before the game has begun
  assert.deepEqual(left.errors, []);
  assert.deepEqual(missing, []);

  const old = await browser.newPage();
  await old.evaluateOnNewDocument(() => { WebAssembly.validate = () => false; });
  await old.goto(address);
  assert.match(await old.$eval('#message', e => e.textContent), /too old/);
  console.log(`${version}: ${line()}; then ${won} points by ${clicks} clicks`);
  await browser.close();
}

try {
  for (const browser of browsers) {
    const [name, program] = browser.split('=');
    await play(name, program);
  }
} finally {
  server.close();
}
