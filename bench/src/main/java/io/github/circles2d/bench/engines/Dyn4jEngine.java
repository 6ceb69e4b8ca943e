package io.github.circles2d.bench.engines;

import io.github.circles2d.scenes.Scene;
import java.util.Iterator;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.geometry.AABB;
import org.dyn4j.geometry.Circle;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Ray;
import org.dyn4j.geometry.Rectangle;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.DetectFilter;
import org.dyn4j.world.World;
import org.dyn4j.world.result.DetectResult;

/**
 * dyn4j (Java, double precision, one thread) as it comes: its own iteration counts, broad phase and continuous detection.
 * Rotation locked, no friction, no sleeping; restitution does nothing below dyn4j's 1 m/s.
 */
final class Dyn4jEngine implements SearchEngine {
    private World<Body> world;
    private Body[] bodies;
    private double factor;

    @Override
    public void load(Scene scene) {
        load(scene, true);
    }

    @Override
    public void loadCircles(Scene scene) {
        load(scene, false);
    }

    private void load(Scene scene, boolean withWalls) {
        MeterScale scale = new MeterScale(scene);
        factor = scale.factor;
        world = new World<>(scene.size() + 4, 1);
        world.setGravity(scene.gravityX() * factor, scene.gravityY() * factor);
        world.getSettings().setStepFrequency(scene.timeStep());
        world.getSettings().setAtRestDetectionEnabled(false);
        for (double[] box : withWalls ? scale.walls() : new double[0][]) {
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

    /** Asks for bounding boxes and tests the circles: its search for what a shape overlaps is no faster, and not exact. */
    @Override
    public long overlaps(float[] discs) {
        long count = 0;
        for (int at = 0; at < discs.length; at += 3) {
            double x = discs[at] * factor;
            double y = discs[at + 1] * factor;
            double radius = discs[at + 2] * factor;
            AABB box = new AABB(x - radius, y - radius, x + radius, y + radius);
            Iterator<DetectResult<Body, BodyFixture>> near = world.detectIterator(box, null);
            while (near.hasNext()) {
                Body body = near.next().getBody();
                if (body.getFixture(0).getShape() instanceof Circle circle) {
                    double dx = body.getTransform().getTranslationX() - x;
                    double dy = body.getTransform().getTranslationY() - y;
                    double sum = circle.getRadius() + radius;
                    count += dx * dx + dy * dy <= sum * sum ? 1 : 0;
                }
            }
        }
        return count;
    }

    @Override
    public long rayHits(float[] rays) {
        DetectFilter<Body, BodyFixture> all = new DetectFilter<>(true, true, null);
        long count = 0;
        for (int at = 0; at < rays.length; at += 4) {
            Vector2 direction = new Vector2(rays[at + 2], rays[at + 3]);
            double length = direction.getMagnitude() * factor;
            Ray ray = new Ray(new Vector2(rays[at] * factor, rays[at + 1] * factor), direction);
            count += world.raycastClosest(ray, length, all) == null ? 0 : 1;
        }
        return count;
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
