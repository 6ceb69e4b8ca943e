package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import java.io.IOException;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Tag;

/**
 * Whatever the engine accepts stays finite for 1,000 loops. Most values lie at the ends of ranges or far beyond them; those that the
 * engine refuses are drawn again.
 */
class Circles2DFuzzTest {
    private static final int PROGRAMS = Integer.getInteger("circles2d.fuzz.thesis", 1);
    private static final int LOOPS = 1_000;
    private static final int CIRCLES = 32;

    private static final float[] MAGNITUDES = {
        0, Float.MIN_VALUE, 1e-22f, 1e-9f, 1e-6f, 1e-3f, 0.01f, 0.3f, 1, 1e4f, 1e6f, 1e9f, 1e20f, Float.MAX_VALUE
    };

    @OnEachDevice
    void whatIsAcceptedStaysFiniteForAThousandLoops(Device device) throws IOException {
        run(device, 0, PROGRAMS);
    }

    /** Those that follow. */
    @OnEachDevice
    @Tag("exhaustive")
    void soDoMore(Device device) throws IOException {
        run(device, PROGRAMS, 4);
    }

    private static void run(Device device, int first, int programs) throws IOException {
        for (int program = first; program < first + programs; program++) {
            for (int strategy = 0; strategy <= 3; strategy++) {
                long seed = Long.getLong("circles2d.fuzz.seed", 12) + 4L * program + strategy;
                try (Circles2D engine = new Circles2D(device)) {
                    String text = "strategy " + strategy + ", seed " + seed + ": " + start(engine, strategy, seed);
                    for (int k = 0; k < LOOPS - 1; k++) {
                        engine.step();
                    }
                    requireFinite(text, engine.loop());
                    requireFinite(text, engine.velocities());
                }
            }
        }
    }

    private static void requireFinite(String program, float[][] rows) {
        for (float[] row : rows) {
            for (float value : row) {
                assertThat(value).as(program).isFinite();
            }
        }
    }

    /** A scene draws each property from a few values of its own, so that there are crowds of equals and of unequals. */
    private static String start(Circles2D engine, int strategy, long seed) throws IOException {
        Random random = new Random(seed);
        float[][] palettes = new float[6][];
        while (engine.size() < CIRCLES) {
            for (int k = 0; k < palettes.length; k++) {
                // What was refused may have come from a palette that holds nothing else.
                palettes[k] = palettes[k] == null || engine.size() == 0 ? palette(random) : palettes[k];
            }
            try {
                // Off each other: coincident centres have no contact.
                float x = pick(palettes[0], random) + 0.1f * random.nextFloat();
                float y = pick(palettes[1], random) + 0.1f * random.nextFloat();
                float radius = Math.abs(pick(palettes[2], random));
                float mass = Math.abs(pick(palettes[3], random));
                engine.addCircle(x, y, radius, mass, pick(palettes[4], random), pick(palettes[5], random));
            } catch (IllegalArgumentException e) {
                continue;
            }
        }
        while (true) {
            float step = Math.abs(pick(palette(random), random));
            float[] gravity = palette(random);
            float restitution = random.nextInt(3) == 0 ? random.nextFloat() : 1;
            try {
                engine.init(step, strategy, restitution, Arrays.copyOf(gravity, 2));
                return "h " + step + ", e " + restitution + ", gravity " + Arrays.toString(gravity) + ", palettes "
                        + Arrays.deepToString(palettes);
            } catch (IllegalArgumentException e) {
                continue;
            }
        }
    }

    private static float[] palette(Random random) {
        float[] palette = new float[2 + random.nextInt(2)];
        for (int k = 0; k < palette.length; k++) {
            float magnitude = MAGNITUDES[random.nextInt(MAGNITUDES.length)];
            palette[k] = random.nextBoolean() ? magnitude : -magnitude;
        }
        return palette;
    }

    private static float pick(float[] palette, Random random) {
        return palette[random.nextInt(palette.length)];
    }
}
