package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;

/** When a world moves: where frames are shortest, and not to and fro. */
class FrameRuleTest {
    /** A world of which only the times of frames are known, in milliseconds. */
    private static final class Times {
        private final FrameRule rule = new FrameRule();
        private final Random noise = new Random(1);
        private final IntToDoubleFunction jvm;
        private final IntToDoubleFunction device;
        private boolean away;
        private int moves;
        private double millis;

        Times(IntToDoubleFunction jvm, IntToDoubleFunction device) {
            this.jvm = jvm;
            this.device = device;
        }

        /** Makes frames; one in fifty is disturbed, and all scatter by a tenth. */
        Times run(int frames, int circles) {
            return run(frames, circles, circles);
        }

        /** The JVM makes frames of circles that are awake, the device of all. */
        Times run(int frames, int circles, int awake) {
            for (int frame = 0; frame < frames; frame++) {
                double exact = away ? device.applyAsDouble(circles) : jvm.applyAsDouble(awake);
                double here = exact * (1 + 0.1 * noise.nextDouble());
                millis += here;
                if (rule.frame(1e6 * (noise.nextInt(50) == 0 ? 10 * here : here), circles, awake)) {
                    away = !away;
                    moves++;
                    rule.moved(away, true);
                }
            }
            return this;
        }
    }

    /** As on 16 processors with an H200: the device's step takes a fifth of a millisecond at least. */
    private static Times usual() {
        return new Times(n -> n * 80e-6, n -> 0.25 + n * 2e-6);
    }

    @Test
    void aSmallCrowdStaysOnTheJvm() {
        assertThat(usual().run(10_000, 500).moves).isZero();
        assertThat(usual().run(10_000, 2_000).moves).isZero();
    }

    @Test
    void aLargeCrowdGoesToTheDeviceSoonAndStays() {
        Times times = usual().run(60, 50_000);
        assertThat(times.away).isTrue();
        times.run(20_000, 50_000);
        assertThat(times.away).isTrue();
        assertThat(times.moves).isOne();
    }

    @Test
    void aCrowdThatGrowsGoesAndOneThatShrinksComesHome() {
        Times times = usual();
        for (int n = 500; n < 200_000; n += n / 40) {
            times.run(10, n);
        }
        assertThat(times.away).isTrue();
        for (int n = 200_000; n > 500; n -= n / 40) {
            times.run(10, n);
        }
        assertThat(times.away).isFalse();
        assertThat(times.moves).isEqualTo(2);
    }

    @Test
    void aHeapThatComesToRestGoesHomeAndOneThatWakesGoesAway() {
        Times times = usual().run(200, 200_000);
        assertThat(times.away).isTrue();
        times.run(100, 200_000, 200);
        assertThat(times.away).isFalse();
        times.run(20_000, 200_000, 200);
        assertThat(times.moves).isEqualTo(2);
        times.run(60, 200_000);
        assertThat(times.away).isTrue();
        assertThat(times.moves).isEqualTo(3);
    }

    @Test
    void aHeapOnADeviceThatHasNothingToDoStaysThere() {
        Times times = new Times(n -> n * 80e-6, n -> 0.02).run(200, 200_000);
        assertThat(times.run(2_000, 200_000, 0).moves).isOne();
    }

    @Test
    void aSlowDeviceIsTriedSeldom() {
        Times times = new Times(n -> n * 80e-6, n -> 2 + n * 200e-6).run(100_000, 50_000);
        assertThat(times.away).isFalse();
        assertThat(times.moves).isLessThan(12);
        assertThat(times.millis).isLessThan(1.01 * 100_000 * 4 * 1.05);
    }

    @Test
    void aDeviceThatIsAsFastIsNoReasonToSwing() {
        Times times = new Times(n -> n * 80e-6, n -> n * 80e-6).run(100_000, 50_000);
        assertThat(times.moves).isLessThan(12);
    }

    @Test
    void aDeviceThatBecomesFasterThanTheJvmIsFoundAgain() {
        double[] slow = {3};
        Times times = new Times(n -> n * 80e-6, n -> slow[0] * n * 80e-6).run(2_000, 20_000);
        assertThat(times.away).isFalse();
        slow[0] = 0.1;
        times.run(100_000, 20_000);
        assertThat(times.away).isTrue();
    }
}
