package com.example.golf;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Backend;
import io.github.circles2d.Chain;
import io.github.circles2d.Response;
import io.github.circles2d.Rewind;
import io.github.circles2d.Terrain;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;
import java.nio.ByteBuffer;

/** The rules: a ball from the tee to the hole, through sand and a loop, past a mill and over water. */
final class Golf implements Runnable {
    static final int WIDTH = 160, HEIGHT = 62;
    static final float STEP = 1 / 60f, RADIUS = 0.8f, GROUND = 12, HOLE = 146, WATER = 11, LOOP = 66, LOOP_RADIUS = 9;
    static final int SAND = 1, GREEN = 2, RIGHT = 3, LEFT = 4, MILL = 5, BALL = 6, LEAVING = 7; // kinds
    private static final int ROLLING_FRAMES = 400;
    private static final float FASTEST = 50, REST = 0.4f;

    /** From right to left, so that the ball is above: the green with the cup, the pond, the fairway, the sand, the tee. */
    final Chain ground = Chain.of(
            WIDTH, GROUND, 147.3f, GROUND, 147.3f, 9, 144.7f, 9, 144.7f, GROUND, 128, GROUND, 126, 6, 114, 6, 112,
            GROUND, 42, GROUND, 30, GROUND, 0, GROUND);

    final World world;
    final long ball;
    int strokes;
    boolean isHoled, canShoot;
    private final World ghost = World.builder().backend(Backend.JVM).build(); // where a shot would go
    private final Rewind rewind;
    private final long[] partners = new long[4];
    private final float[] contacts = new float[4 * World.CONTACT_STRIDE];
    private int frame, last = -1, before = -1; // frames just before the last two strokes

    Golf(Backend backend) {
        World.Builder builder =
                World.builder().bounds(0, 0, WIDTH, HEIGHT).gravity(0, -30).friction(0.5f);
        world = builder.rollingResistance(0.01f).backend(backend).build();
        world.kind(BALL).setRestitution(0); // so each ground has its own
        world.kind(0).setRestitution(0.45f);
        world.kind(SAND).setRestitution(0).setFriction(1).setRollingResistance(0.5f);
        world.kind(GREEN).setRestitution(0.2f).setRollingResistance(0.06f);
        world.kind(MILL).setRestitution(0.6f);
        world.kind(LEAVING).copyFrom(world.kind(BALL));
        world.setResponse(BALL, LEFT, Response.IGNORE); // it enters the loop below its left half
        world.setResponse(LEAVING, RIGHT, Response.IGNORE); // and leaves it below its right one
        Terrain terrain = world.terrain();
        long[] pieces = new long[ground.pieces()];
        terrain.addChain(ground, 0, pieces);
        for (int k : new int[] {0, 4, 2, 9}) { // the green; the bottom of the cup, and the sand
            terrain.setKind(pieces[k], k % 4 == 0 ? GREEN : SAND);
        }
        float pi = (float) Math.PI;
        terrain.addArc(LOOP, GROUND + LOOP_RADIUS, LOOP_RADIUS, -pi / 2, 0.7f * pi, ArcSide.INNER, RIGHT);
        terrain.addArc(LOOP, GROUND + LOOP_RADIUS, LOOP_RADIUS, 0.3f * pi, 1.5f * pi, ArcSide.INNER, LEFT);
        TerrainBody mill = terrain.addBody(98, 24, 0);
        for (int k = 0; k < 4; k++) {
            float x = (float) StrictMath.cos(k * pi / 2), y = (float) StrictMath.sin(k * pi / 2);
            mill.addSegment(2 * x, 2 * y, 11 * x, 11 * y, 0.4f, MILL);
        }
        mill.setAngularVelocity(-1.1f);
        ball = world.add(10, GROUND + RADIUS, RADIUS, 1, 0, 0, BALL);
        rewind = new Rewind(world, 60 * 60);
    }

    /** Before each step of the world. */
    @Override
    public void run() {
        boolean isOnTheGround = false;
        for (int k = Math.min(partners.length, world.contactsOf(ball, partners, contacts)) - 1; k >= 0; k--) {
            isOnTheGround |= contacts[World.CONTACT_STRIDE * k + World.NORMAL_Y] > 0.7f;
        }
        canShoot = !isHoled && isOnTheGround && Math.abs(world.vx(ball)) + Math.abs(world.vy(ball)) < REST;
        rewind.save(frame++);
        isHoled |= world.y(ball) < GROUND - 1 && Math.abs(world.x(ball) - HOLE) < 1.3f;
        takeRound(world);
    }

    /** The ball changes its kind over the top of the loop, and back once it has left. The ghost does the same. */
    private void takeRound(World in) {
        float x = in.x(ball), y = in.y(ball);
        if (y > GROUND + LOOP_RADIUS && Math.abs(x - LOOP) < LOOP_RADIUS && x < LOOP) {
            in.setKind(ball, LEAVING);
        } else if (Math.abs(x - LOOP) > LOOP_RADIUS + RADIUS) {
            in.setKind(ball, BALL);
        }
    }

    boolean isInWater() {
        return isWet(world.x(ball), world.y(ball));
    }

    private static boolean isWet(float x, float y) {
        return y < WATER && Math.abs(x - 120) < 7;
    }

    /** A velocity from where the ball is to where the mouse is. */
    float[] aim(float mouseX, float mouseY) {
        float dx = mouseX - world.x(ball), dy = mouseY - world.y(ball);
        float speed = 1.5f * (float) Math.sqrt(dx * dx + dy * dy);
        float share = 1.5f * Math.min(1, FASTEST / Math.max(speed, 1));
        return new float[] {share * dx, share * dy};
    }

    void shoot(float vx, float vy) {
        before = last;
        last = frame - 1;
        strokes++;
        world.setVelocity(ball, vx, vy);
        canShoot = false;
    }

    /** Goes back to before the last stroke, which then has never been, if it is not to count. */
    void undo(int uncounted) {
        if (last >= 0 && rewind.has(last)) {
            rewind.restore(last);
            frame = last + 1;
            strokes -= uncounted;
            isHoled = false;
            last = last == before ? -1 : before; // two in a row
        }
    }

    /** Where the ball would be after each of so many steps, x and y, in another world that goes on from this one. */
    float[] ghost(float vx, float vy, int steps) {
        ByteBuffer now = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(now);
        ghost.restore(now.flip());
        ghost.setVelocity(ball, vx, vy);
        float[] way = new float[2 * steps];
        for (int k = 0; k < steps; k++) {
            takeRound(ghost);
            ghost.step(STEP);
            way[2 * k] = ghost.x(ball);
            way[2 * k + 1] = ghost.y(ball);
        }
        return way;
    }

    /** A player without hands tries many shots on the ghost, and takes the one that comes to lie nearest to the hole. */
    void playAlone() {
        float[] best = {0, 0};
        float least = Float.POSITIVE_INFINITY;
        for (int k = 0; canShoot && k < 56; k++) {
            double angle = Math.toRadians(4 + k / 8 * 12);
            float speed = (world.x(ball) < HOLE ? FASTEST : -FASTEST) * (1 + k % 8) / 8;
            float[] shot = {speed * (float) StrictMath.cos(angle), Math.abs(speed) * (float) StrictMath.sin(angle)};
            float[] way = ghost(shot[0], shot[1], ROLLING_FRAMES);
            float x = way[way.length - 2], y = way[way.length - 1];
            float away = Math.abs(x - HOLE) + (y < GROUND - 2 ? 0 : 2) + (isWet(x, y) ? WIDTH : 0);
            best = away < least ? shot : best;
            least = Math.min(away, least);
        }
        if (least < Float.POSITIVE_INFINITY) {
            shoot(best[0], best[1]);
        }
    }
}
