package io.github.circles2d.bench.physics;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.Body;
import com.badlogic.gdx.physics.box2d.BodyDef;
import com.badlogic.gdx.physics.box2d.BodyDef.BodyType;
import com.badlogic.gdx.physics.box2d.FixtureDef;
import com.badlogic.gdx.physics.box2d.PolygonShape;
import com.badlogic.gdx.physics.box2d.World;

/** Four kinematic boxes around an arena, as thick as it is wide. Moved walls have their velocity for one step. */
final class Box2dWalls {
    private final Body left;
    private final Body lower;
    private final Body right;
    private final Body upper;
    private final float thick;

    private double minX;
    private double minY;
    private double maxX;
    private double maxY;
    private boolean moving;

    Box2dWalls(World world, Setup setup) {
        minX = setup.minX();
        minY = setup.minY();
        maxX = setup.maxX();
        maxY = setup.maxY();
        thick = Math.max(setup.width(), setup.height()) / 2;
        left = wall(world, thick, 3 * thick, setup.restitution());
        right = wall(world, thick, 3 * thick, setup.restitution());
        lower = wall(world, 3 * thick, thick, setup.restitution());
        upper = wall(world, 3 * thick, thick, setup.restitution());
        place();
    }

    private static Body wall(World world, float halfWidth, float halfHeight, float restitution) {
        BodyDef def = new BodyDef();
        def.type = BodyType.KinematicBody;
        Body body = world.createBody(def);
        PolygonShape shape = new PolygonShape();
        shape.setAsBox(halfWidth, halfHeight);
        FixtureDef fixture = new FixtureDef();
        fixture.shape = shape;
        fixture.friction = 0;
        fixture.restitution = restitution;
        body.createFixture(fixture);
        shape.dispose();
        return body;
    }

    /** Lets the walls travel to these places within the next step. */
    void move(double minX, double minY, double maxX, double maxY, double timeStep) {
        left.setLinearVelocity((float) ((minX - this.minX) / timeStep), 0);
        right.setLinearVelocity((float) ((maxX - this.maxX) / timeStep), 0);
        lower.setLinearVelocity(0, (float) ((minY - this.minY) / timeStep));
        upper.setLinearVelocity(0, (float) ((maxY - this.maxY) / timeStep));
        this.minX = minX;
        this.minY = minY;
        this.maxX = maxX;
        this.maxY = maxY;
        moving = true;
    }

    /** After a step: the walls are where they were to travel, and stay there. */
    void stop() {
        if (moving) {
            for (Body wall : new Body[] {left, right, lower, upper}) {
                wall.setLinearVelocity(Vector2.Zero);
            }
            place();
            moving = false;
        }
    }

    private void place() {
        float middleX = (float) ((minX + maxX) / 2);
        float middleY = (float) ((minY + maxY) / 2);
        left.setTransform((float) minX - thick, middleY, 0);
        right.setTransform((float) maxX + thick, middleY, 0);
        lower.setTransform(middleX, (float) minY - thick, 0);
        upper.setTransform(middleX, (float) maxY + thick, 0);
    }

    double minX() {
        return minX;
    }

    double minY() {
        return minY;
    }

    double maxX() {
        return maxX;
    }

    double maxY() {
        return maxY;
    }
}
