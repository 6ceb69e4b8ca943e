package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.reference.BodyOutline;
import io.github.circles2d.reference.JointEvent;
import io.github.circles2d.reference.JointLoad;
import io.github.circles2d.reference.JointPlan;
import io.github.circles2d.reference.JointPlan.Kind;
import io.github.circles2d.reference.ReferenceWorld;
import io.github.circles2d.reference.Surfaces;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Machines of bodies at random, which hang together by joints of all sorts: World has the bits of its description after every step, and the same
 * forces and joints that break.
 */
class ReferenceJointsOfBodiesTest {
    private static final int STEPS = TestScale.of(200, 600);
    private static final float SIZE = 20f;
    private static final int BODIES = 14;
    private static final int CIRCLES = 8;
    private static final int JOINTS = 18;

    static int[] seeds() {
        return new SplittableRandom(51).ints(TestScale.of(6, 60), 0, 1 << 20).toArray();
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void machinesMoveAsThoseOfTheReference(int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Edge x = Edge.values()[random.nextInt(3)];
        Edge y = Edge.values()[random.nextInt(3)];
        Surfaces surfaces = random.nextInt(4) == 0 ? Surfaces.NONE : Surfaces.of(0.5f, 0.01f);
        int subSteps = random.nextInt(3) == 0 ? 1 + random.nextInt(8) : 4;
        float restitution = random.nextInt(3) * 0.4f;
        ReferenceWorld reference = new ReferenceWorld(restitution, subSteps);
        reference.setBounds(0f, 0f, SIZE, SIZE);
        reference.edges(x, y).surfaces(surfaces);
        World.Builder builder = WorldScenes.jvm()
                .bounds(0f, 0f, SIZE, SIZE)
                .edges(x, y)
                .restitution(restitution)
                .subSteps(subSteps)
                .threads(1 + random.nextInt(2));
        try (World world = WorldScenes.with(surfaces, builder).build()) {
            world.joints().report(true);
            new Machines(seed, random, world, reference).run();
        }
    }

    private static final class Machines {
        private final int seed;
        private final SplittableRandom random;
        private final World world;
        private final ReferenceWorld reference;
        private long mill;

        Machines(int seed, SplittableRandom random, World world, ReferenceWorld reference) {
            this.seed = seed;
            this.random = random;
            this.world = world;
            this.reference = reference;
        }

        void run() {
            both(c -> c.setGravity(0f, -10f));
            build();
            for (int k = 0; k < JOINTS; k++) {
                join();
            }
            for (int step = 1; step <= STEPS; step++) {
                if (random.nextInt(8) == 0) {
                    change();
                }
                float dt = random.nextInt(30) == 0 ? 1 / 40f : 1 / 60f;
                both(c -> c.step(dt, 1));
                assertThat(world.hash())
                        .as("hash of %d after step %d", seed, step)
                        .isEqualTo(reference.hash());
                assertThat(JointLoad.of(world.joints()))
                        .as("forces of %d after step %d", seed, step)
                        .isEqualTo(reference.jointLoads());
                assertThat(JointEvent.of(world.joints().events()))
                        .as("joints of %d that went in step %d", seed, step)
                        .isEqualTo(reference.takeJointEvents());
            }
        }

        private void both(Consumer<WorldCalls> call) {
            call.accept(WorldCalls.of(world));
            call.accept(reference);
        }

        /** Makes a call, if World does not refuse it. */
        private void ifAllowed(Consumer<WorldCalls> call) {
            try {
                call.accept(WorldCalls.of(world));
            } catch (IllegalArgumentException e) {
                return;
            }
            call.accept(reference);
        }

        private float value(float least, float most) {
            return least + (most - least) * (float) random.nextDouble();
        }

        private void build() {
            both(c -> c.addSegment(0L, 1f, 2f, 10f, 1f, 0.1f, 0));
            both(c -> c.addSegment(0L, 10f, 1f, 19f, 1.5f, 0.1f, 0));
            both(c -> mill = c.addBody(10f, 14f, 0.3f));
            both(c -> c.addSegment(mill, -2f, 0f, 2f, 0f, 0.1f, 0));
            for (int k = 0; k < BODIES; k++) {
                BodyOutline outline = k % 3 == 0
                        ? BodyOutline.capsule(1f, 0.2f)
                        : BodyOutline.box(value(0.5f, 1.5f), value(0.2f, 1f));
                float x = value(1f, 19f);
                float y = value(3f, 18f);
                float angle = value(-3f, 3f);
                float mass = value(0.2f, 3f);
                both(c -> c.addRigid(outline, x, y, angle, mass, 0));
            }
            for (int k = 0; k < CIRCLES; k++) {
                float x = value(1f, 19f);
                float y = value(3f, 18f);
                float mass = k == 0 ? Float.POSITIVE_INFINITY : value(0.2f, 2f);
                both(c -> c.add(x, y, 0.4f, mass, 0f, 0f));
            }
        }

        private JointPlan plan() {
            Kind kind = Kind.values()[random.nextInt(Kind.values().length)];
            float hertz = random.nextInt(4) == 0 ? value(0f, 200f) : value(0.5f, 12f);
            float damping = value(0f, 1.5f);
            float[] numbers =
                    switch (kind) {
                        case SPRING, SOFT_PIN -> new float[] {hertz, damping};
                        case MOUSE -> new float[] {hertz, damping, value(5f, 200f)};
                        case MOTOR -> new float[] {value(-8f, 8f), value(0f, 20f)};
                        case SERVO -> new float[] {value(-2f, 2f), hertz, damping, value(0f, 50f)};
                        case FRICTION -> new float[] {value(0f, 20f), value(0f, 5f)};
                        default -> new float[0];
                    };
            JointPlan plan = JointPlan.of(kind, numbers);
            if (kind == Kind.LIMITS || kind == Kind.SPRING && random.nextInt(3) == 0) {
                float least = random.nextBoolean() ? 0f : value(0f, 1f);
                plan = plan.withLimits(least, random.nextInt(4) == 0 ? Float.POSITIVE_INFINITY : least + value(0f, 4f));
            }
            plan = random.nextInt(3) == 0 ? plan.breakingAt(value(20f, 2000f), value(5f, 500f)) : plan;
            return random.nextInt(4) == 0 ? plan.colliding(true) : plan;
        }

        private long some(long[] all) {
            return all[random.nextInt(all.length)];
        }

        private void join() {
            long body = some(reference.rigids());
            long other = some(reference.rigids());
            long[] circles = new long[world.size()];
            world.readHandles(circles);
            long circle = some(circles);
            float ax = value(-0.7f, 0.7f);
            float ay = value(-0.3f, 0.3f);
            float bx = value(-0.7f, 0.7f);
            float by = value(-0.3f, 0.3f);
            // of half of them both ends lie at one place at first
            boolean meets = random.nextBoolean() && body != other;
            JointPlan plan = plan();
            if (meets) {
                float x = world.bodies().x(body) + 1f;
                both(c ->
                        c.teleportRigid(other, Math.min(x, 19f), world.bodies().y(body), 0.1f));
            }
            switch (random.nextInt(7)) {
                case 0, 1, 2 -> ifAllowed(c -> c.addRigidJoint(body, ax, ay, other, bx, by, plan));
                case 3 -> ifAllowed(c -> c.addRigidJointToCircle(body, ax, ay, circle, plan));
                case 4 -> ifAllowed(c -> c.addRigidJointToPlace(body, ax, ay, 10f * (1f + ax), 10f + 8f * bx, plan));
                case 5 -> ifAllowed(c -> c.addRigidJointToBody(body, ax, ay, mill, 2f * bx, by, plan));
                default -> {
                    ifAllowed(c -> c.addJoint(body, plan));
                    ifAllowed(c -> c.addJoint(circle, body, plan));
                }
            }
        }

        private void change() {
            long body = some(reference.rigids());
            float x = value(-5f, 5f);
            float y = value(-5f, 5f);
            int limit = world.joints().idLimit();
            long joint = limit == 0 ? 0 : world.joints().handle(random.nextInt(limit));
            switch (random.nextInt(joint == 0 ? 4 : 9)) {
                case 0 -> join();
                case 1 -> both(c -> c.pushRigid(body, x, y, 10f, 10f));
                case 2 -> both(c -> c.setBodyVelocity(mill, 0.1f * x, 0.1f * y, 0.3f * x));
                case 3 -> both(c -> c.setRigidInertia(body, x > 4f ? Float.POSITIVE_INFINITY : 1f));
                case 4 -> ifAllowed(c -> c.setJointAnchor(joint, 10f + x, 10f + y));
                case 5 -> ifAllowed(c -> c.setJointSpeed(joint, x));
                case 6 -> ifAllowed(c -> c.setJointLimits(joint, 0f, Math.abs(x)));
                case 7 -> ifAllowed(c -> c.setJointColliding(joint, x > 0f));
                default -> both(c -> c.removeJoint(joint));
            }
        }
    }
}
