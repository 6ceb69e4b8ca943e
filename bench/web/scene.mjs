// A scene out of a file of the benchmarks: the number of circles as an int, then x, y, radius and mass of each as floats. The arena is
// the unit square, and all are at rest.
import { readFileSync } from 'node:fs';

/** `settings`: gravity (downwards), restitution, steps, skipped, arenaMetres. */
export function readScene(file, settings) {
  const bytes = readFileSync(file);
  const n = bytes.readInt32LE(0);
  const circles = Float32Array.from({ length: 4 * n }, (_, k) => bytes.readFloatLE(4 + 4 * k));
  return { ...settings, n, circles };
}

/**
 * The scene, `factor` times as large, for an engine in which y points up. Calls `wall` with the centre and the halves of width and height of four
 * boxes, which are as thick as the arena is wide, and `circle` with x, y, radius and mass of each.
 */
export function build(scene, factor, wall, circle) {
  const half = factor / 2;
  wall(-half, half, half, 3 * half);
  wall(3 * half, half, half, 3 * half);
  wall(half, -half, half, half);
  wall(half, 3 * half, half, half);
  const { circles, n } = scene;
  for (let i = 0; i < n; i++) {
    circle(circles[4 * i] * factor, circles[4 * i + 1] * factor, circles[4 * i + 2] * factor, circles[4 * i + 3]);
  }
}

/** The end state: x, y, vx and vy of each circle in the scene's units; `read(i, put)` calls put with those of the engine. */
export function stateOf(n, factor, read) {
  const state = new Float32Array(4 * n);
  for (let i = 0; i < n; i++) {
    read(i, (x, y, vx, vy) => state.set([x / factor, y / factor, vx / factor, vy / factor], 4 * i));
  }
  return state;
}

/** The density of a disc. */
export const density = (mass, radius) => mass / (Math.PI * radius * radius);

export const DT = 1 / 60;
