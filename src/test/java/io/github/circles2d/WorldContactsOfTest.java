package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What presses one circle: who, from where, how deep and how hard. */
class WorldContactsOfTest {
    private static final Offset<Float> NEAR = within(0.02f);

    private final long[] partners = new long[8];
    private final float[] contacts = new float[8 * World.CONTACT_STRIDE];

    static Stream<World.Builder> backEnds() {
        return Stream.concat(
                Stream.of(WorldScenes.jvm()),
                TestDevices.all().stream().map(device -> World.builder().device(device)));
    }

    private static World.Builder with(World.Builder builder) {
        return builder.bounds(0, 0, 20, 20).gravity(0, -10).restitution(0);
    }

    private void assertContact(int k, long partner, float nx, float ny, float force) {
        int at = World.CONTACT_STRIDE * k;
        assertThat(partners[k]).isEqualTo(partner);
        assertThat(contacts[at + World.NORMAL_X]).isCloseTo(nx, NEAR);
        assertThat(contacts[at + World.NORMAL_Y]).isCloseTo(ny, NEAR);
        assertThat(contacts[at + World.DEPTH]).isBetween(-1e-3f, 0.1f);
        assertThat(contacts[at + World.IMPULSE] * 60).isCloseTo(force, within(0.03f * force));
    }

    @ParameterizedTest
    @MethodSource("backEnds")
    void aBallInACornerHasTheCirclesAndTheWallsThatPressIt(World.Builder builder) {
        try (World world = with(builder).build()) {
            long ball = world.add(1, 1, 1, 2);
            long above = world.add(1, 3, 1, 3);
            world.setForce(ball, -8, 0);
            world.step(1 / 60f, 300);
            assertThat(world.contactsOf(ball, partners, contacts)).isEqualTo(3);
            assertContact(0, above, 0, -1, 30);
            assertContact(1, 0, 1, 0, 8);
            assertContact(2, 0, 0, 1, 50);
            assertThat(world.contactsOf(above, partners, contacts)).isEqualTo(1);
            assertContact(0, ball, 0, 1, 30);
            partners[0] = 7;
            assertThat(world.contactsOf(ball, new long[0], null))
                    .as("it only counts")
                    .isEqualTo(3);
            assertThat(world.contactsOf(ball, partners, new float[2 * World.CONTACT_STRIDE]))
                    .isEqualTo(3);
            world.remove(above);
            assertThat(world.contactsOf(ball, partners, contacts)).isEqualTo(2);
            assertIllegalArgument("no circle has the handle", () -> world.contactsOf(above, partners, contacts));
        }
    }

    @ParameterizedTest
    @MethodSource("backEnds")
    void piecesPressAlongTheirNormals(World.Builder builder) {
        try (World world = with(builder).build()) {
            long[] pieces = new long[2];
            world.terrain().addChain(Chain.of(16, 14, 10, 8, 4, 14), 0, pieces); // a valley of 45 degrees
            long ball = world.add(10, 11, 1, 2);
            world.step(1 / 60f, 300);
            assertThat(world.contactsOf(ball, partners, contacts)).isEqualTo(2);
            float half = (float) Math.sqrt(0.5);
            assertContact(0, pieces[0], -half, half, 20 * half);
            assertContact(1, pieces[1], half, half, 20 * half);
            world.terrain().remove(pieces[0]);
            assertThat(world.contactsOf(ball, partners, contacts)).isEqualTo(1);
            assertContact(0, pieces[1], half, half, 20 * half);
        }
    }

    @Test
    void acrossTheSeamNormalsGoTheShortWay() {
        try (World world = with(WorldScenes.jvm())
                .edges(Edge.WRAP, Edge.WALL)
                .gravity(0, 0)
                .build()) {
            long left = world.add(0.5f, 10, 1, 1);
            long right = world.add(18.55f, 10, 1, 1);
            long wall = world.terrain().addSegment(1.5f, 8, 1.5f, 12);
            world.setForce(right, 8, 0);
            world.step(1 / 60f, 300);
            assertThat(world.contactsOf(left, partners, contacts)).isEqualTo(2);
            assertContact(0, right, 1, 0, 8);
            assertContact(1, wall, -1, 0, 8);
        }
    }

    @Test
    void whoFliesOrIsSensedHasNone() {
        try (World world = with(WorldScenes.jvm()).build()) {
            world.kind(1).setSensor(true);
            long ball = world.add(10, 15, 1, 1);
            world.add(10, 15, 3, Float.POSITIVE_INFINITY, 0, 0, 1);
            assertThat(world.contactsOf(ball, partners, contacts)).isZero();
            world.step(1 / 60f, 3);
            assertThat(world.contactsOf(ball, partners, contacts)).isZero();
        }
    }

    /** The forces of all contacts of a circle are its load, and what one circle does to another is what the other does to it. */
    @Test
    void theyAddUpToTheLoads() {
        Scene scene = Scenes.packed(300, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            world.step(scene.timeStep(), 60);
            float[] loads = new float[2 * world.idLimit()];
            world.readLoadsById(loads, null);
            int pairs = 0;
            for (int id = 0; id < world.idLimit(); id++) {
                long circle = world.handle(id);
                int count = world.contactsOf(circle, partners, contacts);
                assertThat(count).isEqualTo((int) loads[2 * id]).isLessThan(partners.length);
                double sum = 0;
                long[] others = partners.clone();
                float[] impulses = contacts.clone();
                for (int k = 0; k < count; k++) {
                    float impulse = impulses[World.CONTACT_STRIDE * k + World.IMPULSE];
                    sum += impulse / scene.timeStep();
                    if (others[k] != 0) {
                        int back = 0;
                        int n = world.contactsOf(others[k], partners, contacts);
                        while (back < n && partners[back] != circle) {
                            back++;
                        }
                        assertThat(contacts[World.CONTACT_STRIDE * back + World.IMPULSE])
                                .isEqualTo(impulse);
                        assertThat(contacts[World.CONTACT_STRIDE * back + World.NORMAL_X])
                                .isEqualTo(0 - impulses[World.CONTACT_STRIDE * k + World.NORMAL_X]);
                        pairs++;
                    }
                }
                assertThat(sum).isCloseTo(loads[2 * id + 1], within(1e-4 * (1 + loads[2 * id + 1])));
            }
            assertThat(pairs).isGreaterThan(10);
        }
    }
}
