package io.github.circles2d;

import static io.github.circles2d.TerrainBall.G;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What joints cannot satisfy, they bear: circles stay finite, steps end, and the force is told. */
class WorldJointExtremesTest {
    /** Faster than what falls for the whole time, by far, and slower than what bursts. */
    private static final double CALM = 5e3;

    /** Makes steps; all circles and joints are finite after each. Returns the greatest speed. */
    private static double greatestSpeed(JointScene scene, int steps) {
        float[] circles = new float[4 * scene.world.size()];
        float[] velocities = new float[2 * scene.world.size()];
        double greatest = 0;
        for (int step = 0; step < steps; step++) {
            scene.step(1);
            scene.world.read(circles);
            scene.world.readVelocities(velocities);
            for (float value : circles) {
                assertThat(value).isFinite();
            }
            for (int k = 0; k < velocities.length; k += 2) {
                greatest = Math.max(greatest, Math.hypot(velocities[k], velocities[k + 1]));
            }
            assertThat(greatest).as("speed after step %d", step).isFinite();
        }
        Joints joints = scene.world.joints();
        for (int id = 0; id < joints.idLimit(); id++) {
            assertThat(joints.force(joints.handle(id)))
                    .as("force of joint %d", id)
                    .isFinite();
            assertThat(joints.torque(joints.handle(id)))
                    .as("torque of joint %d", id)
                    .isFinite();
        }
        return greatest;
    }

    @ParameterizedTest
    @ValueSource(floats = {0.1f, 1, 10, 1e4f, 1e9f})
    void aTriangleWithSidesThatDoNotFitPullsItsShortOnesApart(float size) {
        try (JointScene scene = new JointScene(0)) {
            long a = scene.alone(0, 0, 0.1, 1);
            long b = scene.alone(0.5 * Math.min(size, 1e3), 0.1, 0.1, 1);
            long c = scene.alone(Math.min(size, 1e3), 0, 0.1, 1);
            long first = scene.hold(a, b, Joint.distance(size));
            long second = scene.hold(b, c, Joint.distance(size));
            long wide = scene.hold(a, c, Joint.distance(5 * Math.min(size, 2e8f)));
            greatestSpeed(scene, 600);
            if (size < 1e4f) {
                assertThat(scene.world.joints().force(first)).isGreaterThan(size);
                assertThat(scene.world.joints().force(second)).isGreaterThan(size);
                assertThat(scene.world.joints().force(wide)).isLessThan(-size);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({
        "1e-9, 1e4",
        "1e-3, 1e4",
        "1, 1e4",
        "1e3, 1e4",
        "1e9, 1e4",
        "1e-9, 100",
        "1e-3, 100",
        "1, 100",
        "1e3, 100",
        "1e9, 100",
        "1e-9, 30",
        "1, 30",
        "1e3, 30"
    })
    void springsOfAnyStiffnessBetweenAnyMassesDoNotBurst(float mass, float hertz) {
        for (float ratio : new float[] {0, 0.7f, 2, 1000}) {
            try (JointScene scene = new JointScene(G)) {
                long before = scene.alone(0, 0, 0.3, 1);
                scene.hold(before, 0, 0, Joint.pin(hertz, ratio));
                for (int k = 1; k < 20; k++) {
                    long ball = scene.alone(k, 0, 0.3, k % 2 == 0 ? 1 : mass);
                    scene.hold(before, ball, Joint.spring(hertz, ratio));
                    before = ball;
                }
                assertThat(greatestSpeed(scene, 300)).isLessThan(CALM);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"20, 0", "20, 0.7", "30, 0", "100, 0", "100, 0.7", "1e4, 0", "1e4, 0.7"})
    @Tag("long")
    void latticesOfSpringsDoNotBurst(float hertz, float ratio) {
        for (float mass : new float[] {1, 10, 1000}) {
            try (JointScene scene = new JointScene(0)) {
                lattice(scene, 4, mass, Joint.spring(hertz, ratio));
                assertThat(greatestSpeed(scene, 1200)).isLessThan(100);
            }
        }
    }

    /** A square of circles, each joined with its eight neighbours, which start at different speeds. */
    private static void lattice(JointScene scene, int side, float mass, Joint joint) {
        long[] balls = new long[side * side];
        for (int k = 0; k < balls.length; k++) {
            balls[k] = scene.alone(k % side, k / side, 0.1, k % 2 == 0 ? 1 : mass);
            scene.world.setVelocity(balls[k], 0.1f * (k % 3), 0.1f * (k % 5));
        }
        for (int k = 0; k < balls.length; k++) {
            for (int to = k + 1; to < balls.length; to++) {
                if (Math.abs(to % side - k % side) <= 1 && to / side - k / side <= 1) {
                    scene.hold(balls[k], balls[to], joint);
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {1e-9f, 1e-3f, 1, 1e3f, 1e9f})
    void chainsAndWeldsOfAnyMassesDoNotBurst(float mass) {
        for (Joint joint : new Joint[] {Joint.distance(), Joint.weld(), Joint.rope(1.2f), Joint.limits(0.9f, 1.1f)}) {
            try (JointScene scene = new JointScene(G)) {
                long before = scene.alone(0, 0, 0.4, 1);
                scene.hold(before, 0, 0, Joint.pin());
                for (int k = 1; k < 20; k++) {
                    long ball = scene.alone(k, 0, 0.4, k % 2 == 0 ? 1 : mass);
                    scene.hold(before, ball, joint);
                    before = ball;
                }
                assertThat(greatestSpeed(scene, 300)).isLessThan(mass == 1e-9f || mass == 1e9f ? 1e5 : CALM);
            }
        }
    }

    /** A hub of more joints than colours, and its spokes a chain, all at one point. */
    @ParameterizedTest
    @ValueSource(floats = {0, 1, 1e3f, 1e9f})
    void circlesInOnePointStayFinite(float length) {
        for (Joint joint : new Joint[] {
            Joint.distance(length), Joint.weld(), Joint.spring(10, 1).withLength(length), Joint.limits(length, length)
        }) {
            try (JointScene scene = new JointScene(G)) {
                long[] balls = new long[60];
                for (int k = 0; k < balls.length; k++) {
                    balls[k] = scene.ball(1, 1, 0.3, 1);
                    if (k > 0) {
                        scene.hold(balls[k - 1], balls[k], joint);
                    }
                }
                for (int k = 2; k < balls.length; k++) {
                    scene.hold(balls[0], balls[k], joint);
                }
                greatestSpeed(scene, 120);
            }
        }
    }

    /** A chain, closed or not, of thousands of links; it is as long as before, but for what its weight gives. */
    @ParameterizedTest
    @CsvSource({"4000, false", "4000, true"})
    void chainsAndLoopsOfThousandsHold(int links, boolean closed) {
        try (JointScene scene = new JointScene(0)) {
            long[] balls = new long[links];
            double radius = 0.2 * links / (2 * Math.PI);
            for (int k = 0; k < links; k++) {
                double a = 2 * Math.PI * k / links;
                double x = closed ? radius * Math.cos(a) : 0.2 * k;
                balls[k] = scene.alone(x, closed ? radius * Math.sin(a) : 0, 0.08, 1);
                if (k > 0) {
                    scene.hold(balls[k - 1], balls[k], Joint.distance());
                }
            }
            if (closed) {
                scene.hold(balls[links - 1], balls[0], Joint.distance());
            }
            scene.world.setVelocity(balls[0], 0, 20);
            assertThat(greatestSpeed(scene, 120)).isLessThan(21);
            for (int k = 1; k < links; k++) {
                assertThat(scene.distance(balls[k], balls[k - 1])).isBetween(0.15, 0.25);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {1e3f, 1e6f, 1e9f})
    void anchorsThatJumpFarAreFollowed(float far) {
        for (Joint joint : new Joint[] {Joint.pin(), Joint.mouse(1e4f, 1, 1e18f), Joint.distance(1), Joint.rope(1)}) {
            try (JointScene scene = new JointScene(G)) {
                long ball = scene.ball(0, 0, 0.5, 1);
                long held = scene.hold(ball, 0, 0, joint);
                scene.world.joints().setAnchor(held, far, 0);
                greatestSpeed(scene, 600);
                scene.world.joints().setAnchor(held, -far, far);
                greatestSpeed(scene, 600);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {20, 1e3f, 1e6f, 1e9f})
    void motorsOfAnySpeedTurnWelds(float speed) {
        try (JointScene scene = new JointScene(G)) {
            long a = scene.ball(0, 0, 0.5, 1);
            long b = scene.ball(2, 0, 0.5, 1);
            scene.hold(a, b, Joint.weld());
            scene.world.joints().add(a, Joint.motor(speed, Float.POSITIVE_INFINITY));
            scene.world.joints().add(b, Joint.motor(-speed, Float.POSITIVE_INFINITY));
            scene.world.joints().add(b, Joint.servo(3, 1e4f, 0, Float.POSITIVE_INFINITY));
            greatestSpeed(scene, 300);
        }
    }

    /** Pins pull elastic balls at walls and at other balls with all their might; nothing is shot away. */
    @Test
    void elasticBallsThatPinsCannotBringToTheirPlacesStayCalm() {
        try (World world = WorldScenes.jvm().bounds(0, 0, 10, 10).restitution(1).build()) {
            for (int k = 0; k < 100; k++) {
                long ball = world.add(0.5f + k % 10, 0.5f + k / 10, 0.45f, 1, 0.1f * (k % 3), 0.1f * (k % 5));
                if (k % 10 == 9) {
                    world.joints().add(ball, 12, 0.5f + k / 10, k % 20 == 9 ? Joint.pin() : Joint.rope(0.5f));
                }
            }
            float[] velocities = new float[200];
            for (int step = 0; step < 600; step++) {
                world.step(1 / 60f);
                world.readVelocities(velocities);
                for (float v : velocities) {
                    assertThat(v).isBetween(-60f, 60f);
                }
            }
        }
    }

    /** What holds a weight breaks as soon as it is asked to hold more, and not before. */
    @Test
    void aJointBreaksByTheForceThatItTells() {
        try (JointScene scene = new JointScene(G)) {
            long ball = scene.ball(0, -1, 0.1, 3);
            long rope = scene.hold(ball, 0, 0, Joint.distance(1).breakingAt(31, Float.POSITIVE_INFINITY));
            scene.world.joints().report(true);
            scene.step(120);
            assertThat(scene.world.joints().force(rope)).isBetween(29.9f, 30.1f);
            scene.world.setForce(ball, 0, -2);
            scene.step(120);
            assertThat(scene.world.joints().contains(rope)).isFalse();
            JointEvents events = scene.world.joints().events();
            assertThat(events.size()).isEqualTo(1);
            assertThat(events.joint(0)).isEqualTo(rope);
            assertThat(events.force(0)).isBetween(31f, 33f);
            assertThat(scene.vy(ball)).isLessThan(-5);
        }
    }

    /** Joints of all kinds between circles of all sizes and masses. */
    @Test
    void anythingGoes() {
        SplittableRandom random = new SplittableRandom(1);
        for (int scenes = 0; scenes < 30; scenes++) {
            try (JointScene scene = new JointScene(G)) {
                long[] balls = new long[20];
                for (int k = 0; k < balls.length; k++) {
                    double mass = Math.pow(10, random.nextInt(19) - 9);
                    balls[k] =
                            scene.ball(random.nextDouble(4), random.nextDouble(4), 0.01 + random.nextDouble(0.5), mass);
                }
                for (int k = 0; k < 60; k++) {
                    long a = balls[random.nextInt(balls.length)];
                    long b = balls[random.nextInt(balls.length)];
                    if (a != b) {
                        join(scene, a, b, random);
                    }
                }
                greatestSpeed(scene, 120);
            }
        }
    }

    private static void join(JointScene scene, long a, long b, SplittableRandom random) {
        float hertz = (float) Math.pow(10, random.nextInt(6) - 1);
        float most = (float) Math.pow(10, random.nextInt(12) - 3);
        switch (random.nextInt(7)) {
            case 0 -> scene.hold(a, b, Joint.distance((float) Math.pow(10, random.nextInt(9) - 4)));
            case 1 -> scene.hold(a, b, Joint.weld());
            case 2 -> scene.hold(a, b, Joint.spring(hertz, random.nextInt(3)));
            case 3 -> scene.hold(a, b, Joint.servo(random.nextInt(7), hertz, random.nextInt(3), most));
            case 4 -> scene.hold(a, b, Joint.motor(hertz, most));
            case 5 -> scene.hold(a, 1, 1, Joint.mouse(hertz, random.nextInt(3), most));
            default -> scene.hold(a, b, Joint.limits(0.5f, 1));
        }
    }
}
