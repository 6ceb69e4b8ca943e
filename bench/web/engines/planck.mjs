// Box2D 2.3 in JavaScript: rotation locked, no friction, no sleeping, 8 velocity and 3 position iterations.
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { build, density, DT, stateOf } from '../scene.mjs';

export async function create(packages) {
  const require = createRequire(join(packages, 'x.js'));
  const { Box, Circle, Vec2, World } = require('planck');
  let world;
  let bodies;
  let factor;
  return {
    load(scene) {
      factor = scene.arenaMetres;
      world = new World({ gravity: Vec2(0, -scene.gravity * factor), allowSleep: false });
      bodies = [];
      const surface = { friction: 0, restitution: scene.restitution };
      build(
        scene,
        factor,
        (x, y, halfWidth, halfHeight) =>
          world.createBody({ position: Vec2(x, y) }).createFixture({ ...surface, shape: new Box(halfWidth, halfHeight) }),
        (x, y, radius, mass) => {
          const body = world.createBody({ type: 'dynamic', position: Vec2(x, y), fixedRotation: true });
          body.createFixture({ ...surface, shape: new Circle(radius), density: density(mass, radius) });
          bodies.push(body);
        });
    },
    step: () => world.step(DT, 8, 3),
    state: () => stateOf(bodies.length, factor, (i, put) => {
      const p = bodies[i].getPosition();
      const v = bodies[i].getLinearVelocity();
      put(p.x, p.y, v.x, v.y);
    }),
  };
}
