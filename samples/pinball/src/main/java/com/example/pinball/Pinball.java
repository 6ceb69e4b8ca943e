package com.example.pinball;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Backend;
import io.github.circles2d.Chain;
import io.github.circles2d.Events;
import io.github.circles2d.Terrain;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;

/** The table and its rules. All circles are balls, and the table is terrain: each piece of a kind that says what it does. */
final class Pinball implements Runnable {
    static final int WALL = 0, BALL = 1, BUMPER = 2, LIGHT = 3, GATE = 4, SLING = 5, FLIPPER = 6; // kinds
    static final float STEP = 1 / 120f, RADIUS = 0.25f, TOP = 12.5f, MIDDLE = 5.5f; // centre of the arch at the top
    private static final float PI = (float) Math.PI, DOWN = -0.5f, UP = 0.45f, PLUNGER = 0.7f, DEPTH = 1.2f;
    private static final float[] BUMPERS = {3.9f, 12.2f, 7.1f, 12.2f, MIDDLE, 10};
    private static final float[] WALLS = { // of the left half: beside the way to the flipper, and two sides of a sling
        0.95f, 5.6f, 0.95f, 3.8f, 0.95f, 3.8f, 2.8f, 2.65f, 2, 6, 2, 4.5f, 2, 4.5f, 3.2f, 3.75f
    };

    final World world;
    final Terrain terrain;
    final float[] glow = new float[100]; // by id of a piece: 1 if a ball has just hit it, then less and less
    boolean isLeftUp, isRightUp, isPulled;
    int score, balls = 3;
    private final TerrainBody left, right, plunger;
    private int waiting = 1,
            autoPull,
            lights; // balls to come, steps in which the plunger pulls itself, lights that are on
    private float launchSpeed;

    Pinball(Backend backend) {
        World.Builder builder = World.builder().bounds(-1, -4, 12, 19).gravity(0, -12);
        world = builder.friction(0.2f).restitution(0.3f).backend(backend).build();
        terrain = world.terrain();
        world.kind(LIGHT).setSensor(true);
        world.kind(GATE).setOneWay(true);
        world.report(BALL, BUMPER, Events.HIT);
        world.report(BALL, SLING, Events.HIT);
        world.report(BALL, LIGHT, Events.BEGIN);
        // Circles are on the right of a chain: who goes along the outline clockwise has the table there.
        Chain outline = Chain.from(0, -3).lineTo(0, 7).arcTo(-0.6f, 8.4f, 2.3318f);
        terrain.addChain(outline.lineTo(0, TOP).arcTo(MIDDLE, TOP, -PI).lineTo(2 * MIDDLE, -3));
        terrain.addChain(ring(1.95f, 1.4f));
        terrain.addChain(ring(0.3f, 0.85f));
        terrain.addSegment(10, -3, 10, 11.4f, 0.1f, WALL); // the lane of the plunger
        terrain.addSegment(
                11, 12.3f, 10, 11.4f, 0.06f, GATE); // its front is above: balls leave the lane, and none comes back
        for (int k = 0; k < 3; k++) {
            terrain.addArc(BUMPERS[2 * k], BUMPERS[2 * k + 1], 0.75f, 0, 2 * PI, ArcSide.OUTER, BUMPER);
            terrain.addSegment(3.9f + 1.3f * k, 15.2f, 4.5f + 1.3f * k, 15.2f, 0.08f, LIGHT);
        }
        for (float x = 3.55f; x < 8; x += 1.3f) {
            terrain.addSegment(x, 14.8f, x, 15.6f, 0.1f, WALL);
        }
        terrain.addSegment(0.3f, 12, 1, 12, 0.08f, LIGHT);
        for (int side = 1; side >= -1; side -= 2) { // the right half is the mirror image of the left one
            float x = 5 - 5 * side;
            for (int k = 0; k < WALLS.length; k += 4) {
                float x1 = x + side * WALLS[k], x2 = x + side * WALLS[k + 2];
                terrain.addSegment(x1, WALLS[k + 1], x2, WALLS[k + 3], 0.1f, WALL);
            }
            terrain.addSegment(x + side * 2, 6, x + side * 3.2f, 3.75f, 0.12f, SLING);
            terrain.addSegment(x + side * 1.2f, 4.8f, x + side * 1.75f, 4.8f, 0.08f, LIGHT);
        }
        left = terrain.addBody(3, 2.5f, DOWN);
        right = terrain.addBody(7, 2.5f, -DOWN);
        left.addSegment(0, 0, 1.6f, 0, 0.2f, FLIPPER);
        right.addSegment(0, 0, -1.6f, 0, 0.2f, FLIPPER);
        plunger = terrain.addBody(10.55f, PLUNGER, 0);
        plunger.addSegment(-0.25f, 0, 0.25f, 0, 0.1f, FLIPPER);
        TerrainBody spinner = terrain.addBody(MIDDLE, 7.4f, 0);
        spinner.addSegment(-0.8f, 0, 0.8f, 0, 0.1f, FLIPPER);
        spinner.addSegment(0, -0.8f, 0, 0.8f, 0.1f, FLIPPER);
        spinner.setAngularVelocity(3);
    }

    /** A part of a ring around the centre of the arch, solid: out along its outer arc, back along the inner one. */
    private static Chain ring(float from, float angle) {
        float x = (float) StrictMath.cos(from), y = (float) StrictMath.sin(from);
        float endX = (float) StrictMath.cos(from + angle), endY = (float) StrictMath.sin(from + angle);
        Chain outer = Chain.from(MIDDLE + 4.4f * x, TOP + 4.4f * y).arcTo(MIDDLE, TOP, angle);
        return outer.lineTo(MIDDLE + 4.2f * endX, TOP + 4.2f * endY)
                .arcTo(MIDDLE, TOP, -angle)
                .close();
    }

    boolean isOver() {
        return balls == 0;
    }

    boolean isOn(int light) {
        return (lights >> light & 1) != 0;
    }

    /** Makes the changes before each step of the world. */
    @Override
    public void run() {
        for (int k = 0; k < glow.length; k++) {
            glow[k] *= 0.96f;
        }
        Events events = world.events();
        for (int i = 0; i < events.size(); i++) {
            int piece = Terrain.id(events.piece(i));
            glow[piece] = 1;
            score += 50;
            if (events.type(i) == Events.HIT) {
                world.applyImpulse(events.a(i), -9 * events.normalX(i), -9 * events.normalY(i));
            } else {
                lights |= 1L << piece;
            }
        }
        if (Long.bitCount(lights) == 3) { // multiball
            score += 1000;
            waiting += 2;
            lights = 0;
        }
        for (int id = 0; id < world.idLimit(); id++) {
            if (world.handle(id) != 0 && world.y(world.handle(id)) < -1.5f) {
                world.remove(world.handle(id));
            }
        }
        if (world.size() + waiting == 0 && !isOver()) {
            balls--;
            waiting = Math.min(balls, 1);
        }
        if (waiting > 0 && world.queries().pick(plunger.x(), PLUNGER + 0.5f) == 0) {
            autoPull = world.size() > 0 ? 100 : 0;
            world.add(plunger.x(), PLUNGER + 0.5f, RADIUS, 1, 0, 0, BALL);
            waiting--;
        }
        turn(left, isLeftUp ? UP : DOWN);
        turn(right, isRightUp ? -UP : -DOWN);
        pull(isPulled || autoPull-- > 0);
    }

    /** Lets a flipper turn towards an angle, where it stops. */
    private static void turn(TerrainBody flipper, float angle) {
        float most = 18 * STEP, now = flipper.angle();
        flipper.moveTo(flipper.x(), flipper.y(), Math.max(now - most, Math.min(now + most, angle)));
    }

    private void pull(boolean isBack) {
        launchSpeed = isBack ? 1 + 18 * (PLUNGER - plunger.y()) / DEPTH : launchSpeed;
        float y = plunger.y() + (isBack ? -2 : launchSpeed) * STEP;
        plunger.moveTo(plunger.x(), Math.max(PLUNGER - DEPTH, Math.min(PLUNGER, y)), 0);
    }

    /** A player without hands pulls the plunger, and flips when a ball is on a flipper. */
    void playAlone(int frame) {
        isPulled = frame % 120 < 50 - frame / 120 * 7 % 12;
        isLeftUp = world.queries().overlapBox(3.6f, 1.5f, 4.8f, 2.6f, new long[0]) > 0;
        isRightUp = world.queries().overlapBox(5.2f, 1.5f, 6.4f, 2.6f, new long[0]) > 0;
    }
}
