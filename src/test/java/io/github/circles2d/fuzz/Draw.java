package io.github.circles2d.fuzz;

import java.util.Random;

/** Random numbers for the calls of a program, within what its world promises, at the ends of that, and beyond. */
final class Draw {
    private static final float[] HOSTILE = {
        Float.NaN,
        Float.POSITIVE_INFINITY,
        Float.NEGATIVE_INFINITY,
        0,
        -0f,
        Float.MIN_VALUE,
        -Float.MIN_VALUE,
        Float.MIN_NORMAL,
        Float.MAX_VALUE,
        -Float.MAX_VALUE,
        0x1p-20f,
        1e-9f,
        1e-6f,
        1,
        -1,
        6.2831855f,
        1000,
        1001,
        1e6f,
        -1e6f,
        1e9f,
        -1e9f,
        1.0000001e9f,
        1e18f,
        -1e18f
    };

    /** One of so many values is at an end of its range, and as many are hostile. */
    private static final int ODD = 40;

    /** If a world has things far away, one of so many is. */
    private static final int FAR = 8;

    final Random random;
    final Setting setting;

    Draw(Random random, Setting setting) {
        this.random = random;
        this.setting = setting;
    }

    int below(int bound) {
        return random.nextInt(bound);
    }

    boolean oneOf(int n) {
        return random.nextInt(n) == 0;
    }

    <T> T of(T[] all) {
        return all[random.nextInt(all.length)];
    }

    float plain(float low, float high) {
        return low + random.nextFloat() * (high - low);
    }

    float between(float low, float high) {
        if (setting.hostile && oneOf(ODD)) {
            return HOSTILE[random.nextInt(HOSTILE.length)];
        }
        return oneOf(ODD) ? random.nextBoolean() ? low : high : plain(low, high);
    }

    float x() {
        if (setting.far && oneOf(FAR)) {
            return far();
        }
        float beyond = oneOf(5) ? setting.maxX - setting.minX : 0;
        return between(setting.minX - beyond, setting.maxX + beyond);
    }

    float y() {
        if (setting.far && oneOf(FAR)) {
            return far();
        }
        float beyond = oneOf(5) ? setting.maxY - setting.minY : 0;
        return between(setting.minY - beyond, setting.maxY + beyond);
    }

    /** A coordinate of any size, where no edge may be. */
    private float far() {
        return (oneOf(2) ? -1 : 1) * (float) StrictMath.pow(10, plain(0, 9));
    }

    /** Of some part of the arena, more often short than long. */
    float length() {
        return between(0, setting.size / (1 + random.nextInt(20)));
    }

    float offset() {
        return length() - length();
    }

    float radius() {
        if (setting.hostile && oneOf(2 * ODD)) {
            return between(0, setting.size);
        }
        return setting.radius * (float) StrictMath.pow(setting.ratio, random.nextFloat());
    }

    float mass() {
        return switch (random.nextInt(14)) {
            case 0 -> Float.POSITIVE_INFINITY;
            case 1 -> between(1e-9f, 1e9f);
            default -> between(0.1f, 10);
        };
    }

    float speed() {
        return between(-setting.speed, setting.speed);
    }

    float angle() {
        return oneOf(6) ? between(-1e6f, 1e6f) : between(-7, 7);
    }

    float angularVelocity() {
        return oneOf(6) ? between(-1e9f, 1e9f) : between(-20, 20);
    }

    float force() {
        return oneOf(4) ? between(0, 1e9f) : between(0, 1e4f);
    }

    /** NaN takes an own value back. */
    float coefficient() {
        return oneOf(4) ? Float.NaN : oneOf(5) ? between(0, 1000) : between(0, 1);
    }

    float timeStep() {
        return switch (random.nextInt(14)) {
            case 0 -> 1e-6f;
            case 1 -> 1f;
            case 2 -> between(1e-6f, 1);
            case 3 -> plain(0.001f, 0.1f);
            default -> 1 / 60f;
        };
    }

    int kind() {
        return setting.hostile && oneOf(60) ? random.nextInt(400) - 50 : random.nextInt(6);
    }

    /** A small number, which is rarely out of range. */
    int count(int most) {
        return setting.hostile && oneOf(20) ? random.nextInt(5) - 2 : 1 + random.nextInt(most);
    }

    int bits(int low) {
        return setting.hostile && oneOf(10) ? random.nextInt() : random.nextInt(1 << low);
    }
}
