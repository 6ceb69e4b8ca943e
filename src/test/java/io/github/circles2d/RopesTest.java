package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.offset;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Ropes and bridges: their shape, what holds them, and that they keep their length. */
class RopesTest {
    private static final float STEP = 1 / 60f;

    private static World world() {
        return WorldScenes.jvm()
                .bounds(-50, -50, 50, 50)
                .gravity(0, -10)
                .threads(1)
                .build();
    }

    private static double distance(World world, long a, long b) {
        return Math.hypot(world.x(a) - world.x(b), world.y(a) - world.y(b));
    }

    /** From a place over all circles of a rope to a last one. */
    private static double length(World world, float x, float y, JointedCircles rope, long last) {
        long[] circles = rope.circles();
        double sum = Math.hypot(world.x(circles[0]) - x, world.y(circles[0]) - y);
        for (int k = 1; k < circles.length; k++) {
            sum += distance(world, circles[k - 1], circles[k]);
        }
        return sum + distance(world, circles[circles.length - 1], last);
    }

    /** A hundred links of 0.2 with a hundred times the mass of one at the end. Returns the greatest length by the first one. */
    private static double greatestStretch(boolean limited) {
        try (World world = world()) {
            long weight = world.add(0, 20, 0.08f, 100);
            Ropes.End top = Ropes.at(0, 40);
            Ropes.End end = Ropes.circle(weight);
            JointedCircles rope = limited
                    ? Ropes.rope(world, top, end, 99, 0.08f, 1, 0)
                    : Ropes.rope(world, top, end, 99, 0.08f, 1, 0, Joint.distance());
            assertThat(rope.joints()).hasSize(limited ? 101 : 100);
            assertThat(length(world, 0, 40, rope, weight)).isCloseTo(20, offset(1e-4));
            double greatest = 0;
            for (int k = 0; k < 600; k++) {
                world.step(STEP);
                greatest = Math.max(greatest, length(world, 0, 40, rope, weight));
            }
            return greatest / 20 - 1;
        }
    }

    @Test
    void aLongRopeWithAHeavyEndKeepsItsLength() {
        assertThat(greatestStretch(true)).isLessThan(0.001);
        assertThat(greatestStretch(false)).as("what the limit is for").isGreaterThan(0.02);
    }

    @ParameterizedTest
    @ValueSource(floats = {0, 1e-5f, 0.1f, 0.5f, 1})
    void aRopeIsAsLongAsItShouldBeAndHangsToWhereGravityPulls(float slack) {
        try (World world = world()) {
            long from = world.add(-10, 5, 1, 1);
            long to = world.add(10, 12, 0.5f, 1);
            double distance = distance(world, from, to);
            JointedCircles rope = Ropes.rope(world, Ropes.circle(from), Ropes.circle(to), 20, 0.3f, 0.1f, slack);
            long[] circles = rope.circles();
            double sum = distance(world, from, circles[0]);
            assertThat(sum).as("the first circle is outside").isGreaterThanOrEqualTo(1.3 - 1e-4);
            double link = distance(world, circles[0], circles[1]);
            for (int k = 1; k < circles.length; k++) {
                double next = distance(world, circles[k - 1], circles[k]);
                assertThat(next).isCloseTo(link, offset(1e-4));
                sum += next;
            }
            sum += distance(world, circles[19], to);
            assertThat(sum).isCloseTo(distance * (1 + slack), offset(1e-3));
            double straight = 5 + (world.x(circles[10]) + 10) * 7 / 20;
            assertThat(straight - world.y(circles[10])).isBetween(slack < 0.01 ? -1e-4 : 1, distance);
            long limit = rope.joints()[21];
            assertThat(world.joints().joint(limit).maxLength())
                    .isCloseTo((float) (distance * (1 + slack)), offset(1e-3f));
            assertThat(world.joints().joint(limit).collides()).isTrue();
            world.step(STEP);
            for (long circle : circles) {
                assertThat(Math.hypot(world.vx(circle), world.vy(circle)))
                        .as("nothing jumps")
                        .isLessThan(0.5);
            }
        }
    }

    @Test
    void aRopeGoesToPlacesOfTheWorldAndOfBodies() {
        try (World world = world()) {
            TerrainBody body = world.terrain().addBody(5, 20, 1);
            long ball = world.add(5, 10, 0.5f, 10);
            JointedCircles rope = Ropes.rope(world, Ropes.circle(ball), Ropes.on(body, 2, -1), 12, 0.2f, 0.1f, 0);
            float x = (float) (5 + 2 * Math.cos(1) + Math.sin(1));
            float y = (float) (20 + 2 * Math.sin(1) - Math.cos(1));
            assertThat(world.joints().anchorX(rope.joints()[12])).isCloseTo(x, offset(1e-4f));
            assertThat(world.joints().anchorY(rope.joints()[12])).isCloseTo(y, offset(1e-4f));
            assertThat(length(world, x, y, reversed(rope), ball)).isCloseTo(Math.hypot(x - 5, y - 10), offset(1e-3));
            body.setVelocity(0, 1);
            world.step(STEP, 60);
            assertThat(world.y(ball)).as("the body pulls it up").isGreaterThan(10.5f);
        }
    }

    private static JointedCircles reversed(JointedCircles rope) {
        long[] circles = new long[rope.circles().length];
        for (int k = 0; k < circles.length; k++) {
            circles[k] = rope.circles()[circles.length - 1 - k];
        }
        return new JointedCircles(circles, rope.joints());
    }

    @Test
    void aBridgeHoldsWhatIsOnIt() {
        try (World world = world()) {
            JointedCircles bridge = Ropes.bridge(world, Ropes.at(-10, 0), Ropes.at(10, 0), 40, 0.25f, 1, 0.02f);
            assertThat(bridge.circles()).hasSize(40);
            assertThat(bridge.joints()).hasSize(41);
            long ball = world.add(0, 3, 1, 10);
            world.step(STEP, 600);
            assertThat(world.y(ball)).isBetween(-4f, 1f);
            assertThat(Math.abs(world.x(ball))).isLessThan(6);
        }
    }

    @Test
    void linksThatBreakPart() {
        try (World world = world()) {
            long weight = world.add(0, 10, 0.3f, 50);
            JointedCircles rope = Ropes.rope(
                    world,
                    Ropes.at(0, 15),
                    Ropes.circle(weight),
                    9,
                    0.2f,
                    0.1f,
                    0,
                    Joint.distance().breakingAt(100, Float.POSITIVE_INFINITY));
            int joints = world.joints().size();
            assertThat(joints).isEqualTo(rope.joints().length);
            world.step(STEP, 60);
            assertThat(world.joints().size()).isLessThan(joints);
            assertThat(world.y(weight)).isLessThan(8);
        }
    }

    @Test
    void allCirclesAreOfTheKindThatTheCallSays() {
        try (World world = world()) {
            world.kind(3).setRestitution(0.25f).setMask(0);
            long weight = world.add(0, 0, 1, 1);
            Ropes.End top = Ropes.at(0, 20);
            Ropes.End end = Ropes.circle(weight);
            JointedCircles[] all = {
                Ropes.rope(world, top, end, 20, 0.1f, 1, 0, 3),
                Ropes.rope(world, Ropes.at(9, 20), end, 20, 0.1f, 1, 0, Joint.distance(), 3),
                Ropes.bridge(world, Ropes.at(-40, 9), Ropes.at(-20, 9), 20, 0.5f, 1, 0, 3)
            };
            for (JointedCircles made : all) {
                assertThat(made.circles()).hasSize(20);
                for (long circle : made.circles()) {
                    assertThat(world.kindOf(circle)).isEqualTo(3);
                }
                assertThat(world.restitution(made.circles()[19])).isEqualTo(0.25f);
            }
            assertThat(all[0].joints()).as("with its limit").hasSize(22);
            assertThat(all[1].joints()).hasSize(21);
            assertThat(all[2].joints()).hasSize(21);
            assertThat(world.kindOf(weight)).as("an end stays as it is").isZero();
            long plain = Ropes.rope(world, top, end, 20, 0.1f, 1, 0).circles()[0];
            assertThat(world.kindOf(plain)).isZero();

            long ball = world.add(-30, 12, 0.5f, 1);
            world.step(STEP, 90);
            assertThat(world.y(ball))
                    .as("it falls through a bridge that meets nothing")
                    .isLessThan(5);
        }
    }

    /** Joined circles do not push each other, so neighbours may overlap until the next but one would touch. */
    @Test
    void planksMayOverlapByHalfOfThemselves() {
        float radius = 0.25f;
        int most = 79; // 80 links as long as the radius
        try (World world = world()) {
            refused(
                    world,
                    "links must be at least as long",
                    () -> Ropes.bridge(world, Ropes.at(-10, 0), Ropes.at(10, 0), most + 1, radius, 1, 0));
            long[] planks = Ropes.bridge(world, Ropes.at(-10, 0), Ropes.at(10, 0), most, radius, 1, 0)
                    .circles();
            assertThat(planks).hasSize(most);
            world.setGravity(0, 0);
            world.step(STEP, 60);
            for (int k = 1; k < most; k++) {
                assertThat(distance(world, planks[k - 1], planks[k])).isCloseTo(radius, offset(1e-3));
            }
        }
    }

    @Test
    void whatCannotBeIsRefusedAndNothingIsAdded() {
        try (World world = world()) {
            long a = world.add(0, 0, 1, 1);
            long b = world.add(10, 0, 1, 1);
            long gone = world.add(20, 0, 1, 1);
            world.remove(gone);
            Ropes.End from = Ropes.circle(a);
            Ropes.End to = Ropes.circle(b);
            refused(world, "must be from 1 to", () -> Ropes.rope(world, from, to, 0, 0.1f, 1, 0));
            refused(world, "must be from 1 to", () -> Ropes.rope(world, from, to, 100_001, 0.1f, 1, 0));
            refused(world, "slack is NaN", () -> Ropes.rope(world, from, to, 9, 0.1f, 1, Float.NaN));
            refused(world, "slack is -0.1", () -> Ropes.rope(world, from, to, 9, 0.1f, 1, -0.1f));
            refused(world, "slack is 2.0", () -> Ropes.bridge(world, from, to, 9, 0.1f, 1, 2));
            refused(world, "radius", () -> Ropes.rope(world, from, to, 9, Float.NaN, 1, 0));
            refused(world, "radius", () -> Ropes.rope(world, from, to, 9, -1, 1, 0));
            refused(world, "mass", () -> Ropes.rope(world, from, to, 9, 0.1f, 0, 0));
            refused(world, "no room", () -> Ropes.rope(world, from, to, 100, 0.1f, 1, 0));
            refused(world, "no room", () -> Ropes.rope(world, from, to, 1, 5, 1, 0));
            refused(world, "both ends are the circle", () -> Ropes.rope(world, from, Ropes.circle(a), 9, 0.1f, 1, 0));
            refused(
                    world,
                    "both ends of the rope",
                    () -> Ropes.rope(world, Ropes.at(0, 9), Ropes.at(9, 9), 3, 0.1f, 1, 0));
            refused(world, "handle", () -> Ropes.rope(world, from, Ropes.circle(gone), 9, 0.1f, 1, 0));
            refused(world, "static", () -> Ropes.rope(world, from, to, 9, 0.1f, Float.POSITIVE_INFINITY, 0));
            refused(world, "pin", () -> Ropes.rope(world, from, to, 9, 0.1f, 1, 0, Joint.pin()));
            refused(world, "the kind is 256", () -> Ropes.rope(world, from, to, 9, 0.1f, 1, 0, 256));
            refused(world, "the kind is -1", () -> Ropes.rope(world, from, to, 9, 0.1f, 1, 0, Joint.distance(), -1));
            refused(world, "the kind is 1000", () -> Ropes.bridge(world, from, to, 9, 0.1f, 1, 0, 1000));
            refused(world, "the handle of the end is 0", () -> Ropes.circle(0));
            refused(world, "x is NaN", () -> Ropes.at(Float.NaN, 0));
            refused(world, "y is 2.0E9", () -> Ropes.on(world.terrain().ground(), 0, 2e9f));
        }
    }

    private static void refused(World world, String message, Runnable call) {
        int circles = world.size();
        int joints = world.joints().size();
        assertThatIllegalArgumentException().isThrownBy(call::run).withMessageContaining(message);
        assertThat(world.size()).isEqualTo(circles);
        assertThat(world.joints().size()).isEqualTo(joints);
    }
}
