// Runs World in headless Chromium: `node chromium.mjs CHROMIUM DRIVER SCENE SETTINGS STATE`. DRIVER is the folder with puppeteer-core; the rest is
// as for node.mjs.
import http from 'node:http';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { extname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { obey } from './commands.mjs';
import { readScene } from './scene.mjs';

const [chromium, driver, sceneFile, settings, stateFile] = process.argv.slice(2);
const require = createRequire(join(driver, 'x.js'));
const { default: puppeteer } = await import(pathToFileURL(require.resolve('puppeteer-core')));
const folder = fileURLToPath(new URL('.', import.meta.url));
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm' };

const server = http.createServer((request, response) => {
  const name = request.url === '/' ? '/page/index.html' : request.url;
  // An isolated page has a clock of five microseconds; others have one of a hundred.
  response.writeHead(200, {
    'content-type': TYPES[extname(name)] ?? 'application/octet-stream',
    'cross-origin-opener-policy': 'same-origin',
    'cross-origin-embedder-policy': 'require-corp',
  });
  response.end(readFileSync(join(folder, name)));
}).listen(0, '127.0.0.1');
await new Promise(resolve => server.on('listening', resolve));

const browser = await puppeteer.launch({
  executablePath: chromium,
  headless: true,
  args: ['--no-sandbox'],
  protocolTimeout: 600_000,
});
try {
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  await page.waitForFunction(() => globalThis.runWorld);
  if (!await page.evaluate(() => crossOriginIsolated)) {
    throw new Error('the page is not isolated, so its clock is coarse');
  }
  const { circles, ...scene } = readScene(sceneFile, JSON.parse(settings));
  const run = seconds => page.evaluate((scene, seconds) => globalThis.runWorld(scene, seconds), scene, seconds);
  await obey(await browser.version(), stateFile, run);
} finally {
  await browser.close();
  server.close();
}
