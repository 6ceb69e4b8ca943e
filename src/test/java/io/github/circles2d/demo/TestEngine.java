package io.github.circles2d.demo;

import java.awt.EventQueue;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * An engine for tests: circles that fall freely and bounce on the floor. It keeps account of who called it and how
 * often.
 */
class TestEngine implements Engine {
    /** Asked for by {@link #switchTo}, refused always. */
    static final int REFUSED = 2;

    private final float[][] start;
    private float[][] now;
    private float[] speed;
    int strategy;

    final Set<Thread> callers = Collections.newSetFromMap(new ConcurrentHashMap<>());
    volatile boolean calledOnEventThread;
    volatile int loops;
    volatile int closes;
    volatile int failAtLoop = Integer.MAX_VALUE;

    TestEngine(float[][] start) {
        this.start = start;
        note();
        restart();
    }

    /** Circles of the thesis's sizes and masses, spread over the arena. */
    static float[][] scene(int n, float radiusFactor, long seed) {
        Random random = new Random(seed);
        float[][] circles = new float[4][n];
        for (int k = 0; k < n; k++) {
            circles[0][k] = 0.1f + 0.8f * random.nextFloat();
            circles[1][k] = 0.1f + 0.8f * random.nextFloat();
            circles[2][k] = (0.01f + 0.005f * random.nextFloat()) * radiusFactor;
            circles[3][k] = 1 + 9 * random.nextFloat();
        }
        return circles;
    }

    @Override
    public float[][] loop() throws EngineException {
        note();
        if (++loops == failAtLoop) {
            throw new EngineException("the device is gone", null);
        }
        float[][] next = copy(now);
        for (int k = 0; k < speed.length; k++) {
            speed[k] -= 0.01f * Options.TIME_STEP;
            next[1][k] += speed[k] * Options.TIME_STEP;
            if (next[1][k] < next[2][k]) {
                next[1][k] = next[2][k];
                speed[k] *= -0.5f;
            }
        }
        now = next;
        return next;
    }

    @Override
    public float[][] circles() {
        note();
        return now;
    }

    @Override
    public void restart() {
        note();
        now = copy(start);
        speed = new float[start[0].length];
    }

    @Override
    public String name() {
        return "Test";
    }

    @Override
    public String device() {
        return "no device";
    }

    @Override
    public List<String> strategies() {
        return List.of("0 (one)", "1 (two)", "2 (refused)");
    }

    @Override
    public int strategy() {
        return strategy;
    }

    @Override
    public void switchTo(int wanted) throws EngineException {
        note();
        if (wanted == REFUSED) {
            throw new EngineException("strategy 2 does not fit", null);
        }
        strategy = wanted;
    }

    @Override
    public String remark() {
        return strategy == 1 ? "strategy 1 is remarkable" : "";
    }

    @Override
    public void close() {
        note();
        closes++;
    }

    private void note() {
        callers.add(Thread.currentThread());
        calledOnEventThread |= EventQueue.isDispatchThread();
    }

    private static float[][] copy(float[][] circles) {
        float[][] result = new float[circles.length][];
        for (int k = 0; k < circles.length; k++) {
            result[k] = circles[k].clone();
        }
        return result;
    }
}
