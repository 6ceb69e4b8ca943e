package io.github.circles2d.bench.engines;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.Body;
import com.badlogic.gdx.physics.box2d.BodyDef;
import com.badlogic.gdx.physics.box2d.CircleShape;
import com.badlogic.gdx.physics.box2d.FixtureDef;
import com.badlogic.gdx.physics.box2d.PolygonShape;
import com.badlogic.gdx.physics.box2d.World;
import com.badlogic.gdx.utils.GdxNativesLoader;
import io.github.circles2d.scenes.Scene;

/**
 * libGDX's binding of Box2D 2.3 (C++, one thread). Rotation locked, no friction, no sleeping, 8 velocity and 3 position
 * iterations as Box2D's manual advises; restitution does nothing below Box2D's 1 m/s.
 */
final class GdxBox2dEngine implements Engine {
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

    @Override
    public void load(Scene scene) {
        close();
        MeterScale scale = new MeterScale(scene);
        factor = (float) scale.factor;
        timeStep = scene.timeStep();
        world = new World(new Vector2(scene.gravityX() * factor, scene.gravityY() * factor), false);
        addWalls(scale, scene.restitution());
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
        body.createFixture(fixture);
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
