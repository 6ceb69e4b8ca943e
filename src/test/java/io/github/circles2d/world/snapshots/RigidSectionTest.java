package io.github.circles2d.world.snapshots;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import io.github.circles2d.Bodies;
import io.github.circles2d.Outline;
import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import io.github.circles2d.world.bodies.KeptContacts;
import io.github.circles2d.world.bodies.RigidExtras;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.bodies.SavedRigids;
import io.github.circles2d.world.joints.JointTable;
import io.github.circles2d.world.joints.RigidEnds;
import io.github.circles2d.world.joints.SavedJoints;
import io.github.circles2d.world.model.JointRow;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** Rigid bodies, and what steps keep of their contacts, in snapshots: what is kept, and what is refused. */
class RigidSectionTest {
    private static final float STEP = 1 / 60f;

    /** The free id of a body. */
    private static final int GONE = 1;

    private static World world() {
        return WorldScenes.jvm()
                .bounds(0, 0, 40, 20)
                .gravity(0, -10)
                .friction(0.5f)
                .threads(1)
                .build();
    }

    /** Bodies that lie on the floor, on terrain, on each other, and under a circle. */
    private static void build(World world) {
        Bodies bodies = world.bodies();
        bodies.report(true);
        world.terrain().addSegment(20, 2, 30, 2);
        Outline crate = Outline.box(2, 1);
        bodies.add(crate, 5, 0.5f, 0, 3, 2);
        long gone = bodies.add(crate, 15, 5, 0, 3);
        bodies.add(crate, 5.25f, 1.5f, 0, 2);
        bodies.add(Outline.capsule(2, 0.5f), 25, 2.5f, 0, 2);
        bodies.remove(gone);
        bodies.setTag(bodies.handle(0), 1L << 40);
        world.add(5, 2.5f, 0.5f, 1);
        world.step(STEP, 30);
        bodies.applyTorque(bodies.handle(3), 0.25f);
        bodies.setForce(bodies.handle(2), 0.125f, 0);
        bodies.setTorque(bodies.handle(3), -0.5f);
        bodies.setGroup(bodies.handle(0), -5);
    }

    @Test
    void aWorldThatIsRestoredGoesOnAlike() {
        try (World world = world();
                World other = world()) {
            build(world);
            other.bodies().report(true);
            ByteBuffer saved = snapshot(world);
            other.bodies().add(Outline.box(1, 1), 9, 9, 0, 1);
            other.restore(saved.duplicate());
            assertThat(snapshot(other)).isEqualTo(saved);
            world.bodies().events();
            for (int k = 0; k < 60; k++) {
                world.step(STEP);
                other.step(STEP);
                assertThat(other.hash()).isEqualTo(world.hash());
                assertThat(other.bodies().events().size())
                        .isEqualTo(world.bodies().events().size());
            }
        }
    }

    @Test
    void bodiesTouchAllThatTheyLieOn() {
        SavedRigids saved = saved();
        assertThat(saved.contacts.count).isPositive();
        for (int type = RigidStep.BODY_BODY; type <= RigidStep.BODY_CIRCLE; type++) {
            boolean some = false;
            for (int k = 0; k < saved.contacts.count; k++) {
                some |= saved.contacts.type(k) == type;
            }
            assertThat(some).as("contacts of type " + type).isTrue();
        }
        assertThat(saved.touching).isEqualTo(4);
    }

    /** What a snapshot of {@link #build} says of bodies. */
    private static SavedRigids saved() {
        return state().rigids;
    }

    private static SavedState state() {
        try (World world = world()) {
            build(world);
            SavedState s = new SavedState();
            SnapshotCodec.read(snapshot(world), s);
            return s;
        }
    }

    @Test
    void whatCallsCannotLeadToIsRefused() {
        refused("a body has no outline", s -> s.rigids.outline[0] = 1);
        refused("two outlines are one", s -> s.rigids.outlines[1] = s.rigids.outlines[0]);
        refused("x is", s -> set(s, SavedRigids.X, 41));
        refused("a remainder", s -> set(s, SavedRigids.REST_Y, 0.1f));
        refused("vx is", s -> set(s, SavedRigids.VX, Float.NaN));
        refused("the angular velocity", s -> set(s, SavedRigids.OMEGA, 2e9f));
        refused("mass", s -> set(s, SavedRigids.MASS, 0));
        refused("the inertia", s -> set(s, SavedRigids.INERTIA, 1e-9f));
        refused("restitution", s -> set(s, SavedRigids.RESTITUTION, 2));
        refused("torque", s -> set(s, SavedRigids.TORQUE, Float.POSITIVE_INFINITY));
        refused("force", s -> set(s, SavedRigids.EXTRAS + RigidExtras.FORCE_Y, -2e18f));
        refused("torque", s -> set(s, SavedRigids.EXTRAS + RigidExtras.TORQUE, Float.NaN));
        refused("nothing that it touches", s -> s.rigids.contacts.keys[RigidStep.A] = GONE);
        refused("nothing that it touches", s -> s.rigids.contacts.keys[RigidStep.B] = 7);
        refused("nothing that it touches", s -> s.rigids.contacts.keys[RigidStep.TYPE] = 9);
        refused("nothing that it touches", s -> s.rigids.touchingKeys[RigidStep.TOUCH_KEYS * 3 + RigidStep.B] = 5);
        refused(
                "nothing that it touches",
                s -> s.rigids.touchingKeys[RigidStep.TOUCH_KEYS * 3] += 2 * RigidStep.SENSED);
        refused(
                "nothing that it touches", // since no wall is sensed
                s -> s.rigids.touchingKeys[RigidStep.TOUCH_KEYS * 3] = RigidStep.SENSED + RigidStep.BODY_WALL);
        refused("nothing that it touches", s -> s.rigids.contacts.keys[RigidStep.TYPE] += RigidStep.SENSED);
        refused(
                "not in order",
                s -> s.rigids.contacts.keys[KeptContacts.KEYS + KeptContacts.KEYS - 2] = Integer.MIN_VALUE);
        refused(
                "at no part",
                s -> s.rigids.contacts.keys[KeptContacts.FORM_AND_FEATURE] += KeptContacts.formAndFeature(1, 0) >> 1);
        refused("an impulse of a body", s -> s.rigids.contacts.impulses[0] = -1);
        refused("an impulse of a body", s -> s.rigids.contacts.impulses[1] = Float.NaN);
        refused("never does", s -> rest(s, RigidExtras.REST, 3));
        refused("never does", s -> {
            sleep(s);
            rest(s, RigidExtras.REST, 0);
            rest(s, RigidExtras.TURNED, 3);
        });
        refused("a body sleeps that moves", s -> {
            sleep(s);
            set(s, SavedRigids.VX, 1);
        });
        refused("far out of balance", s -> {
            sleep(s);
            rest(s, RigidExtras.SPIN_OFFSET, 8193);
        });
        refused("far out of balance", s -> {
            sleep(s);
            rest(s, RigidExtras.REST, 1);
            rest(s, RigidExtras.SPIN_OFFSET, 1);
        });
        refused("a drift", s -> {
            sleep(s);
            set(s, SavedRigids.EXTRAS + RigidExtras.DRIFT_X, Float.NaN);
        });
        refused("angular acceleration", s -> {
            sleep(s);
            set(s, SavedRigids.EXTRAS + RigidExtras.KNOWN_SPIN, Float.NaN);
        });
    }

    @Test
    void jointsThatCallsCannotLeadToAreRefused() {
        refused("a joint lacks a body", s -> join(s, GONE, 2, 0));
        refused("a joint lacks a body", s -> join(s, 0, 77, 0));
        refused("holds a body to itself", s -> join(s, 2, 2, 0));
        refused("x of the point", s -> join(s, 0, 2, 1000));
        refused("x of the point", s -> join(s, 0, 2, Float.NaN));
        refused("a joint of a body has a colour", s -> {
            join(s, 0, 2, 0);
            s.joints.colour[0] = 1;
        });
        refused("a joint has two other ends", s -> {
            join(s, 0, 2, 0);
            s.joints.b[0] = 0;
        });
        refused("makes no sense", s -> {
            join(s, 0, 2, 0);
            s.joints.form[0] = JointRow.DRAG | JointRow.TURN_SPEED;
        });
    }

    /** Adds a pin between two bodies. */
    private static void join(SavedState s, int a, int b, float x) {
        s.joints.setIds(1);
        s.jointStates.begin(1);
        s.jointStates.clear(0);
        s.joints.form[0] = JointRow.POINT | JointRow.RIGID;
        s.joints.colour[0] = JointTable.SPLIT;
        s.joints.a[0] = JointRow.NONE;
        s.joints.b[0] = JointRow.NONE;
        s.joints.setRigid(0, RigidEnds.A, a, x, 0);
        s.joints.setRigid(0, RigidEnds.B, b, 0, 0);
        for (int k = 0; k < SavedJoints.VALUES; k++) {
            s.joints.values[k] = SavedJoints.initial(k);
        }
    }

    private static void set(SavedState s, int value, float to) {
        s.rigids.values[value] = Float.floatToRawIntBits(to);
    }

    /** Sets a value of how the first body rests. */
    private static void rest(SavedState s, int which, int to) {
        s.rigids.values[SavedRigids.EXTRAS + which] = to;
    }

    /** The first body sleeps, and no circle does. */
    private static void sleep(SavedState s) {
        s.setParameters(s.parameters().sleeping(true));
        s.setSleeps(true);
        Arrays.fill(s.rest, 0);
        Arrays.fill(s.drift, 0f);
        Arrays.fill(s.turned, 0);
        set(s, SavedRigids.VX, 0);
        set(s, SavedRigids.VY, 0);
        set(s, SavedRigids.OMEGA, 0);
        rest(s, RigidExtras.REST, -1);
    }

    private static void refused(String message, Consumer<SavedState> forge) {
        SavedState s = state();
        forge.accept(s);
        ByteBuffer bytes = SnapshotCodec.encode(s, ByteBuffer.allocate(0).order(ByteOrder.LITTLE_ENDIAN));
        SnapshotCodec.addCheck(bytes);
        try (World world = world()) {
            long hash = world.hash();
            assertThatIllegalArgumentException()
                    .as(message)
                    .isThrownBy(() -> world.restore(bytes))
                    .withMessageContaining(message);
            assertThat(world.hash()).isEqualTo(hash);
        }
    }
}
