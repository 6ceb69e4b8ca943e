package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.AffineTransform;
import java.awt.geom.Area;
import java.awt.geom.Path2D;
import java.nio.ByteBuffer;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Scenes of bodies that are pushed, beside their exact values: boxes of 1 m and density 1, gravity 10, steps of 1/60 s, unless a scene says otherwise. */
class BodiesPhysicsTest {
    private static final float ROUNDING = 0.05f;
    private static final float PI = (float) Math.PI;

    private static World world(double friction, double restitution, double gravity) {
        return WorldScenes.jvm()
                .bounds(-400, -400, 400, 400)
                .gravity(0, (float) -gravity)
                .friction((float) friction)
                .restitution((float) restitution)
                .threads(1)
                .build();
    }

    private static World onFloor(double friction, double restitution) {
        World world = world(friction, restitution, 10);
        world.terrain().addChain(Chain.of(200, 0, -200, 0));
        return world;
    }

    /** Half extents. */
    private static long box(
            World world, double x, double y, double angle, double halfX, double halfY, double rounding) {
        Outline outline = Outline.box((float) (2 * halfX), (float) (2 * halfY)).round((float) rounding);
        return world.bodies().add(outline, (float) x, (float) y, (float) angle, outline.area());
    }

    private static long crate(World world, double x, double y) {
        return box(world, x, y, 0, 0.5, 0.5, ROUNDING);
    }

    private static void wall(World world, double x, double y, double halfX, double halfY) {
        float left = (float) (x - halfX);
        float right = (float) (x + halfX);
        float low = (float) (y - halfY);
        float high = (float) (y + halfY);
        world.terrain()
                .addChain(
                        Chain.of(left, low, right, low, right, high, left, high).close());
    }

    private static long circle(World world, double x, double y, double r, double density) {
        return world.add((float) x, (float) y, (float) r, (float) (density * Math.PI * r * r));
    }

    private static void run(World world, int steps) {
        for (int k = 0; k < steps; k++) {
            world.step(1 / 60f);
        }
    }

    private static double kinetic(World world, long body) {
        Bodies b = world.bodies();
        double v2 = (double) b.vx(body) * b.vx(body) + (double) b.vy(body) * b.vy(body);
        return (b.mass(body) * v2 + (double) b.inertia(body) * b.angularVelocity(body) * b.angularVelocity(body)) / 2;
    }

    private static double kinetic(World world) {
        double sum = 0;
        for (int id = 0; id < world.bodies().idLimit(); id++) {
            sum += kinetic(world, world.bodies().handle(id));
        }
        return sum;
    }

    private static double energy(World world, long body) {
        return kinetic(world, body)
                + world.bodies().mass(body) * 10 * world.bodies().y(body);
    }

    // ---- piles

    @Test
    void aStackOfTenStands() {
        try (World world = onFloor(0.6, 0)) {
            long[] crates = new long[10];
            for (int k = 0; k < crates.length; k++) {
                crates[k] = crate(world, 0, 0.5 + k);
            }
            run(world, 3600);
            assertThat(9.5 - world.bodies().y(crates[9])).isBetween(0.0, 0.01);
            for (long each : crates) {
                assertThat(world.bodies().x(each)).isCloseTo(0, within(0.005f));
            }
            assertThat(kinetic(world)).isLessThan(1e-9);
        }
    }

    @Test
    void bodiesThatStartInsideEachOtherComeApart() {
        for (double depth : new double[] {0.2, 0.6, 0.95}) {
            try (World world = onFloor(0.6, 0)) {
                long a = crate(world, 0, 0.5);
                long b = crate(world, 0.13, 1.5 - depth);
                run(world, 600);
                double dx = Math.abs(world.bodies().x(a) - world.bodies().x(b));
                double dy = Math.abs(world.bodies().y(a) - world.bodies().y(b));
                assertThat(Math.max(dx, dy)).isCloseTo(1, within(0.01));
            }
        }
    }

    /** Like an X, of which no corner is inside the other body; at a small angle also each rests with an end on the other. */
    @Test
    void bodiesThatCrossComeApart() {
        for (double angle : new double[] {0.3, 0.8, 1.5, 2.6}) {
            for (double off : new double[] {0, 1.2, 4}) {
                try (World world = world(0.6, 0, 10)) {
                    wall(world, 0, -1, 100, 1);
                    long a = box(world, 0, 6, 0, 5, 0.5, ROUNDING);
                    long b = box(world, off, 6, angle, 5, 0.5, ROUNDING);
                    double fastest = 0;
                    for (int k = 0; k < 600; k++) {
                        world.step(1 / 60f);
                        fastest = Math.max(fastest, Math.max(speed(world, a), speed(world, b)));
                    }
                    Area both = area(world, a);
                    both.intersect(area(world, b));
                    assertThat(both.getBounds2D().getWidth()
                                    * both.getBounds2D().getHeight())
                            .as("overlap by %s and %s", angle, off)
                            .isLessThan(0.02);
                    assertThat(fastest).as("by %s and %s", angle, off).isLessThan(15);
                }
            }
        }
    }

    private static double speed(World world, long body) {
        return Math.hypot(world.bodies().vx(body), world.bodies().vy(body));
    }

    /** What a body covers. */
    private static Area area(World world, long body) {
        float[] points = world.bodies().outline(body).points(1e-3f);
        Path2D path = new Path2D.Double();
        path.moveTo(points[0], points[1]);
        for (int k = 2; k < points.length; k += 2) {
            path.lineTo(points[k], points[k + 1]);
        }
        path.closePath();
        AffineTransform place = AffineTransform.getTranslateInstance(
                world.bodies().x(body), world.bodies().y(body));
        place.rotate(world.bodies().angle(body));
        return new Area(place.createTransformedShape(path));
    }

    // ---- arcs that meet other pieces at an angle

    private static Outline halfDisc() {
        return Outline.of(Chain.from(0.6f, 0).arcTo(0, 0, PI).close());
    }

    /** Two arcs between points 1.2 apart, each of twice an angle. */
    private static Outline lens(double half) {
        float high = (float) (0.6 / Math.tan(half));
        return Outline.of(Chain.from(0.6f, 0)
                .arcTo(0, -high, (float) (2 * half))
                .arcTo(0, high, (float) (2 * half))
                .close());
    }

    /** The lowest point of a body. */
    private static double low(World world, long body) {
        double cos = Math.cos(world.bodies().angle(body));
        double sin = Math.sin(world.bodies().angle(body));
        float[] points = world.bodies().outline(body).points(1e-4f);
        double low = Double.POSITIVE_INFINITY;
        for (int k = 0; k < points.length; k += 2) {
            low = Math.min(low, sin * points[k] + cos * points[k + 1]);
        }
        return world.bodies().y(body) + low;
    }

    /** So high over the floor. */
    private static long drop(World world, Outline outline, double angle, double height) {
        long b = world.bodies().add(outline, 0, 5, (float) angle, outline.area());
        world.bodies().teleport(b, 0, (float) (5 - low(world, b) + height), (float) angle);
        return b;
    }

    @Test
    void halfDiscsAndLensesRestAndRockWithoutSinking() {
        for (Outline outline : new Outline[] {halfDisc(), lens(0.5), lens(1)}) {
            for (int k = 0; k < 9; k++) {
                try (World world = onFloor(0.6, 0)) {
                    long b = drop(world, outline, k * PI / 8, 0.3);
                    double least = energy(world, b);
                    for (int step = 0; step < 600; step += 3) {
                        run(world, 3);
                        assertThat(low(world, b)).isGreaterThan(-0.012);
                        // a fall is off by a fiftieth of a length, as steps are
                        assertThat(energy(world, b)).isLessThan(least + 0.02 * 10 * outline.area());
                        least = Math.min(least, energy(world, b));
                    }
                    boolean rests = k % 8 == 0 || k < 3 && outline.equals(halfDisc());
                    assertThat(!rests || kinetic(world) < 1e-9).isTrue();
                }
            }
        }
    }

    @Test
    void stackedHalfDiscsAndLensesStandOrFall() {
        for (Outline outline : new Outline[] {halfDisc(), lens(0.5), lens(1)}) {
            try (World world = onFloor(0.6, 0)) {
                for (int k = 0; k < 3; k++) {
                    long b = drop(world, outline, 0, 0);
                    float[] points = outline.points(1e-4f);
                    float low = 0;
                    float high = 0;
                    for (int p = 1; p < points.length; p += 2) {
                        low = Math.min(low, points[p]);
                        high = Math.max(high, points[p]);
                    }
                    world.bodies().teleport(b, 0.003f * k, world.bodies().y(b) + k * (high - low), 0);
                }
                double before = energy(world);
                for (int step = 0; step < 1200; step++) {
                    run(world, 1);
                    assertThat(energy(world)).isLessThan(1.01 * before);
                }
                for (int id = 0; id < 3; id++) {
                    assertThat(low(world, world.bodies().handle(id))).isGreaterThan(-0.012);
                }
            }
        }
    }

    private static double energy(World world) {
        double sum = 0;
        for (int id = 0; id < world.bodies().idLimit(); id++) {
            sum += energy(world, world.bodies().handle(id));
        }
        return sum;
    }

    @Test
    void elasticHalfDiscsAndLensesKeepTheirEnergy() {
        for (int k = 0; k < 16; k++) {
            assertThat(energyKept(lens(1), 0.39 * k)).isCloseTo(1, within(0.02));
            // two corners that hit one after the other within a sub-step lose some
            assertThat(energyKept(halfDisc(), 0.39 * k)).isLessThan(1.02);
        }
        for (double angle : new double[] {0, 0.4, 1, 2, 3}) {
            assertThat(energyKept(halfDisc(), angle)).isCloseTo(1, within(0.02));
        }
        assertThat(energyKept(Outline.box(2, 0.4f), 0)).isCloseTo(1, within(0.02));
    }

    @Test
    void aBoxThatMeetsAnotherKeepsItsShareOfTheSpeed() {
        for (double e : new double[] {0, 0.5, 1}) {
            try (World world = world(0, e, 0)) {
                long a = crate(world, -2, 0);
                long b = crate(world, 0, 0);
                world.bodies().setVelocity(a, 2, 0);
                run(world, 120);
                assertThat(world.bodies().vx(a)).isCloseTo((float) (1 - e), within(1e-5f));
                assertThat(world.bodies().vx(b)).isCloseTo((float) (1 + e), within(1e-5f));
            }
        }
    }

    /** Of an elastic body that falls for 1 m, after 20 s. */
    private static double energyKept(Outline outline, double angle) {
        try (World world = onFloor(0, 1)) {
            long b = drop(world, outline, angle, 1);
            double before = energy(world, b);
            run(world, 1200);
            return energy(world, b) / before;
        }
    }

    // ---- friction

    private static Outline disc() {
        return Outline.of(Chain.from(0.5f, 0).arcTo(0, 0, 2 * PI).close());
    }

    @Test
    void beltsCarryBodies() {
        try (World world = world(0.6, 0, 10)) {
            world.kind(3).setBeltSpeed(2);
            world.terrain().addChain(Chain.of(200, 0, -200, 0), 3, null);
            long b = crate(world, 0, 0.5);
            run(world, 240);
            assertThat(world.bodies().vx(b)).isCloseTo(2, within(0.01f));
        }
    }

    // ---- bounces

    @Test
    void aCircleThatHitsAFreeBoxTurnsIt() {
        for (int e = 0; e <= 1; e++) {
            try (World world = world(0, e, 0)) {
                long b = box(world, 0, 0, 0, 1, 0.5, ROUNDING);
                long c = circle(world, 0.7, 3, 0.3, 2);
                world.setVelocity(c, 0, -4);
                for (int k = 0; k < 120 && world.vy(c) < -3.9; k++) {
                    run(world, 1);
                }
                double mass = world.bodies().mass(b);
                double inertia = world.bodies().inertia(b);
                double j = (1 + e) * 4 / (1 / mass + 1.0 / world.mass(c) + 0.49 / inertia);
                assertThat(world.bodies().angularVelocity(b)).isCloseTo((float) (-0.7 * j / inertia), within(1e-4f));
                assertThat(world.bodies().vy(b)).isCloseTo((float) (-j / mass), within(1e-4f));
                assertThat(world.vy(c)).isCloseTo((float) (-4 + j / world.mass(c)), within(1e-4f));
            }
        }
    }

    @Test
    void collisionsKeepMomenta() {
        try (World world = world(0.5, 0.5, 0)) {
            long b = box(world, 0, 0, 0.3, 1, 0.5, ROUNDING);
            world.bodies().setVelocity(b, 0.1f, 0);
            world.bodies().setAngularVelocity(b, 3);
            long other = box(world, 2, -3, 0.1, 0.5, 0.5, ROUNDING);
            world.bodies().setVelocity(other, -1, 2);
            long c = circle(world, 0.7, 3, 0.3, 2);
            world.setVelocity(c, 0, -4);
            world.setAngularVelocity(c, 1);
            double[] before = momenta(world);
            for (int k = 0; k < 240; k++) {
                run(world, 1);
                double[] now = momenta(world);
                for (int m = 0; m < 3; m++) {
                    assertThat(now[m]).isCloseTo(before[m], within(5e-6));
                }
            }
            assertThat(world.bodies().angularVelocity(b)).isNotCloseTo(3, within(0.1f));
            assertThat(world.bodies().angularVelocity(other)).isNotCloseTo(0, within(0.1f));
        }
    }

    /** Along x and y, and angular about the origin. */
    private static double[] momenta(World world) {
        double[] sum = new double[3];
        for (int id = 0; id < world.bodies().idLimit(); id++) {
            long b = world.bodies().handle(id);
            Bodies bodies = world.bodies();
            add(sum, bodies.mass(b), bodies.x(b), bodies.y(b), bodies.vx(b), bodies.vy(b));
            sum[2] += (double) bodies.inertia(b) * bodies.angularVelocity(b);
        }
        for (int id = 0; id < world.idLimit(); id++) {
            long c = world.handle(id);
            add(sum, world.mass(c), world.x(c), world.y(c), world.vx(c), world.vy(c));
            sum[2] += 0.5 * world.mass(c) * world.radius(c) * world.radius(c) * world.angularVelocity(c);
        }
        return sum;
    }

    private static void add(double[] sum, double m, double x, double y, double vx, double vy) {
        sum[0] += m * vx;
        sum[1] += m * vy;
        sum[2] += m * (x * vy - y * vx);
    }

    // ---- games

    @Test
    void aConcaveBodyHangsOnAPeg() {
        try (World world = world(0.6, 0, 10)) {
            wall(world, 0, 5, 0.2, 0.2);
            Outline hook = Outline.polygon(0, 0, 1, 0, 1, 0.25f, 0.25f, 0.25f, 0.25f, 2, 0, 2)
                    .round(0.03f);
            long b = world.bodies().add(hook, 0.45f - hook.centroidX(), 5.6f - hook.centroidY(), PI, hook.area());
            run(world, 900);
            assertThat(world.bodies().y(b)).isCloseTo(4.69f, within(0.02f));
            assertThat(kinetic(world)).isLessThan(1e-9);
        }
    }

    /** A polygon whose lines are so far outside those of another, which goes anticlockwise. */
    static float[] grown(float[] points, double by) {
        int n = points.length;
        float[] to = new float[n];
        for (int k = 0; k < n; k += 2) {
            int before = (k + n - 2) % n;
            int next = (k + 2) % n;
            double ax = points[k] - points[before];
            double ay = points[k + 1] - points[before + 1];
            double bx = points[next] - points[k];
            double by2 = points[next + 1] - points[k + 1];
            double a = Math.hypot(ax, ay);
            double b = Math.hypot(bx, by2);
            double nx = ay / a + by2 / b;
            double ny = -ax / a - bx / b;
            double share = by / (1 + (ax * bx + ay * by2) / (a * b));
            to[k] = (float) (points[k] + share * nx);
            to[k + 1] = (float) (points[k + 1] + share * ny);
        }
        return to;
    }

    /** Planks and boxes that turn fly at thin ground at all angles. */
    @Test
    void nothingPassesThinGround() {
        Random random = new Random(77);
        Outline[] outlines = {
            Outline.box(0.1f, 2).round(0.02f),
            Outline.box(1, 1).round(ROUNDING),
            Outline.box(0.1f, 0.4f).round(0.01f)
        };
        for (int shot = 0; shot < 240; shot++) {
            try (World world = world(0, shot % 4 < 2 ? 0 : 0.5, 0)) {
                if (shot % 2 == 0) {
                    world.terrain().addChain(Chain.of(40, 0, -40, 0));
                } else {
                    world.terrain().addSegment(-40, 0, 40, 0);
                }
                double v = new double[] {20, 50, 100, 200}[shot % 8 / 2];
                double angle = (random.nextDouble() - 0.5) * 2.4;
                Outline outline = outlines[shot % 3];
                long b = world.bodies()
                        .add(
                                outline,
                                (float) (-3 * Math.tan(angle)),
                                3 + random.nextFloat(),
                                7 * random.nextFloat(),
                                outline.area());
                world.bodies().setVelocity(b, (float) (v * Math.sin(angle)), (float) (-v * Math.cos(angle)));
                world.bodies().setAngularVelocity(b, 20 * random.nextFloat() - 10);
                for (int k = 0; k < 12; k++) {
                    run(world, 1);
                    assertThat(world.bodies().y(b)).isGreaterThan(0);
                }
            }
        }
    }

    /** A heavy plank, 0.1 thick, stops circles of 0.1 and boxes of 0.2. */
    @Test
    void nothingPassesAThinPlank() {
        Random random = new Random(78);
        Outline plank = Outline.box(10, 0.1f).round(0.02f);
        Outline small = Outline.box(0.2f, 0.2f).round(0.02f);
        for (int shot = 0; shot < 200; shot++) {
            try (World world = world(0, shot % 4 < 2 ? 0 : 0.5, 0)) {
                world.bodies().add(plank, 0, 0, 0, 1e6f);
                double v = new double[] {20, 50, 100}[shot % 3];
                double angle = (random.nextDouble() - 0.5) * 1.2;
                float x = (float) (-3 * Math.tan(angle) + (random.nextDouble() - 0.5) * 4);
                float vx = (float) (v * Math.sin(angle));
                float vy = (float) (-v * Math.cos(angle));
                float y;
                int steps = (int) Math.ceil(3.5 / v * 60) + 1;
                if (shot % 2 == 0) {
                    long c = world.add(x, 3, 0.1f, 1);
                    world.setVelocity(c, vx, vy);
                    run(world, steps);
                    y = world.y(c);
                } else {
                    long b = world.bodies().add(small, x, 3, 6 * random.nextFloat(), 1);
                    world.bodies().setVelocity(b, vx, vy);
                    world.bodies().setAngularVelocity(b, 20 * random.nextFloat() - 10);
                    run(world, steps);
                    y = world.bodies().y(b);
                }
                assertThat(y).isGreaterThan(0);
            }
        }
    }

    // ---- terrain and walls

    @Test
    void bodiesRestOnWallsAndFollowThem() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 20, 20)
                .gravity(0, -10)
                .friction(0.6f)
                .build()) {
            long b = crate(world, 5, 0.5);
            run(world, 60);
            assertThat(world.bodies().y(b)).isCloseTo(0.5f, within(0.001f));
            for (int k = 1; k <= 60; k++) {
                world.setBounds(0, k / 60f, 20, 20);
                run(world, 1);
            }
            run(world, 60);
            assertThat(world.bodies().y(b)).isCloseTo(1.5f, within(0.001f));
        }
    }

    @Test
    void aLiftCarriesABody() {
        try (World world = world(0.6, 0, 10)) {
            TerrainBody lift = world.terrain().addBody(0, 0, 0);
            lift.addSegment(-3, 0, 3, 0);
            long b = crate(world, 0, 0.5);
            run(world, 30);
            lift.setVelocity(1, 2);
            run(world, 60);
            lift.setVelocity(0, 0);
            run(world, 60);
            assertThat(world.bodies().y(b)).isCloseTo(2.5f, within(0.01f));
            assertThat(world.bodies().x(b)).isCloseTo(1.4f, within(0.05f)); // it flies for 0.4 s after the lift stops
        }
    }

    @Test
    void staticCirclesHoldABody() {
        try (World world = world(1, 0, 10)) {
            long left = world.add(-0.4f, 0, 0.3f, Float.POSITIVE_INFINITY);
            world.add(0.4f, 0, 0.3f, Float.POSITIVE_INFINITY);
            long b = crate(world, 0, 0.81);
            run(world, 120);
            assertThat(world.bodies().y(b)).isCloseTo(0.8f, within(0.002f));
            assertThat(kinetic(world)).isLessThan(1e-9);
            world.setVelocity(left, 0, 1);
            run(world, 10);
            assertThat(world.bodies().angle(b)).isLessThan(-0.1f);
        }
    }

    /** The end is at the origin. */
    @Test
    void discsDoNotSinkIntoEndsOfSegments() {
        float[][] scenes = {
            {0, -3, 0, 0},
            {-5, 0, 0, 0},
            {-5, 0, 0, 0, 0, 0, 5, 0},
            {-5, -1, 0, 0, 0, 0, 5, -1},
            {-5, -1, 0, 0, 5, -1, 0, 0}
        };
        for (float[] segments : scenes) {
            for (float x : new float[] {0, 1e-5f, 5e-4f, 0.1f, 0.3f}) {
                try (World world = world(0.6, 0, 10)) {
                    for (int k = 0; k < segments.length; k += 4) {
                        world.terrain().addSegment(segments[k], segments[k + 1], segments[k + 2], segments[k + 3]);
                    }
                    long b = world.bodies().add(disc(), x, 0.55f, 0.3f, disc().area());
                    for (int step = 0; step < 240; step++) {
                        run(world, 1);
                        assertThat(Math.hypot(
                                        world.bodies().x(b), world.bodies().y(b)))
                                .isGreaterThan(0.495);
                    }
                }
            }
        }
    }

    @Test
    void theSpeedOfATouchIsNeverMinusZero() {
        try (World world = world(0, 0, 0)) {
            crate(world, 0, 0);
            crate(world, 0, 0.98);
            world.bodies().report(true);
            run(world, 1);
            BodyEvents events = world.bodies().events();
            assertThat(events.size()).isEqualTo(1);
            assertThat(Float.floatToRawIntBits(events.speed(0))).isZero();
        }
    }

    @Test
    void oneWayPiecesLetPassFromBelow() {
        try (World world = world(0.6, 0, 10)) {
            world.kind(2).setOneWay(true);
            world.terrain().addChain(Chain.of(5, 2, -5, 2), 2, null);
            long b = box(world, 0, 0, 0, 0.25, 0.25, 0.02);
            world.bodies().setVelocity(b, 0, 9);
            float high = 0;
            for (int k = 0; k < 240; k++) {
                run(world, 1);
                high = Math.max(high, world.bodies().y(b));
            }
            assertThat(high).isCloseTo(4.05f, within(0.1f));
            assertThat(world.bodies().y(b)).isCloseTo(2.25f, within(0.01f));
        }
    }

    @Test
    void aBowlHoldsABody() {
        try (World world = world(0.1, 0, 10)) {
            world.terrain().addChain(Chain.from(10, 0).arcTo(0, 0, -PI));
            long b = box(world, 4, -5, 0, 0.4, 0.4, 0.04);
            run(world, 1800);
            assertThat(world.bodies().y(b)).isBetween(-9.7f, -9.3f);
            assertThat(kinetic(world)).isLessThan(1e-6);
        }
    }

    @Test
    void bodiesMeetAcrossASeam() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 40, 40)
                .edges(Edge.WRAP, Edge.WALL)
                .restitution(0)
                .build()) {
            long a = box(world, 39, 20, 0, 0.5, 0.5, ROUNDING);
            long b = box(world, 2, 20, 0, 0.5, 0.5, ROUNDING);
            world.bodies().setVelocity(a, 2, 0);
            run(world, 120);
            assertThat(world.bodies().vx(a)).isCloseTo(1, within(0.01f));
            assertThat(world.bodies().vx(b)).isCloseTo(1, within(0.01f));
        }
    }

    @Test
    void kindsThatIgnoreEachOtherPass() {
        try (World world = onFloor(0.6, 0)) {
            world.setResponse(4, 5, Response.IGNORE);
            Outline outline = Outline.box(1, 1);
            long a = world.bodies().add(outline, 0, 0.5f, 0, 1, 4);
            long b = world.bodies().add(outline, 0, 2, 0, 1, 5);
            run(world, 120);
            assertThat(world.bodies().y(a)).isCloseTo(0.5f, within(0.01f));
            assertThat(world.bodies().y(b)).isCloseTo(0.5f, within(0.01f));
        }
    }

    @Test
    void anyNumberOfThreadsHasTheSameBits() {
        assertThat(hashWith(2)).isEqualTo(hashWith(1));
    }

    @Test
    void aSavedWorldGoesOnToTheBit() {
        try (World world = mixed();
                World other = WorldScenes.jvm().bounds(0, 0, 1, 1).build()) {
            run(world, 90);
            ByteBuffer saved = snapshot(world);
            other.restore(saved);
            run(world, 60);
            run(other, 60);
            assertThat(other.hash()).isEqualTo(world.hash());
        }
    }

    /** Outlines of all sorts, circles, a drum that turns, and a seam. */
    private static World mixed() {
        World world = WorldScenes.jvm()
                .bounds(0, 0, 40, 40)
                .edges(Edge.WRAP, Edge.WALL)
                .gravity(0, -10)
                .friction(0.5f)
                .restitution(0.3f)
                .build();
        TerrainBody wheel = world.terrain().addBody(20, 3, 0);
        wheel.addSegment(-4, 0, 4, 0);
        wheel.addSegment(0, -4, 0, 4);
        wheel.setAngularVelocity(2);
        Outline[] outlines = {
            Outline.box(1, 1),
            Outline.capsule(1, 0.3f),
            Outline.polygon(0, 0, 1, 0, 1, 0.3f, 0.3f, 0.3f, 0.3f, 1, 0, 1),
            Outline.of(Chain.from(0.5f, 0).arcTo(0, 0, 2 * PI).close()),
            Outline.of(Chain.from(0.6f, 0).arcTo(0, 0, PI).close())
        };
        for (int k = 0; k < 60; k++) {
            Outline outline = outlines[k % outlines.length];
            world.bodies().add(outline, 1 + k % 12 * 3.2f, 8 + k / 12 * 2, k, outline.area());
        }
        for (int k = 0; k < 100; k++) {
            circle(world, 0.5 + k % 20 * 1.95, 1 + k / 20 * 0.9, 0.3, 1);
        }
        return world;
    }

    @Test
    void outlinesOfAllSortsStayInTheirBounds() {
        try (World world = mixed()) {
            for (int k = 0; k < 20; k++) {
                run(world, 30);
                for (int id = 0; id < world.bodies().idLimit(); id++) {
                    long b = world.bodies().handle(id);
                    assertThat(world.bodies().y(b)).isBetween(0.1f, 39.9f);
                    assertThat(world.bodies().x(b)).isBetween(0f, 40f);
                    assertThat(Math.hypot(world.bodies().vx(b), world.bodies().vy(b)))
                            .isLessThan(40);
                }
            }
        }
    }

    private static long hashWith(int threads) {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 40, 40)
                .gravity(0, -10)
                .friction(0.5f)
                .threads(threads)
                .build()) {
            for (int k = 0; k < 1200; k++) {
                circle(world, 1 + k % 40 * 0.95, 12 + k / 40 * 0.9, 0.3 + k % 3 * 0.05, 1);
            }
            for (int k = 0; k < 20; k++) {
                crate(world, 2 + k * 1.8, 2 + k % 3 * 1.5);
            }
            run(world, 120);
            return world.hash();
        }
    }
}
