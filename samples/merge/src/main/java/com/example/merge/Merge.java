package com.example.merge;

import io.github.circles2d.Backend;
import io.github.circles2d.Events;
import io.github.circles2d.World;
import java.util.Random;

/** The rules of the game: balls drop, and two of one size that touch merge into one of the next size. A ball's tag is its size. */
final class Merge implements Runnable, AutoCloseable {
    static final float WIDTH = 10;
    static final float HEIGHT = 14;
    static final float LINE = 11; // no ball may rest above it
    static final float DROP_HEIGHT = 12.5f;
    static final float TIME_STEP = 1 / 60f;
    static final float[] RADII = {0.35f, 0.48f, 0.62f, 0.76f, 0.93f, 1.12f, 1.33f, 1.56f, 1.82f, 2.1f, 2.4f};

    private static final int DROPPED_SIZES = 5;
    private static final int STEPS_BETWEEN_DROPS = 36;
    private static final int STEPS_ABOVE_LINE = 120;
    private static final long[] COUNT_ONLY = {};

    final World world;
    private final Random random;
    private float aim = WIDTH / 2;
    private boolean dropWanted;
    private int next;
    private int step;
    private int nextDrop;
    private int aboveLine;
    private int score;

    Merge(Backend backend, long seed) {
        world = World.builder()
                .bounds(0, 0, WIDTH, HEIGHT)
                .gravity(0, -30)
                .restitution(0.2f)
                .backend(backend)
                .build();
        world.report(Events.BEGIN);
        random = new Random(seed);
        next = random.nextInt(DROPPED_SIZES);
    }

    /** The size of the ball that drops next. */
    int next() {
        return next;
    }

    /** Where it drops. */
    float aim() {
        float radius = RADII[next];
        return Math.max(radius, Math.min(WIDTH - radius, aim));
    }

    void aim(float x) {
        aim = x;
    }

    /** Drops the ball as soon as it is ready. */
    void drop() {
        dropWanted = true;
    }

    boolean isReady() {
        return step >= nextDrop && !isOver();
    }

    int score() {
        return score;
    }

    boolean isOver() {
        return aboveLine >= STEPS_ABOVE_LINE;
    }

    /** What comes before each step of the world. */
    @Override
    public void run() {
        if (isOver()) {
            return;
        }
        mergeWhatTouches(world.events());
        boolean crossed = world.queries().overlapBox(0, LINE, WIDTH, HEIGHT, COUNT_ONLY) > 0;
        aboveLine = crossed ? aboveLine + 1 : 0; // a ball that falls is soon below the line
        if (dropWanted && isReady()) {
            addBall(aim(), DROP_HEIGHT, next, 0, -5);
            next = random.nextInt(DROPPED_SIZES);
            nextDrop = step + STEPS_BETWEEN_DROPS;
            dropWanted = false;
        }
        step++;
    }

    private void mergeWhatTouches(Events events) {
        for (int i = 0; i < events.size(); i++) {
            long a = events.a(i);
            long b = events.b(i);
            // An event before this one may have merged one of the two with a third ball.
            if (world.contains(a) && world.contains(b) && world.tag(a) == world.tag(b)) {
                merge(a, b);
            }
        }
    }

    private void merge(long a, long b) {
        int size = (int) world.tag(a) + 1;
        float x = (world.x(a) + world.x(b)) / 2;
        float y = (world.y(a) + world.y(b)) / 2;
        float vx = (world.vx(a) + world.vx(b)) / 2;
        float vy = (world.vy(a) + world.vy(b)) / 2;
        world.remove(a);
        world.remove(b);
        score += size * (size + 1) / 2;
        if (size < RADII.length) { // two of the largest make room
            addBall(x, y, size, vx, vy);
        }
    }

    private void addBall(float x, float y, int size, float vx, float vy) {
        float radius = RADII[size];
        long ball = world.add(x, y, radius, radius * radius, vx, vy);
        world.setTag(ball, size);
    }

    /** A player without hands: drops each ball onto one of its size, if there is one within reach. */
    void playAlone() {
        aim(step * 0.618034f % 1 * WIDTH);
        for (float x = 0.25f; x < WIDTH; x += 0.25f) {
            long below = world.queries().rayCast(x, DROP_HEIGHT, 0, -HEIGHT, null);
            if (below != 0 && world.tag(below) == next) {
                aim(x);
            }
        }
        drop();
    }

    @Override
    public void close() {
        world.close();
    }
}
