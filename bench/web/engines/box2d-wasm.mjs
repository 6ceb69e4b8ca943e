// Box2D 2.4 in WebAssembly: rotation locked, no friction, no sleeping, 8 velocity and 3 position iterations.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { build, density, DT, stateOf } from '../scene.mjs';

export async function create(packages) {
  // Its modules for Node are CommonJS. SIMD, as its entry picks where there is SIMD.
  const require = createRequire(join(packages, 'x.js'));
  const folder = dirname(require.resolve('box2d-wasm'));
  const box2d = await require(join(folder, 'Box2D.simd.js'))({ wasmBinary: readFileSync(join(folder, 'Box2D.simd.wasm')) });
  let world;
  let bodies;
  let factor;
  return {
    load(scene) {
      if (world) {
        box2d.destroy(world);
      }
      factor = scene.arenaMetres;
      const gravity = new box2d.b2Vec2(0, -scene.gravity * factor);
      world = new box2d.b2World(gravity);
      box2d.destroy(gravity);
      world.SetAllowSleeping(false);
      bodies = [];
      const at = new box2d.b2Vec2(0, 0);
      const body = (x, y, type, shape, mass) => {
        const bodyDef = new box2d.b2BodyDef();
        at.Set(x, y);
        bodyDef.set_type(type);
        bodyDef.set_position(at);
        bodyDef.set_fixedRotation(true);
        const created = world.CreateBody(bodyDef);
        const fixtureDef = new box2d.b2FixtureDef();
        fixtureDef.set_shape(shape);
        fixtureDef.set_density(mass);
        fixtureDef.set_friction(0);
        fixtureDef.set_restitution(scene.restitution);
        created.CreateFixture(fixtureDef);
        [bodyDef, fixtureDef, shape].forEach(box2d.destroy);
        return created;
      };
      build(
        scene,
        factor,
        (x, y, halfWidth, halfHeight) => {
          const box = new box2d.b2PolygonShape();
          box.SetAsBox(halfWidth, halfHeight);
          body(x, y, box2d.b2_staticBody, box, 0);
        },
        (x, y, radius, mass) => {
          const disc = new box2d.b2CircleShape();
          disc.set_m_radius(radius);
          bodies.push(body(x, y, box2d.b2_dynamicBody, disc, density(mass, radius)));
        });
      box2d.destroy(at);
    },
    step: () => world.Step(DT, 8, 3),
    state: () => stateOf(bodies.length, factor, (i, put) => {
      const p = bodies[i].GetPosition();
      const v = bodies[i].GetLinearVelocity();
      put(p.x, p.y, v.x, v.y);
    }),
  };
}
