package io.github.circles2d.bench.physics;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.Body;
import com.badlogic.gdx.physics.box2d.BodyDef;
import com.badlogic.gdx.physics.box2d.BodyDef.BodyType;
import com.badlogic.gdx.physics.box2d.CircleShape;
import com.badlogic.gdx.physics.box2d.FixtureDef;
import com.badlogic.gdx.physics.box2d.World;
import java.util.ArrayList;
import java.util.List;

/** A world of Box2D. Circles of infinite mass are kinematic bodies. */
final class Box2dArena implements Arena {
    private static final int VELOCITY_ITERATIONS = 8;
    private static final int POSITION_ITERATIONS = 3;

    private final Setup setup;
    private final World world;
    private final Box2dWalls walls;
    private final List<Circle> circles = new ArrayList<>();

    /** What Box2D does not tell about a body, or not exactly. */
    private static final class Circle {
        private final Body body;
        private final double mass;
        private final double restitution;
        private double radius;

        Circle(Body body, double radius, double mass, double restitution) {
            this.body = body;
            this.mass = mass;
            this.radius = radius;
            this.restitution = restitution;
        }

        /** Gives the body its one fixture, in place of an earlier one. */
        void shape() {
            while (body.getFixtureList().size > 0) {
                body.destroyFixture(body.getFixtureList().first());
            }
            CircleShape shape = new CircleShape();
            shape.setRadius((float) radius);
            FixtureDef fixture = new FixtureDef();
            fixture.shape = shape;
            fixture.density = mass < Double.POSITIVE_INFINITY ? (float) (mass / (Math.PI * radius * radius)) : 0;
            fixture.friction = 0;
            fixture.restitution = (float) restitution;
            body.createFixture(fixture);
            shape.dispose();
        }
    }

    Box2dArena(Setup setup) {
        this.setup = setup;
        world = new World(new Vector2(0, -setup.gravity()), false);
        walls = new Box2dWalls(world, setup);
    }

    @Override
    public int add(double x, double y, double radius, double mass, double vx, double vy) {
        BodyDef def = new BodyDef();
        def.type = mass < Double.POSITIVE_INFINITY ? BodyType.DynamicBody : BodyType.KinematicBody;
        def.position.set((float) x, (float) y);
        def.linearVelocity.set((float) vx, (float) vy);
        def.fixedRotation = true;
        def.bullet = setup.fast() && def.type == BodyType.DynamicBody;
        Circle circle = new Circle(world.createBody(def), radius, mass, setup.restitution());
        circle.shape();
        circles.add(circle);
        return circles.size() - 1;
    }

    @Override
    public void setPosition(int circle, double x, double y) {
        circles.get(circle).body.setTransform((float) x, (float) y, 0);
    }

    @Override
    public void setRadius(int circle, double radius) {
        circles.get(circle).radius = radius;
        circles.get(circle).shape();
    }

    @Override
    public void setBounds(double minX, double minY, double maxX, double maxY, double timeStep) {
        walls.move(minX, minY, maxX, maxY, timeStep);
    }

    @Override
    public void step(double timeStep, int steps) {
        for (int step = 0; step < steps; step++) {
            world.step((float) timeStep, VELOCITY_ITERATIONS, POSITION_ITERATIONS);
            walls.stop();
        }
    }

    @Override
    public State state() {
        State state =
                new State(circles.size(), -setup.gravity(), walls.minX(), walls.minY(), walls.maxX(), walls.maxY());
        for (int i = 0; i < circles.size(); i++) {
            Circle circle = circles.get(i);
            Vector2 position = circle.body.getPosition();
            state.x[i] = position.x;
            state.y[i] = position.y;
            state.radius[i] = circle.radius;
            state.mass[i] = circle.mass;
            Vector2 velocity = circle.body.getLinearVelocity();
            state.vx[i] = velocity.x;
            state.vy[i] = velocity.y;
        }
        return state;
    }

    @Override
    public void close() {
        world.dispose();
    }
}
