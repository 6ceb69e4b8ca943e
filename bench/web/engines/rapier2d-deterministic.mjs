// Rapier in WebAssembly, its deterministic build: rotation locked, no friction, no sleeping, its own iteration counts.
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { build, DT, stateOf } from '../scene.mjs';

export async function create(packages) {
  const require = createRequire(join(packages, 'x.js'));
  const rapier = require('@dimforge/rapier2d-deterministic-compat');
  await rapier.init();
  let world;
  let bodies;
  let factor;
  return {
    load(scene) {
      world?.free();
      factor = scene.arenaMetres;
      world = new rapier.World({ x: 0, y: -scene.gravity * factor });
      world.timestep = DT;
      bodies = [];
      const collider = shape => shape.setFriction(0).setRestitution(scene.restitution);
      build(
        scene,
        factor,
        (x, y, halfWidth, halfHeight) =>
          world.createCollider(collider(rapier.ColliderDesc.cuboid(halfWidth, halfHeight)).setTranslation(x, y)),
        (x, y, radius, mass) => {
          const body = world.createRigidBody(
            rapier.RigidBodyDesc.dynamic().setTranslation(x, y).lockRotations().setCanSleep(false));
          world.createCollider(collider(rapier.ColliderDesc.ball(radius)).setMass(mass), body);
          bodies.push(body);
        });
    },
    step: () => world.step(),
    state: () => stateOf(bodies.length, factor, (i, put) => {
      const p = bodies[i].translation();
      const v = bodies[i].linvel();
      put(p.x, p.y, v.x, v.y);
    }),
  };
}
