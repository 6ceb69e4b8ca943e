package io.github.circles2d.world.snapshots;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import io.github.circles2d.Chain;
import io.github.circles2d.Edge;
import io.github.circles2d.Events;
import io.github.circles2d.Inertia;
import io.github.circles2d.Joint;
import io.github.circles2d.Joints;
import io.github.circles2d.Response;
import io.github.circles2d.Terrain;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.Wall;
import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import io.github.circles2d.opencl.TestScale;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Snapshots that somebody has written with a check that fits: refused, or a world as sound as any other. */
class ForgedSnapshotTest {
    private static final int FORGERIES = TestScale.of(1_500, 3_000, 20_000);
    private static final int[] HOSTILE = {
        Float.floatToRawIntBits(Float.NaN),
        Float.floatToRawIntBits(Float.POSITIVE_INFINITY),
        Float.floatToRawIntBits(Float.NEGATIVE_INFINITY),
        Float.floatToRawIntBits(Float.MAX_VALUE),
        Float.floatToRawIntBits(Float.MIN_VALUE),
        Float.floatToRawIntBits(-0f),
        Float.floatToRawIntBits(1e9f),
        Float.floatToRawIntBits(-1e12f),
        Float.floatToRawIntBits(1e24f),
        Float.floatToRawIntBits(1e-9f),
        0,
        1,
        -1,
        Integer.MAX_VALUE,
        Integer.MIN_VALUE
    };

    @ParameterizedTest
    @EnumSource(Edge.class)
    void areRefusedOrLeadToFiniteStates(Edge edge) {
        Random random = new Random(8);
        int accepted = 0;
        try (World world = WorldScenes.jvm()
                        .bounds(0, 0, 100, 40)
                        .edges(edge, edge)
                        .gravity(0, -9)
                        .threads(1)
                        .build();
                World target = WorldScenes.jvm().threads(1).build()) {
            world.report(Events.BEGIN | Events.HIT | Events.END | Events.WALL);
            target.report(Events.BEGIN | Events.HIT | Events.END | Events.WALL);
            for (int i = 0; i < 12; i++) {
                world.add(10 + 3 * i, 1 + i % 3, 2, i % 5 == 0 ? Float.POSITIVE_INFINITY : 1 + i, 3 * i, -i);
            }
            world.setTag(world.add(70, 20, 1, 1), -5);
            world.setTag(world.add(75, 20, 1, 1), Long.MAX_VALUE);
            world.setKind(world.add(80, 20, 1, 1), 3);
            world.setGroup(world.add(80, 21, 1, 1), -7);
            world.kind(3).setMask(5).setRestitution(0.25f).setSensor(true);
            world.setResponse(0, 3, Response.SOLID);
            world.kind(3).setDamping(2).setGravityScale(-1).setGreatestSpeed(7);
            world.setForce(world.add(85, 21, 1, 1), -7, 3);
            world.kind(0).setFriction(0.7f).setRollingResistance(0.1f);
            world.kind(3).setInertia(Inertia.RING).setBeltSpeed(-2).setAngularDamping(1);
            world.setWallSurface(Wall.MIN_Y, 0.5f, 0.25f, 3);
            world.setTorque(world.add(60, 1, 1, 1), 5);
            world.setAngularVelocity(world.add(62, 1, 1, 1), -6);
            world.setFriction(world.add(64, 1, 1, 1), 0.25f);
            long own = world.add(67, 1, 1, 1);
            world.setGravityScale(own, -0.5f);
            world.setDamping(own, 3);
            world.setGreatestSpeed(own, Float.POSITIVE_INFINITY);
            world.remove(world.add(50, 20, 1, 1));
            Terrain terrain = world.terrain();
            terrain.addChain(Chain.of(46, 0.5f, 30, 0.5f, 20, 0.4f, 8, 0.5f));
            TerrainBody slope = terrain.addBody(65, 1, 0.5f);
            slope.addSegment(-6, 0, 6, 0);
            long[] jointed = new long[6];
            for (int i = 0; i < jointed.length; i++) {
                jointed[i] = world.add(10 + 3 * i, 30 + i % 2, 1, 1 + i);
            }
            join(world.joints(), jointed, slope);
            long travelling = world.add(20, 20, 1, Float.POSITIVE_INFINITY);
            world.step(1 / 60f, 30);
            long touching = world.add(20, 20, 1, 1);
            world.add(21, 20, 1, 1);
            world.step(1 / 60f);
            world.remove(touching);
            terrain.remove(terrain.handle(1));
            world.applyForce(world.add(85, 25, 1, 1), 40, 0);
            world.setPosition(travelling, 25, 22);
            world.applyTorque(world.add(85, 27, 1, 1), 40);
            world.setAngle(travelling, 2);
            world.grow(travelling, 2, 3);
            ByteBuffer good = ByteBuffer.allocate(world.snapshotBytes()).order(ByteOrder.LITTLE_ENDIAN);
            world.snapshot(good);
            for (int k = 0; k < FORGERIES; k++) {
                ByteBuffer forged = forge(good, random);
                long before = target.hash();
                try {
                    target.restore(forged);
                    accepted++;
                } catch (IllegalArgumentException e) {
                    assertThat(target.hash()).isEqualTo(before);
                }
                target.step(1 / 60f, 3);
                assertFinite(target);
                assertSound(target.joints());
                Events events = target.events();
                for (int i = 0; i < events.size(); i++) {
                    assertThat(events.speed(i)).isFinite();
                    assertThat(events.slipSpeed(i)).isFinite();
                    assertThat(events.impulse(i)).isFinite();
                    assertThat(events.a(i)).isNotZero();
                }
            }
        }
        assertThat(accepted).isBetween(FORGERIES / 20, FORGERIES);
    }

    @Test
    void aLaterVersionIsNamed() {
        try (World world = WorldScenes.jvm().threads(1).build()) {
            ByteBuffer good = ByteBuffer.allocate(SnapshotCodec.HEADER).order(ByteOrder.LITTLE_ENDIAN);
            world.snapshot(good);
            ByteBuffer version = copy(good, 0).putInt(4, 2);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.restore(version))
                    .withMessageContaining("from a later version")
                    .withMessageContaining("its version is 2");
            ByteBuffer field = withSection(good, 999);
            assertIllegalArgument("from a later version", () -> world.restore(field));
            ByteBuffer section = withSection(good, 1_999);
            assertIllegalArgument("a section with the unknown number 1999", () -> world.restore(section));
        }
    }

    private static ByteBuffer withSection(ByteBuffer good, int number) {
        ByteBuffer later = copy(good, 12);
        later.putInt(SnapshotCodec.HEADER, number).putInt(SnapshotCodec.HEADER + 4, 1);
        later.putInt(8, later.limit()).putInt(60, 1); // length and number of sections
        return later.putLong(SnapshotCodec.CHECK_AT, SnapshotCodec.check(later, later.limit()));
    }

    private static ByteBuffer copy(ByteBuffer good, int more) {
        ByteBuffer copy = ByteBuffer.allocate(good.limit() + more).order(ByteOrder.LITTLE_ENDIAN);
        return copy.put(0, good, 0, good.limit());
    }

    /** Joints of all kinds; one goes. */
    private static void join(Joints joints, long[] circles, TerrainBody body) {
        joints.add(circles[0], circles[1], Joint.weld().breakingAt(1e6f, 1e5f));
        joints.add(circles[1], circles[2], Joint.spring(3, 0.5f).withLimits(1, 4));
        joints.remove(joints.add(circles[1], circles[2], Joint.distance()));
        joints.add(circles[2], circles[3], Joint.rope(3.2f));
        joints.add(circles[3], circles[4], Joint.distance().colliding(true));
        joints.add(circles[4], body, 1, 2, Joint.limits(2, 60));
        joints.add(circles[0], 9, 33, Joint.pin());
        joints.add(circles[4], 23, 33, Joint.mouse(4, 0.5f, 1_000));
        joints.add(circles[5], circles[4], Joint.motor(-3, 20));
        joints.add(circles[5], Joint.servo(1, 3, 0.7f, 30));
        joints.add(circles[5], Joint.friction(5, 3));
    }

    private static ByteBuffer forge(ByteBuffer good, Random random) {
        int length = good.limit();
        ByteBuffer forged = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
        forged.put(0, good, 0, length);
        for (int changes = 1 + random.nextInt(3); changes > 0; changes--) {
            switch (random.nextInt(3)) {
                case 0 -> forged.put(random.nextInt(length), (byte) random.nextInt());
                case 1 -> forged.putInt(random.nextInt(length - 3), HOSTILE[random.nextInt(HOSTILE.length)]);
                default -> {
                    int at = random.nextInt(length);
                    forged.put(at, (byte) (forged.get(at) ^ 1 << random.nextInt(8)));
                }
            }
        }
        forged.putLong(SnapshotCodec.CHECK_AT, SnapshotCodec.check(forged, length));
        return forged;
    }

    private static void assertSound(Joints joints) {
        float[] ends = new float[4 * joints.size()];
        joints.readEnds(ends);
        for (float each : ends) {
            assertThat(each).isFinite();
        }
        for (int id = 0; id < joints.idLimit(); id++) {
            if (joints.handle(id) != 0) {
                assertThat(joints.force(joints.handle(id))).isNotNaN();
                assertThat(joints.torque(joints.handle(id))).isNotNaN();
            }
        }
    }

    private static void assertFinite(World world) {
        float[] values = new float[4 * world.size()];
        world.read(values);
        for (int k = 0; k < values.length; k++) {
            if (k % 4 != 3) {
                assertThat(values[k]).isFinite();
            }
        }
        float[] turning = new float[world.idLimit()];
        world.readAngularVelocitiesById(turning, null);
        for (int id = 0; id < turning.length; id++) {
            if (world.handle(id) != 0) {
                assertThat(turning[id]).isBetween(-1e9f, 1e9f);
            }
        }
        float[] velocities = new float[2 * world.size()];
        world.readVelocities(velocities);
        for (float v : velocities) {
            assertThat(v).isBetween(-1e9f, 1e9f);
        }
    }
}
