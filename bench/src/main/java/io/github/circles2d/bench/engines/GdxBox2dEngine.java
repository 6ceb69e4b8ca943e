package io.github.circles2d.bench.engines;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.Body;
import com.badlogic.gdx.physics.box2d.BodyDef;
import com.badlogic.gdx.physics.box2d.CircleShape;
import com.badlogic.gdx.physics.box2d.Fixture;
import com.badlogic.gdx.physics.box2d.FixtureDef;
import com.badlogic.gdx.physics.box2d.PolygonShape;
import com.badlogic.gdx.physics.box2d.QueryCallback;
import com.badlogic.gdx.physics.box2d.RayCastCallback;
import com.badlogic.gdx.physics.box2d.World;
import com.badlogic.gdx.utils.GdxNativesLoader;
import io.github.circles2d.scenes.Scene;

/**
 * libGDX's binding of Box2D 2.3.1 (C++, one thread). Rotation locked, no friction, no sleeping, 8 velocity and 3 position
 * iterations as Box2D's manual advises; restitution does nothing below Box2D's 1 m/s.
 */
final class GdxBox2dEngine implements SearchEngine {
    private static final int VELOCITY_ITERATIONS = 8;
    private static final int POSITION_ITERATIONS = 3;

    static {
        // A game's backend does this; there is none here.
        GdxNativesLoader.load();
    }

    private World world;
    private Body[] bodies;
    private float timeStep;
    private float factor;

    // the query that is being answered
    private float searchX;
    private float searchY;
    private float searchRadius;
    private long found;
    private boolean hit;

    @Override
    public void load(Scene scene) {
        load(scene, true);
    }

    @Override
    public void loadCircles(Scene scene) {
        load(scene, false);
    }

    private void load(Scene scene, boolean withWalls) {
        close();
        MeterScale scale = new MeterScale(scene);
        factor = (float) scale.factor;
        timeStep = scene.timeStep();
        world = new World(new Vector2(scene.gravityX() * factor, scene.gravityY() * factor), false);
        if (withWalls) {
            addWalls(scale, scene.restitution());
        }
        bodies = new Body[scene.size()];
        for (int i = 0; i < bodies.length; i++) {
            bodies[i] = addCircle(scene, scale, i);
        }
    }

    private void addWalls(MeterScale scale, float restitution) {
        for (double[] box : scale.walls()) {
            BodyDef def = new BodyDef();
            def.position.set((float) box[0], (float) box[1]);
            PolygonShape shape = new PolygonShape();
            shape.setAsBox((float) box[2], (float) box[3]);
            FixtureDef fixture = new FixtureDef();
            fixture.shape = shape;
            fixture.friction = 0;
            fixture.restitution = restitution;
            world.createBody(def).createFixture(fixture);
            shape.dispose();
        }
    }

    private Body addCircle(Scene scene, MeterScale scale, int i) {
        BodyDef def = new BodyDef();
        def.type = scene.fixed(i) ? BodyDef.BodyType.StaticBody : BodyDef.BodyType.DynamicBody;
        def.position.set(scene.x(i) * factor, scene.y(i) * factor);
        def.linearVelocity.set(scene.vx(i) * factor, scene.vy(i) * factor);
        def.fixedRotation = true;
        CircleShape shape = new CircleShape();
        shape.setRadius(scene.radius(i) * factor);
        FixtureDef fixture = new FixtureDef();
        fixture.shape = shape;
        fixture.density = (float) scale.density(i);
        fixture.friction = 0;
        fixture.restitution = scene.restitution(i);
        Body body = world.createBody(def);
        body.createFixture(fixture).setUserData(scene.radius(i) * factor);
        shape.dispose();
        return body;
    }

    @Override
    public void step() {
        world.step(timeStep, VELOCITY_ITERATIONS, POSITION_ITERATIONS);
    }

    @Override
    public void read(Motion motion) {
        for (int i = 0; i < bodies.length; i++) {
            Vector2 position = bodies[i].getPosition();
            motion.x[i] = position.x / factor;
            motion.y[i] = position.y / factor;
            Vector2 velocity = bodies[i].getLinearVelocity();
            motion.vx[i] = velocity.x / factor;
            motion.vy[i] = velocity.y / factor;
        }
    }

    /** It has a search by bounding boxes only; the circles that it reports are tested here. */
    @Override
    public long overlaps(float[] discs) {
        found = 0;
        QueryCallback test = this::test;
        for (int at = 0; at < discs.length; at += 3) {
            searchX = discs[at] * factor;
            searchY = discs[at + 1] * factor;
            searchRadius = discs[at + 2] * factor;
            world.QueryAABB(
                    test,
                    searchX - searchRadius,
                    searchY - searchRadius,
                    searchX + searchRadius,
                    searchY + searchRadius);
        }
        return found;
    }

    private boolean test(Fixture fixture) {
        if (fixture.getUserData() instanceof Float radius) {
            Vector2 centre = fixture.getBody().getPosition();
            float dx = centre.x - searchX;
            float dy = centre.y - searchY;
            float sum = radius + searchRadius;
            found += dx * dx + dy * dy <= sum * sum ? 1 : 0;
        }
        return true;
    }

    @Override
    public long rayHits(float[] rays) {
        RayCastCallback nearest = (fixture, point, normal, fraction) -> {
            hit = true;
            return fraction;
        };
        long count = 0;
        for (int at = 0; at < rays.length; at += 4) {
            hit = false;
            float x = rays[at] * factor;
            float y = rays[at + 1] * factor;
            world.rayCast(nearest, x, y, x + rays[at + 2] * factor, y + rays[at + 3] * factor);
            count += hit ? 1 : 0;
        }
        return count;
    }

    @Override
    public boolean repeatable() {
        return true;
    }

    @Override
    public void close() {
        if (world != null) {
            world.dispose();
            world = null;
        }
    }
}
