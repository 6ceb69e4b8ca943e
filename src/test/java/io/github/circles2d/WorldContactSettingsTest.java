package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a builder says of contacts does what it says. */
class WorldContactSettingsTest {
    private static final float DT = 1 / 60f;
    private static final float R = 0.5f;

    private static World.Builder builder() {
        return WorldScenes.jvm()
                .bounds(0, 0, 10, 60)
                .gravity(0, -10)
                .restitution(0.5f)
                .threads(1);
    }

    /** The greatest speed upwards of a ball after it has fallen on a surface at a speed. */
    private static float bounce(World.Builder builder, float speed, boolean onCircle) {
        try (World world = builder.gravity(0, 0).build()) {
            float height = 2 * R;
            if (onCircle) {
                world.add(5, R, R, Float.POSITIVE_INFINITY);
                height = 4 * R;
            }
            long ball = world.add(5, height, R, 1, 0, -speed);
            world.step(DT, (int) (1.5f * R / speed / DT) + 5);
            return world.vy(ball);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void impactsUpToTheRestitutionThresholdDoNotBounce(boolean onCircle) {
        for (float speed : new float[] {0.2f, 1.9f, 2.1f, 5f}) {
            float after = bounce(builder().restitutionThreshold(2), speed, onCircle);
            assertThat(after / speed)
                    .as("speed %s", speed)
                    .isBetween(speed < 2 ? 0f : 0.45f, speed < 2 ? 0.01f : 0.55f);
            assertThat(bounce(builder().restitutionThreshold(0), speed, onCircle) / speed)
                    .isBetween(0.45f, 0.55f);
        }
    }

    @Test
    void aThresholdOfZeroBouncesWhatTheRuleLetsRest() {
        // one radius a second is too slow for a wall
        assertThat(bounce(builder(), 0.9f * R, false)).isLessThan(0.01f);
        assertThat(bounce(builder().restitutionThreshold(0), 0.9f * R, false)).isGreaterThan(0.4f * R);
    }

    /** How deep a column of ten sinks into itself. */
    private static float sag(World.Builder builder) {
        try (World world = builder.bounds(0, 0, 2.1f * R, 60).build()) {
            for (int i = 0; i < 10; i++) {
                world.add(1.05f * R, R + 2 * R * i, R, 1);
            }
            long top = world.add(1.05f * R, R + 20 * R, R, 1);
            world.step(DT, 1500);
            return 21 * R - world.y(top);
        }
    }

    @Test
    void aLowerFrequencyIsSofter() {
        float usual = sag(builder());
        assertThat(sag(builder().contactFrequency(30))).isGreaterThan(2 * usual);
        assertThat(sag(builder().contactFrequency(71))).isLessThan(usual);
    }

    /** How far two circles part in a tenth of a second, in mean radii, from an overlap. */
    private static float parted(World.Builder builder, float overlap) {
        try (World world = builder.gravity(0, 0).build()) {
            long left = world.add(5, 5, R, 1);
            long right = world.add(5 + 2 * R - overlap * R, 5, R, 1);
            world.step(DT, 6);
            return (world.x(right) - world.x(left)) / R - (2 - overlap);
        }
    }

    @Test
    void aGreaterDampingPushesShallowOverlapsOutMoreSlowly() {
        float usual = parted(builder(), 0.02f);
        assertThat(usual).isBetween(0.01f, 0.015f);
        assertThat(parted(builder().contactDamping(40), 0.02f)).isBetween(0.5f * usual, 0.8f * usual);
        assertThat(parted(builder().contactDamping(5), 0.02f)).isGreaterThan(1.3f * usual);
    }

    @ParameterizedTest
    @ValueSource(floats = {0.2f, 0.4f, 0.8f, 1.6f})
    void overlapsArePushedOutAtTheGreatestSpeed(float speed) {
        assertThat(parted(builder().greatestPushOutSpeed(speed), 0.38f)).isBetween(0.08f * speed, 0.105f * speed);
    }

    @Test
    void deepOverlapsArePushedOutFasterInProportion() {
        float usual = parted(builder(), 1);
        assertThat(usual).isGreaterThan(0.2f);
        assertThat(parted(builder().greatestPushOutSpeed(0.4f), 1)).isBetween(0.4f * usual, 0.7f * usual);
        assertThat(parted(builder().greatestPushOutSpeed(0), 1)).isZero();
    }

    @Test
    void valuesOutOfRangeAreRefusedByName() {
        for (float bad : new float[] {Float.NaN, -1, -1e-9f, Float.POSITIVE_INFINITY}) {
            refused("the restitution threshold", () -> builder().restitutionThreshold(bad));
            refused("the contact frequency", () -> builder().contactFrequency(bad));
            refused("the contact damping", () -> builder().contactDamping(bad));
            refused("the greatest push-out speed", () -> builder().greatestPushOutSpeed(bad));
        }
        refused("the contact frequency is 0.0, but must be from 1.0 to 10000.0", () -> builder()
                .contactFrequency(0));
        refused("the contact damping is 1001.0", () -> builder().contactDamping(1001));
        refused("the greatest push-out speed is 101.0", () -> builder().greatestPushOutSpeed(101));
    }

    private static void refused(String what, Runnable call) {
        assertThatIllegalArgumentException().isThrownBy(call::run).withMessageContaining(what);
    }

    @Test
    void settingsAreStateUnlessTheyAreTheDefault() {
        try (World usual = builder().build();
                World same = builder()
                        .contactFrequency(67)
                        .contactDamping(20)
                        .greatestPushOutSpeed(0.8f)
                        .build();
                World other = builder()
                        .restitutionThreshold(1)
                        .contactFrequency(30)
                        .contactDamping(5)
                        .greatestPushOutSpeed(2)
                        .build()) {
            for (World world : new World[] {usual, same, other}) {
                for (int i = 0; i < 30; i++) {
                    world.add(1 + i % 5, 1 + i / 5, 0.55f, 1, i % 3, 0);
                }
                world.step(DT, 20);
            }
            assertThat(same.hash()).isEqualTo(usual.hash());
            assertThat(snapshot(same)).isEqualTo(snapshot(usual));
            assertThat(other.hash()).isNotEqualTo(usual.hash());
            usual.restore(snapshot(other));
            assertThat(usual.hash()).isEqualTo(other.hash());
            assertThat(usual.restitutionThreshold()).isEqualTo(1);
            assertThat(usual.contactFrequency()).isEqualTo(30);
            assertThat(usual.contactDamping()).isEqualTo(5);
            assertThat(usual.greatestPushOutSpeed()).isEqualTo(2);
            assertThat(same.restitutionThreshold()).isEqualTo(-1);
            usual.step(DT, 20);
            other.step(DT, 20);
            assertThat(usual.hash()).isEqualTo(other.hash());
        }
    }
}
