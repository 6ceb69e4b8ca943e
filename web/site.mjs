// What the tests of the pages share: the driver of browsers, and a server of files.
import { readFileSync } from 'node:fs';
import http from 'node:http';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const TYPES = { html: 'text/html', js: 'text/javascript', css: 'text/css', wasm: 'application/wasm', txt: 'text/plain' };

// From the folder of the call, which has node_modules.
const require = createRequire(join(process.cwd(), 'x.js'));
export const { default: puppeteer } = await import(pathToFileURL(require.resolve('puppeteer-core')));

export const sleep = millis => new Promise(resolve => setTimeout(resolve, millis));

/** Serves a folder on this machine. `missing` has the names of files that were asked for and are not there. */
export async function serve(folder) {
  const missing = [];
  const server = http.createServer((request, response) => {
    const path = new URL(request.url, 'http://localhost').pathname;
    const name = path === '/' ? 'index.html' : path.slice(1);
    try {
      const body = readFileSync(join(folder, name));
      response.writeHead(200, { 'content-type': TYPES[name.split('.').pop()] ?? 'application/octet-stream' });
      response.end(body);
    } catch {
      missing.push(name);
      response.writeHead(404);
      response.end();
    }
  }).listen(0, '127.0.0.1');
  await new Promise(resolve => server.on('listening', resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, missing, close: () => server.close() };
}
