// Matter.js: rotation locked, no friction, neither of surfaces nor of the air, no sleeping, its own iteration counts. Its circles are polygons. It
// thinks in pixels, and y points down.
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { build, DT, stateOf } from '../scene.mjs';

const PIXELS_PER_METRE = 40; // a mean radius of 20 pixels, as in its examples

export async function create(packages) {
  const require = createRequire(join(packages, 'x.js'));
  const { Bodies, Body, Composite, Engine } = require('matter-js');
  let engine;
  let bodies;
  let factor;
  return {
    load(scene) {
      factor = scene.arenaMetres * PIXELS_PER_METRE;
      engine = Engine.create({ enableSleeping: false });
      engine.gravity.y = 1;
      engine.gravity.scale = scene.gravity * factor / 1e6; // per millisecond squared
      bodies = [];
      const surface = { friction: 0, frictionAir: 0, frictionStatic: 0, restitution: scene.restitution };
      const walls = [];
      build(
        scene,
        factor,
        (x, y, halfWidth, halfHeight) =>
          walls.push(Bodies.rectangle(x, -y, 2 * halfWidth, 2 * halfHeight, { ...surface, isStatic: true })),
        (x, y, radius, mass) => {
          const body = Bodies.circle(x, -y, radius, surface);
          Body.setMass(body, mass);
          Body.setInertia(body, Infinity);
          bodies.push(body);
        });
      Composite.add(engine.world, [...walls, ...bodies]);
    },
    step: () => Engine.update(engine, 1000 * DT),
    state: () => stateOf(bodies.length, factor, (i, put) => {
      const { position, velocity } = bodies[i]; // the velocity is that of a sixtieth of a second
      put(position.x, -position.y, velocity.x / DT, -velocity.y / DT);
    }),
  };
}
