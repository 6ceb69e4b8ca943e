package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Joints of bodies that are pushed do what mechanics says. */
class JointsOfBodiesPhysicsTest {
    private static final float G = 10;
    private static final float DT = 1 / 60f;

    private static World world(float gravity) {
        return WorldScenes.jvm()
                .bounds(-100, -100, 100, 100)
                .gravity(0, gravity)
                .threads(1)
                .build();
    }

    private static void run(World world, int steps) {
        for (int k = 0; k < steps; k++) {
            world.step(DT);
        }
    }

    private static double kinetic(World world) {
        Bodies bodies = world.bodies();
        double sum = 0;
        for (int id = 0; id < bodies.idLimit(); id++) {
            long body = bodies.handle(id);
            double square = Math.pow(bodies.vx(body), 2) + Math.pow(bodies.vy(body), 2);
            sum += 0.5 * bodies.mass(body) * square;
            sum += 0.5 * bodies.inertia(body) * Math.pow(bodies.angularVelocity(body), 2);
        }
        return sum;
    }

    @Test
    void aBoxOnAHingeSwingsAsAPhysicalPendulum() {
        try (World world = world(-G)) {
            Bodies bodies = world.bodies();
            float l = 0.45f;
            double start = -Math.PI / 2 + 0.1;
            long box = bodies.add(
                    Outline.box(1, 0.4f),
                    (float) (l * Math.cos(start)),
                    (float) (l * Math.sin(start)),
                    (float) start,
                    2);
            world.joints().add(box, -l, 0, 0f, 0f, Joint.pin());
            double moment = bodies.inertia(box) + 2 * l * l;
            double period = 2 * Math.PI * Math.sqrt(moment / (2 * G * l)) * (1 + 0.1 * 0.1 / 16);
            double before = 0;
            double first = -1;
            double last = 0;
            int swings = 0;
            world.step(DT);
            double energy = kinetic(world) + 2 * G * (bodies.y(box) + l);
            for (int k = 1; k < 1200; k++) {
                world.step(DT);
                double x = bodies.x(box);
                if (before < 0 && x >= 0) {
                    double time = (k + 1 - x / (x - before)) * DT;
                    if (first < 0) {
                        first = time;
                    } else {
                        swings++;
                        last = time;
                    }
                }
                before = x;
            }
            assertThat(swings).isEqualTo(11);
            assertThat((last - first) / swings).isCloseTo(period, within(1e-3 * period));
            assertThat(kinetic(world) + 2 * G * (bodies.y(box) + l)).isCloseTo(energy, within(0.01 * energy));
            assertThat(Math.hypot(bodies.x(box), bodies.y(box))).isCloseTo(l, within(2e-4));
        }
    }

    @Test
    void aChainOfTenPlanksHangsAndRests() {
        try (World world = world(-G)) {
            world.kind(0).setDamping(2).setAngularDamping(2);
            long end = chain(world, (float) -Math.PI / 2);
            run(world, 1800);
            assertThat(kinetic(world)).isLessThan(1e-9);
            assertThat(world.bodies().y(end)).isCloseTo(-9.5f, within(0.02f));
        }
    }

    /** Ten planks of 1 m from the origin on; returns the last one. */
    private static long chain(World world, float angle) {
        long last = 0;
        for (int k = 0; k < 10; k++) {
            float way = 0.5f + k;
            float x = (float) Math.cos(angle) * way + 0.01f * (k % 3);
            long plank = world.bodies().add(Outline.box(1, 0.2f), x, (float) Math.sin(angle) * way, angle, 1);
            if (k == 0) {
                world.joints().add(plank, -0.5f, 0, 0f, 0f, Joint.pin());
            } else {
                world.joints().add(last, 0.5f, 0, plank, -0.5f, 0, Joint.pin());
            }
            last = plank;
        }
        return last;
    }

    @Test
    void aBridgeOfPlanksHoldsACrate() {
        try (World world = world(-G)) {
            world.kind(0).setDamping(2).setAngularDamping(2);
            long end = chain(world, 0);
            world.joints().add(end, 0.5f, 0, 9.8f, 0f, Joint.pin());
            world.kind(0).setFriction(0.5f);
            long crate = world.bodies().add(Outline.box(1, 1), 5, 1, 0, 5);
            run(world, 1800);
            assertThat(kinetic(world)).isLessThan(1e-6);
            assertThat(world.bodies().y(crate)).isBetween(-2.5f, 0.3f);
            assertThat(world.bodies().x(crate)).isBetween(3f, 7f);
        }
    }

    @Test
    void aMotorReachesItsSpeedByItsTorque() {
        try (World world = world(0)) {
            long bar = world.bodies().add(Outline.box(2, 0.2f), 0, 0, 0, 2);
            world.joints().add(bar, 0, 0, 0f, 0f, Joint.pin());
            world.joints().add(bar, Joint.motor(3, 1));
            run(world, 30);
            float half = 0.5f / world.bodies().inertia(bar);
            assertThat(world.bodies().angularVelocity(bar)).isCloseTo(half, within(1e-4f));
            run(world, 240);
            assertThat(world.bodies().angularVelocity(bar)).isCloseTo(3, within(1e-5f));
        }
    }

    @Test
    void aMotorHoldsAWeightUpToItsTorque() {
        for (float share : new float[] {0.98f, 1.02f}) {
            try (World world = world(-G)) {
                long bar = world.bodies().add(Outline.box(2, 0.2f), 1, 0, 0, 1);
                world.joints().add(bar, -1, 0, 0f, 0f, Joint.pin());
                long motor = world.joints().add(bar, Joint.motor(0, share * 10));
                run(world, 120);
                if (share > 1) {
                    assertThat(world.bodies().angle(bar)).isBetween(-0.01f, 0f);
                    assertThat(world.joints().torque(motor)).isCloseTo(10, within(0.01f));
                } else {
                    double moment = world.bodies().inertia(bar) + 1;
                    double turned = 0.5 * (0.02 * 10 / moment) * 2 * 2;
                    assertThat(-world.bodies().angle(bar)).isCloseTo((float) turned, within(0.01f));
                }
            }
        }
    }

    @Test
    void weldsHoldABeamOfCrates() {
        try (World world = world(-G)) {
            Outline crate = Outline.box(1, 1);
            long last = world.bodies().add(crate, 0, 0, 0, 1);
            world.joints().add(last, -0.5f, 0.5f, -0.5f, 0.5f, Joint.pin());
            world.joints().add(last, -0.5f, -0.5f, -0.5f, -0.5f, Joint.pin());
            for (int k = 1; k < 3; k++) {
                long next = world.bodies().add(crate, k, 0, 0, 1);
                world.joints().add(last, 0.5f, 0, next, -0.5f, 0, Joint.weld());
                last = next;
            }
            run(world, 600);
            assertThat(world.bodies().y(last)).isBetween(-0.03f, 0f);
            assertThat(kinetic(world)).isLessThan(1e-9);
        }
    }

    @Test
    void aJointedPairKeepsItsMomenta() {
        for (Joint joint : new Joint[] {Joint.pin(), Joint.distance(), Joint.weld(), Joint.spring(2, 0)}) {
            try (World world = world(0)) {
                Bodies bodies = world.bodies();
                long a = bodies.add(Outline.box(1, 0.5f), 0, 0, 0.3f, 1);
                long b = bodies.add(Outline.capsule(1, 0.2f), 1, 0.2f, -0.4f, 3);
                world.joints().add(a, 0.5f, 0.1f, b, -0.5f, 0, joint);
                bodies.setVelocity(a, 3, 1);
                bodies.setAngularVelocity(a, 5);
                bodies.setVelocity(b, -1, -1 / 3f);
                bodies.setAngularVelocity(b, -2);
                double[] before = momenta(world);
                run(world, 1200);
                double[] after = momenta(world);
                for (int k = 0; k < 3; k++) {
                    assertThat(after[k]).as(joint + ", " + k).isCloseTo(before[k], within(4e-5));
                }
            }
        }
    }

    private static double[] momenta(World world) {
        Bodies bodies = world.bodies();
        double[] sums = new double[3];
        for (int id = 0; id < bodies.idLimit(); id++) {
            long body = bodies.handle(id);
            double x = bodies.mass(body) * (double) bodies.vx(body);
            double y = bodies.mass(body) * (double) bodies.vy(body);
            sums[0] += x;
            sums[1] += y;
            sums[2] += bodies.x(body) * y - bodies.y(body) * x;
            sums[2] += bodies.inertia(body) * (double) bodies.angularVelocity(body);
        }
        return sums;
    }

    @Test
    void aRopeHoldsACrateByItsCorner() {
        try (World world = world(-G)) {
            world.kind(0).setDamping(2).setAngularDamping(2);
            long crate = world.bodies().add(Outline.box(1, 1), 0, 0, 0, 3);
            long rope = world.joints().add(crate, 0.5f, 0.5f, 0.5f, 3f, Joint.rope(2));
            run(world, 1800);
            assertThat(world.joints().length(rope)).isCloseTo(2, within(0.01f));
            assertThat(world.joints().force(rope))
                    .isCloseTo(30 * (1 - 2 * DT / 4), within(0.01f)); // gravity is damped, too
            assertThat(Math.abs(world.bodies().angle(crate))).isCloseTo((float) Math.PI / 4, within(1e-3f));
        }
    }

    @Test
    void aMouseLiftsByAtMostItsForce() {
        for (float most : new float[] {19, 1000}) {
            try (World world = world(-G)) {
                long crate = world.bodies().add(Outline.box(1, 1), 0, 0, 0, 2);
                long mouse = world.joints().add(crate, 0, 0.25f, 0f, 0.25f, Joint.mouse(5, 1, most));
                run(world, 60);
                float before = world.bodies().vy(crate);
                run(world, 60);
                if (most < 20) {
                    assertThat(world.bodies().vy(crate)).isCloseTo(before - 0.5f, within(0.001f));
                    assertThat(world.joints().force(mouse)).isCloseTo(most, within(0.01f));
                } else {
                    float sag = (float) (G / Math.pow(2 * Math.PI * 5, 2));
                    assertThat(world.joints().length(mouse)).isCloseTo(sag, within(0.01f * sag));
                    world.joints().setAnchor(mouse, 2, 1);
                    run(world, 240);
                    assertThat(world.bodies().x(crate)).isCloseTo(2, within(0.5f));
                }
            }
        }
    }

    @Test
    void aCartDrivesOnItsWheels() {
        try (World world = WorldScenes.jvm()
                .bounds(-100, 0, 100, 100)
                .gravity(0, -G)
                .friction(0.8f)
                .threads(1)
                .build()) {
            Joints joints = world.joints();
            long cart = world.bodies().add(Outline.box(3, 0.5f), 0, 1.2f, 0, 4);
            long rear = world.add(-1, 0.5f, 0.5f, 1);
            long front = world.add(1, 0.5f, 0.5f, 1);
            joints.add(cart, -1, -0.7f, rear, Joint.pin());
            joints.add(cart, 1, -0.7f, front, Joint.pin());
            joints.add(rear, cart, Joint.motor(-10, 5));
            run(world, 600);
            assertThat(world.bodies().vx(cart)).isCloseTo(5, within(0.01f));
            assertThat(world.bodies().y(cart)).isCloseTo(1.2f, within(0.002f));
            assertThat(world.bodies().angle(cart)).isCloseTo(0, within(0.01f));
        }
    }

    @Test
    void aHingeBreaksAtItsForce() {
        for (float most : new float[] {19.5f, 20.5f}) {
            try (World world = world(-G)) {
                world.joints().report(true);
                long crate = world.bodies().add(Outline.box(1, 1), 0, -0.5f, 0, 2);
                long hinge = world.joints()
                        .add(crate, 0, 0.5f, 0f, 0f, Joint.pin().breakingAt(most, Float.POSITIVE_INFINITY));
                run(world, 60);
                assertThat(world.joints().contains(hinge)).isEqualTo(most > 20);
                JointEvents events = world.joints().events();
                assertThat(events.size()).isEqualTo(most > 20 ? 0 : 1);
                if (most < 20) {
                    assertThat(events.joint(0)).isEqualTo(hinge);
                    assertThat(events.circle(0)).isEqualTo(crate);
                    assertThat(events.other(0)).isZero();
                    assertThat(events.force(0)).isGreaterThan(most);
                    assertThat(events.reason(0)).isEqualTo(JointEvents.Reason.BROKEN);
                    assertThat(world.bodies().vy(crate)).isLessThan(-9);
                }
            }
        }
    }

    @Test
    void aHingeFollowsABodyOfTerrain() {
        try (World world = world(-G)) {
            TerrainBody lift = world.terrain().addBody(0, 0, 0);
            long crate = world.bodies().add(Outline.box(1, 1), 0, -0.5f, 0, 2);
            long hinge = world.joints().add(crate, 0, 0.5f, lift, 0, 0, Joint.pin());
            lift.setVelocity(0, 2);
            run(world, 120);
            assertThat(world.bodies().y(crate)).isCloseTo(3.5f, within(0.005f));
            assertThat(world.joints().anchorY(hinge)).isCloseTo(4, within(1e-4f));
        }
    }

    @Test
    void whatAHingeHoldsDoesNotCollideUnlessItIsSaid() {
        for (boolean collides : new boolean[] {false, true}) {
            try (World world = world(0)) {
                Outline crate = Outline.box(1, 1);
                long a = world.bodies().add(crate, 0, 0, 0, 1);
                long b = world.bodies().add(crate, 0.6f, 0, 0, 1);
                long ball = world.add(0, 0.4f, 0.3f, 1);
                world.joints().add(a, 0, 0, b, 0, 0, Joint.rope(50).colliding(collides));
                world.joints().add(a, 0, 0, ball, Joint.rope(50).colliding(collides));
                run(world, 60);
                assertThat(world.bodies().x(b) > 0.7f).isEqualTo(collides);
                assertThat(world.y(ball) > 0.5f).isEqualTo(collides);
            }
        }
    }

    @Test
    void aSeeSawTurnsOnItsHinge() {
        try (World world = world(-G)) {
            long plank = world.bodies().add(Outline.box(4, 0.2f), 0, 0, 0, 2);
            world.joints().add(plank, 0, 0, 0f, 0f, Joint.pin());
            long left = world.bodies().add(Outline.box(0.5f, 0.5f), -1.5f, 0.35f, 0, 1);
            long right = world.bodies().add(Outline.box(0.5f, 0.5f), 1.5f, 0.35f, 0, 1);
            run(world, 120);
            assertThat(world.bodies().angle(plank)).isCloseTo(0, within(0.02f));
            world.bodies().remove(right);
            run(world, 20);
            assertThat(world.bodies().angle(plank)).isGreaterThan(0.1f);
            assertThat(world.bodies().y(left)).isLessThan(0.3f);
        }
    }
}
