package io.github.circles2d.bench.broadphase;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Arrays;
import java.util.Random;
import java.util.function.IntFunction;

/**
 * The scenes of the comparison. Gravity and speeds are scaled by sqrt(1250 / n) as radii are: with more circles, a step is the
 * same in radii, and only n changes. To add a scene, add a line.
 */
enum Crowds {
    PACKED("packed", "similar radii, fill 0.62, overlaps coming apart", true, Crowds::packed),
    GAS("gas", "similar radii, fill 0.3, elastic", true, n -> gas(n, 1)),
    PILE("pile", "nearly equal radii, a dense lattice that settles on the floor", true, Crowds::pile),
    MIXED_10("mixed-10", "radii 1:10, log-uniform, fill 0.4, falling slowly", false, n -> mixed(n, 10)),
    MIXED_100("mixed-100", "radii 1:100, log-uniform, fill 0.4, falling slowly", true, n -> mixed(n, 100)),
    BOULDERS("boulders", "similar radii, one in a thousand 30 times as large, fill 0.4", false, Crowds::boulders),
    CORNER("corner", "packed, shrunk into a hundredth of the arena", false, Crowds::corner),
    FAST("fast", "gas, started eight times as fast", false, n -> gas(n, 8));

    private static final double MIXED_FILL = 0.4;

    private static final double PILE_HEIGHT = 0.6;

    /** In the table. */
    final String title;

    /** In a few words. */
    final String description;

    /** Whether it is measured with a million circles, too: not all are, because that takes most of the time. */
    final boolean large;

    private final IntFunction<Crowd> factory;

    Crowds(String title, String description, boolean large, IntFunction<Crowd> factory) {
        this.title = title;
        this.description = description;
        this.large = large;
        this.factory = factory;
    }

    Crowd of(int n) {
        return factory.apply(n);
    }

    /**
     * Finds one by its name.
     *
     * @throws IllegalArgumentException with all names if there is none of this one
     */
    static Crowds named(String title) {
        return Arrays.stream(values())
                .filter(crowd -> crowd.title.equals(title))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("there is no scene " + title + "; there are "
                        + String.join(
                                ", ", Arrays.stream(values()).map(c -> c.title).toList())));
    }

    private static float scale(int n) {
        return (float) Math.sqrt((double) Scenes.THESIS_SIZE / n);
    }

    private static Crowd packed(int n) {
        return of(Scenes.packed(n, Scenes.SEED), 1, -0.01f * scale(n));
    }

    private static Crowd gas(int n, float speed) {
        return of(Scenes.gas(n, Scenes.SEED), speed * scale(n), 0);
    }

    private static Crowd of(Scene scene, float speed, float gravity) {
        float[] circles = new float[4 * scene.size()];
        float[] velocities = new float[2 * scene.size()];
        for (int i = 0; i < scene.size(); i++) {
            put(circles, i, scene.x(i), scene.y(i), scene.radius(i), scene.mass(i));
            velocities[2 * i] = speed * scene.vx(i);
            velocities[2 * i + 1] = speed * scene.vy(i);
        }
        return new Crowd(circles, velocities, gravity, scene.restitution());
    }

    private static void put(float[] circles, int i, float x, float y, float r, float mass) {
        circles[4 * i] = x;
        circles[4 * i + 1] = y;
        circles[4 * i + 2] = r;
        circles[4 * i + 3] = mass;
    }

    private static Crowd corner(int n) {
        Crowd packed = packed(n);
        float[] circles = packed.circles();
        for (int i = 0; i < n; i++) {
            put(
                    circles,
                    i,
                    0.1f * circles[4 * i],
                    0.1f * circles[4 * i + 1],
                    0.1f * circles[4 * i + 2],
                    circles[4 * i + 3]);
        }
        return new Crowd(circles, packed.velocities(), 0.1f * packed.gravity(), packed.restitution());
    }

    /** Rows of circles, each row in the gaps of the one below; the numbers of the circles are in random order. */
    private static Crowd pile(int n) {
        double pitch = Math.sqrt(PILE_HEIGHT / (Math.sqrt(0.75) * n));
        int columns = (int) (1 / pitch - 0.5);
        double wide = 1 / (columns + 0.5);
        Random random = new Random(Scenes.SEED);
        float[] circles = new float[4 * n];
        int[] numbers = shuffled(n, random);
        for (int place = 0; place < n; place++) {
            int row = place / columns;
            double x = wide * (place % columns + (row % 2 == 0 ? 0.5 : 1));
            double y = wide * (0.5 + Math.sqrt(0.75) * row);
            double r = 0.5 * wide * (0.99 + 0.01 * random.nextDouble());
            put(circles, numbers[place], (float) x, (float) y, (float) r, 1 + 9 * random.nextFloat());
        }
        return new Crowd(circles, new float[2 * n], -0.01f * scale(n), 0);
    }

    private static Crowd mixed(int n, double ratio) {
        Random random = new Random(Scenes.SEED);
        float[] radius = new float[n];
        for (int i = 0; i < n; i++) {
            radius[i] = (float) Math.pow(ratio, random.nextDouble());
        }
        return scattered(radius, random);
    }

    private static Crowd boulders(int n) {
        Random random = new Random(Scenes.SEED);
        float[] radius = new float[n];
        for (int i = 0; i < n; i++) {
            radius[i] = (i % 1000 == 0 ? 30 : 1) * (1 + 0.5f * random.nextFloat());
        }
        return scattered(radius, random);
    }

    /** Circles whose radii are scaled to a fill, in random order. */
    private static Crowd scattered(float[] radius, Random random) {
        int n = radius.length;
        double squares = 0;
        for (float r : radius) {
            squares += r * r;
        }
        double scale = Math.sqrt(MIXED_FILL / (Math.PI * squares));
        for (int i = 0; i < n; i++) {
            radius[i] *= (float) scale;
        }
        Arrays.sort(radius);
        float[] circles = Darts.throwInto(radius, random);
        float[] mixed = new float[4 * n];
        int[] numbers = shuffled(n, random);
        for (int i = 0; i < n; i++) {
            System.arraycopy(circles, 4 * i, mixed, 4 * numbers[i], 4);
        }
        return new Crowd(mixed, new float[2 * n], -0.01f * scale(n), 0.5f);
    }

    private static int[] shuffled(int n, Random random) {
        int[] numbers = new int[n];
        for (int i = 0; i < n; i++) {
            int other = random.nextInt(i + 1);
            numbers[i] = numbers[other];
            numbers[other] = i;
        }
        return numbers;
    }
}
