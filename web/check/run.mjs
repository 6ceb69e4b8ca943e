// Runs the check in Node: `node run.mjs FOLDER lines`, `record FILE`, or `replay FILE...`. FOLDER has check.wasm with its runtime,
// or check.mjs. Prints what the same arguments print on the JVM.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, command, ...files] = process.argv.slice(2);

async function load() {
  const file = name => join(resolve(folder), name);
  if (existsSync(file('check.mjs'))) {
    return import(pathToFileURL(file('check.mjs')));
  }
  const runtime = await import(pathToFileURL(file('wasm-gc-module-runtime.min.js')));
  return (await runtime.load(readFileSync(file('check.wasm')))).exports;
}

const check = await load();
const bytes = name => new Int8Array(readFileSync(name));
switch (command) {
  case 'lines':
    process.stdout.write(check.check());
    break;
  case 'record':
    writeFileSync(files[0], check.record());
    break;
  case 'replay':
    for (const name of files) {
      console.log(check.replay(bytes(name)));
    }
    break;
  default:
    throw new Error(`unknown command ${command}`);
}
