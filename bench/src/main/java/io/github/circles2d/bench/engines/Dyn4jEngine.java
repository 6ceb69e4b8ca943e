package io.github.circles2d.bench.engines;

import io.github.circles2d.scenes.Scene;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.geometry.Circle;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Rectangle;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;

/**
 * dyn4j (Java, double precision, one thread) as it comes: its own iteration counts, broad phase and continuous detection.
 * Rotation locked, no friction, no sleeping; restitution does nothing below dyn4j's 1 m/s.
 */
final class Dyn4jEngine implements Engine {
    private World<Body> world;
    private Body[] bodies;
    private double factor;

    @Override
    public void load(Scene scene) {
        MeterScale scale = new MeterScale(scene);
        factor = scale.factor;
        world = new World<>(scene.size() + 4, 1);
        world.setGravity(scene.gravityX() * factor, scene.gravityY() * factor);
        world.getSettings().setStepFrequency(scene.timeStep());
        world.getSettings().setAtRestDetectionEnabled(false);
        for (double[] box : scale.walls()) {
            Body wall = body(new Rectangle(2 * box[2], 2 * box[3]), 1, scene.restitution());
            wall.setMass(MassType.INFINITE);
            wall.translate(box[0], box[1]);
            world.addBody(wall);
        }
        bodies = new Body[scene.size()];
        for (int i = 0; i < bodies.length; i++) {
            Body body = body(new Circle(scene.radius(i) * factor), scale.density(i), scene.restitution(i));
            body.setMass(scene.fixed(i) ? MassType.INFINITE : MassType.FIXED_ANGULAR_VELOCITY);
            body.translate(scene.x(i) * factor, scene.y(i) * factor);
            body.setLinearVelocity(scene.vx(i) * factor, scene.vy(i) * factor);
            world.addBody(body);
            bodies[i] = body;
        }
    }

    private static Body body(Convex shape, double density, double restitution) {
        Body body = new Body();
        BodyFixture fixture = body.addFixture(shape);
        fixture.setDensity(density);
        fixture.setFriction(0);
        fixture.setRestitution(restitution);
        return body;
    }

    @Override
    public void step() {
        world.step(1);
    }

    @Override
    public void read(Motion motion) {
        for (int i = 0; i < bodies.length; i++) {
            Vector2 position = bodies[i].getWorldCenter();
            motion.x[i] = (float) (position.x / factor);
            motion.y[i] = (float) (position.y / factor);
            Vector2 velocity = bodies[i].getLinearVelocity();
            motion.vx[i] = (float) (velocity.x / factor);
            motion.vy[i] = (float) (velocity.y / factor);
        }
    }

    @Override
    public boolean repeatable() {
        return true;
    }

    @Override
    public void close() {
        world = null;
        bodies = null;
    }
}
