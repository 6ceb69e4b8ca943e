// Runs an engine in Node: `node node.mjs ENGINE SCENE SETTINGS STATE`. SCENE is a file of the benchmarks, SETTINGS what it does not have, as
// JSON, and STATE the file for the end state.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { obey } from './commands.mjs';
import { createWorld } from './engines/world.mjs';
import { run } from './measure.mjs';
import { readScene } from './scene.mjs';

const [name, sceneFile, settings, stateFile] = process.argv.slice(2);
const folder = fileURLToPath(new URL('.', import.meta.url));
const packages = join(folder, 'target/engines');
const wasm = join(folder, 'target/wasm');

async function create() {
  if (name === 'world') {
    const runtime = await import(pathToFileURL(join(wasm, 'wasm-gc-module-runtime.min.js')));
    return createWorld(runtime, readFileSync(join(wasm, 'world.wasm')));
  }
  return (await import(`./engines/${name}.mjs`)).create(packages);
}

function description() {
  if (name === 'world') {
    return `Node ${process.versions.node}`;
  }
  const lock = JSON.parse(readFileSync(join(packages, 'package-lock.json')));
  const [key, { version }] = Object.entries(lock.packages).find(([key]) => key.includes(name));
  return `${key.replace('node_modules/', '')} ${version} in Node ${process.versions.node}`;
}

const scene = readScene(sceneFile, JSON.parse(settings));
const engine = await create();
await obey(description(), stateFile, seconds => {
  const figures = run(engine, scene, seconds);
  return figures.median === undefined ? { figures } : { figures, state: engine.state() };
});
