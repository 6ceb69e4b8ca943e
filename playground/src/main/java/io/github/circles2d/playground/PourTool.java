package io.github.circles2d.playground;

import io.github.circles2d.World;
import java.util.Random;

/** Adds circles near the mouse before each step, wherever there is room. */
final class PourTool implements Tool {
    static final int GREATEST_WORLD = 200_000;

    private static final float REACH = 6;
    private static final int TRIES = 24;
    private static final float LEAST_SIZE = 0.8f;
    private static final float SPREAD = 0.4f;

    /** Radii a second, along gravity. */
    private static final float SPEED = 90;

    private final Random random = new Random(1);
    private final float[] discs = new float[3 * TRIES];
    private final int[] ends = new int[TRIES];
    private boolean pouring;
    private float x;
    private float y;
    private float brush = 1;
    private float size = 1;

    @Override
    public void press(Sandbox sandbox, float atX, float atY, float reach) {
        pouring = true;
        brush = reach;
        drag(sandbox, atX, atY);
    }

    @Override
    public void drag(Sandbox sandbox, float toX, float toY) {
        x = toX;
        y = toY;
    }

    /** Sets how large circles to come are, in those that are usual in the world. */
    void setSize(float factor) {
        size = factor;
    }

    @Override
    public void release(Sandbox sandbox) {
        forget();
    }

    @Override
    public void forget() {
        pouring = false;
    }

    @Override
    public float reach(Grain grain) {
        return REACH * grain.radius();
    }

    @Override
    public void beforeStep(Sandbox sandbox) {
        World world = sandbox.world();
        int room = GREATEST_WORLD - world.size();
        if (!pouring || room < TRIES) {
            return;
        }
        Grain grain = sandbox.grain();
        int count = choose(Arena.of(world), grain);
        world.queries().overlapCircle(discs, count, ends, new long[0]); // one look at the world for all of them
        double gravity = Math.hypot(world.gravityX(), world.gravityY());
        float fall = (float) (gravity > 0 ? SPEED * grain.radius() / gravity : 0);
        for (int k = 0; k < count; k++) {
            if (ends[k] == (k == 0 ? 0 : ends[k - 1])) {
                float r = discs[3 * k + 2];
                world.add(
                        discs[3 * k],
                        discs[3 * k + 1],
                        r,
                        grain.mass(r),
                        fall * world.gravityX(),
                        fall * world.gravityY());
            }
        }
    }

    /** Chooses discs in the arena that leave room for each other. */
    private int choose(Arena arena, Grain grain) {
        float reach = reach(grain) * brush;
        int count = 0;
        for (int k = 0; k < TRIES; k++) {
            double angle = 2 * Math.PI * random.nextDouble();
            double distance = reach * Math.sqrt(random.nextDouble());
            float px = x + (float) (distance * Math.cos(angle));
            float py = y + (float) (distance * Math.sin(angle));
            float r = arena.radius(size * grain.radius() * (LEAST_SIZE + SPREAD * random.nextFloat()));
            if (arena.contains(px - r, py - r) && arena.contains(px + r, py + r) && isFree(count, px, py, r)) {
                discs[3 * count] = px;
                discs[3 * count + 1] = py;
                discs[3 * count + 2] = r;
                count++;
            }
        }
        return count;
    }

    private boolean isFree(int count, float px, float py, float r) {
        for (int k = 0; k < count; k++) {
            if (Math.hypot(discs[3 * k] - px, discs[3 * k + 1] - py) < discs[3 * k + 2] + r) {
                return false;
            }
        }
        return true;
    }
}
