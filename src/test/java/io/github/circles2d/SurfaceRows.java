package io.github.circles2d;

import static io.github.circles2d.SurfaceBall.DT;
import static io.github.circles2d.SurfaceBall.G;
import static io.github.circles2d.SurfaceBall.R;

import java.util.List;

/** The scenes of one disc that measure how surfaces grip; {@link SurfaceCrowds} has those of many. */
final class SurfaceRows {
    private static final double TWO_STEPS = 2 * DT;

    private SurfaceRows() {}

    static List<FigureRow> all() {
        return List.of(
                new FigureRow("A1", SurfaceRows::rollsDown),
                new FigureRow("A2", SurfaceRows::stillRollsDown),
                new FigureRow("A3", SurfaceRows::slidesDown),
                new FigureRow("A4", SurfaceRows::sticks),
                new FigureRow("A5", SurfaceRows::doesNotStick),
                new FigureRow("A6", () -> roll("A6", "thrown at 6 m/s", 6, 0, 3.996, 0.683, 0.003)),
                new FigureRow(
                        "A7", () -> roll("A7", "thrown at 3 m/s with a backspin of 9", 3, -9, -1.008, 1.35, 0.01)),
                new FigureRow("A8", () -> roll("A8", "spinning at 6 m/s", 0, 6, 2.002, 0.683, 0.005)),
                new FigureRow("A9", SurfaceRows::rollsOn),
                new FigureRow("A10", SurfaceRows::rollsOut),
                new FigureRow("A11", SurfaceRows::rollingIsHeld),
                new FigureRow("A12", SurfaceRows::bounces),
                new FigureRow("A13", SurfaceRows::billiards),
                new FigureRow("A15", SurfaceRows::belts),
                new FigureRow("A16", SurfaceRows::platform),
                new FigureRow("A17", SurfaceRows::rollers));
    }

    // ---- slopes

    private static World.Builder slope(double tangent, double friction, double rollingResistance) {
        return SurfaceBall.builder(friction, rollingResistance, 0)
                .gravity((float) (G * sine(tangent)), (float) (-G * cosine(tangent)));
    }

    private static double cosine(double tangent) {
        return Math.cos(Math.atan(tangent));
    }

    private static double sine(double tangent) {
        return Math.sin(Math.atan(tangent));
    }

    /** The acceleration of a disc that rolls. */
    private static double rolling(double tangent, double resistance) {
        return 2 * G / 3 * (sine(tangent) - resistance * cosine(tangent));
    }

    /** Along the slope, and of the surface, forwards; over two seconds, after half of one. */
    private static double[] accelerations(World.Builder slope, int kind) {
        try (SurfaceBall ball = SurfaceBall.at(slope, R, kind)) {
            ball.step(30);
            double v = ball.vx();
            double s = ball.surfaceSpeed();
            ball.step(120);
            return new double[] {(ball.vx() - v) / 2, -(ball.surfaceSpeed() - s) / 2};
        }
    }

    private static List<RowFigure> rollsDown() {
        double tangent = Math.tan(Math.toRadians(20));
        double exact = rolling(tangent, 0);
        double[] a = accelerations(slope(tangent, 0.6, 0), 0);
        String scene = "slope of 20 degrees, mu 0.6, rolls: ";
        return List.of(
                RowFigure.share("A1", scene + "acceleration, m/s2", exact, 2.28115, 0.005, a[0]),
                RowFigure.share("A1", scene + "that of the surface, m/s2", a[0], 2.2743, 0.005, a[1]));
    }

    private static List<RowFigure> stillRollsDown() {
        double exact = rolling(0.56, 0);
        double[] a = accelerations(slope(0.56, 0.2, 0), 0);
        String scene = "slope of 2.8 mu, mu 0.2, still rolls: ";
        return List.of(
                RowFigure.share("A2", scene + "acceleration, m/s2", exact, 3.25568, 0.005, a[0]),
                RowFigure.share("A2", scene + "that of the surface, m/s2", exact, 3.25277, 0.005, a[1]));
    }

    private static List<RowFigure> slidesDown() {
        double[] a = accelerations(slope(0.6, 0.1, 0), 0);
        double exact = G * (sine(0.6) - 0.1 * cosine(0.6));
        String scene = "slope of 6 mu, mu 0.1, slides: ";
        return List.of(
                RowFigure.share("A3", scene + "acceleration, m/s2", exact, 4.29096, 0.005, a[0]),
                RowFigure.share(
                        "A3", scene + "that of the surface, m/s2", 2 * 0.1 * G * cosine(0.6), 1.70593, 0.01, a[1]));
    }

    private static List<RowFigure> sticks() {
        try (SurfaceBall ball = SurfaceBall.at(slope(0.54, 0.6, 0), R, SurfaceBall.LOCKED)) {
            ball.step(60);
            double x = ball.x();
            double y = ball.y();
            ball.step(600);
            double creep = Math.hypot(ball.x() - x, ball.y() - y);
            return List.of(RowFigure.within("A4", "slope of 0.9 mu, does not turn: way in 10 s, m", 0, 0, 1e-4, creep));
        }
    }

    private static List<RowFigure> doesNotStick() {
        double[] a = accelerations(slope(0.66, 0.6, 0), SurfaceBall.LOCKED);
        double exact = G * (sine(0.66) - 0.6 * cosine(0.66));
        return List.of(RowFigure.share(
                "A5", "slope of 1.1 mu, does not turn: acceleration, m/s2", exact, 0.500851, 0.01, a[0]));
    }

    private static List<RowFigure> rollingIsHeld() {
        double held = accelerations(slope(0.09, 0.6, 0.1), 0)[0];
        double[] a = accelerations(slope(0.2, 0.6, 0.1), 0);
        return List.of(
                RowFigure.within("A11", "slope of 0.9 c, c 0.1: acceleration, m/s2", 0, 0, 1e-4, held),
                RowFigure.share("A11", "slope of 2 c: acceleration, m/s2", rolling(0.2, 0.1), 0.656221, 0.01, a[0]),
                RowFigure.share(
                        "A11", "slope of 2 c: that of the surface, m/s2", rolling(0.2, 0.1), 0.652394, 0.01, a[1]));
    }

    // ---- a level floor

    /** A disc that slides until it rolls; the surface speed is that of rolling forwards. */
    private static List<RowFigure> roll(
            String row, String what, double v, double s, double box2dSpeed, double box2dTime, double share) {
        double mu = 0.3;
        double rolls = -1;
        try (SurfaceBall ball = SurfaceBall.on(SurfaceBall.builder(mu, 0, 0))) {
            ball.step(30);
            ball.throwWith(v, 0, -s);
            for (int step = 1; step <= 300; step++) {
                ball.step(1);
                if (rolls < 0 && Math.abs(ball.vx() + ball.surfaceSpeed()) < 0.01) {
                    rolls = step * DT;
                }
            }
            double exactTime = Math.abs(v - s) / (3 * mu * G);
            return List.of(
                    RowFigure.share(row, what + ", mu 0.3: speed, m/s", (2 * v + s) / 3, box2dSpeed, share, ball.vx()),
                    RowFigure.within(
                            row, what + ", mu 0.3: time until it rolls, s", exactTime, box2dTime, TWO_STEPS, rolls));
        }
    }

    private static List<RowFigure> rollsOn() {
        double off = 0;
        try (SurfaceBall ball = SurfaceBall.on(SurfaceBall.builder(0.6, 0, 0))) {
            ball.step(30);
            ball.throwWith(4, 0, -4);
            for (int step = 0; step < 3600; step++) {
                ball.step(1);
                off = Math.max(off, Math.abs(ball.y() - R));
            }
            return List.of(
                    RowFigure.share("A9", "rolls at 4 m/s for 60 s: speed, m/s", 4, 3.99683, 0.001, ball.vx()),
                    RowFigure.within("A9", "rolls at 4 m/s for 60 s: height off, m", 0, 2.29132e-3, 2e-4, off));
        }
    }

    private static List<RowFigure> rollsOut() {
        double c = 0.05;
        double stops = -1;
        try (SurfaceBall ball = SurfaceBall.on(SurfaceBall.builder(0.6, c, 0))) {
            ball.step(30);
            ball.throwWith(4, 0, -4);
            double from = ball.x();
            for (int step = 1; step <= 1200; step++) {
                ball.step(1);
                if (stops < 0 && Math.abs(ball.vx()) < 0.002) {
                    stops = step * DT;
                }
            }
            double way = ball.x() - from;
            return List.of(
                    RowFigure.share("A10", "rolls at 4 m/s, c 0.05: way, m", 3 * 16 / (4 * c * G), 23.9679, 0.005, way),
                    RowFigure.share(
                            "A10",
                            "rolls at 4 m/s, c 0.05: time until it stops, s",
                            12 / (2 * c * G),
                            12,
                            0.005,
                            stops),
                    RowFigure.within("A10", "rolls at 4 m/s, c 0.05: speed then, m/s", 0, 0, 1e-6, ball.speed()));
        }
    }

    private static List<RowFigure> belts() {
        double[] locked = belt(0, SurfaceBall.LOCKED, 3, 300);
        double[] free = belt(0, 0, 1, 300);
        double[] held = belt(0.1, 0, 3, 600);
        return List.of(
                RowFigure.share("A15", "belt of 3 m/s, does not turn: speed, m/s", 3, 3, 0.005, locked[0]),
                RowFigure.within(
                        "A15", "belt, does not turn: time to 99 %, s", 0.99 * 3 / (0.5 * G), 0.6, TWO_STEPS, locked[1]),
                RowFigure.share("A15", "belt, turns: speed, m/s", 1, 1.00076, 0.005, free[0]),
                RowFigure.within(
                        "A15", "belt, turns: time to 99 %, s", 0.99 * 3 / (3 * 0.5 * G), 0.2, TWO_STEPS, free[1]),
                RowFigure.share("A15", "belt, c 0.1, after 10 s: speed, m/s", 3, 3, 0.005, held[0]));
    }

    /** Speed after so many steps on a belt, and the time after which it was almost reached. */
    private static double[] belt(double resistance, int kind, double goal, int steps) {
        World.Builder builder =
                SurfaceBall.builder(0.5, resistance, 0).wallSurface(Wall.MIN_Y, 0.5f, (float) resistance, 3);
        double reached = -1;
        try (SurfaceBall ball = SurfaceBall.at(builder, R, kind)) {
            for (int step = 1; step <= steps; step++) {
                ball.step(1);
                if (reached < 0 && ball.vx() > 0.99 * goal) {
                    reached = step * DT;
                }
            }
            return new double[] {ball.vx(), reached};
        }
    }

    // ---- bounces

    private static List<RowFigure> bounces() {
        double[] grips = bounce(0.6, 0.5, 3, -5, 0);
        double[] slips = bounce(0.2, 0.5, 12, -4, 0);
        double[] spins = bounce(0.6, 0.5, 0, -5, 3);
        double[] dull = bounce(0.2, 0, 12, -4, 0);
        return List.of(
                RowFigure.share("A12", "(3, -5) m/s, e 0.5, mu 0.6, grips: vx, m/s", 2, 2.00014, 0.005, grips[0]),
                RowFigure.share("A12", "the same: spin, m/s", 2, 2.00008, 0.005, grips[1]),
                RowFigure.share("A12", "the same: vy, m/s", 2.5, 2.49991, 0.005, grips[2]),
                RowFigure.share("A12b", "(12, -4), e 0.5, mu 0.2, slips: vx, m/s", 10.8, 11.1993, 0.01, slips[0]),
                RowFigure.share("A12b", "the same: spin, m/s", 2.4, 1.54703, 0.01, slips[1]),
                RowFigure.share("A12c", "(0, -5), spin 3, e 0.5, mu 0.6: vx, m/s", 1, 1, 0.005, spins[0]),
                RowFigure.share("A12c", "the same: spin, m/s", 1, 1, 0.005, spins[1]),
                RowFigure.share("A12d", "(12, -4), e 0, mu 0.2, slips: vx, m/s", 11.2, 11.1993, 0.01, dull[0]),
                RowFigure.share("A12d", "the same: spin, m/s", 1.6, 1.54738, 0.01, dull[1]));
    }

    /** Speed along the floor, of the surface forwards, and upwards, after the bounce of a disc without gravity. */
    private static double[] bounce(double mu, double e, double vx, double vy, double spin) {
        try (SurfaceBall ball = SurfaceBall.at(SurfaceBall.builder(mu, 0, e).gravity(0, 0), R + 0.5f, 0)) {
            ball.throwWith(vx, vy, -spin);
            ball.step(60);
            return new double[] {ball.vx(), -ball.surfaceSpeed(), ball.vy()};
        }
    }

    private static List<RowFigure> billiards() {
        double[] grips = billiard(0.2);
        double[] slips = billiard(0.05);
        return List.of(
                RowFigure.share(
                        "A13",
                        "4 m/s, spin 2, e 1, mu 0.2, into one at rest: throw, m/s",
                        2 / 6.0,
                        0.333333,
                        0.01,
                        grips[0]),
                RowFigure.share("A13", "the same: speed along the line, m/s", 4, 4, 0.01, grips[1]),
                RowFigure.share("A13b", "the same, mu 0.05, slips: throw, m/s", 0.2, 0.1, 0.02, slips[0]));
    }

    /** What a disc does that a spinning one hits, across the line and along it. */
    private static double[] billiard(double mu) {
        World.Builder builder = SurfaceBall.builder(mu, 0, 1).gravity(0, 0);
        try (SurfaceBall ball = SurfaceBall.at(builder, 20, 0)) {
            long other = ball.world.add(2, 20, R, 1, 0, 0);
            ball.throwWith(4, 0, 2);
            ball.step(120);
            return new double[] {ball.world.vy(other), ball.world.vx(other)};
        }
    }

    // ---- static circles

    private static List<RowFigure> platform() {
        return List.of(
                RowFigure.share(
                        "A16",
                        "platform of 3 m/s, does not turn: speed, m/s",
                        3,
                        3,
                        0.005,
                        platform(SurfaceBall.LOCKED, 60)),
                RowFigure.share("A16", "platform, turns: speed, m/s", 1, 1.0006, 0.005, platform(0, 20)));
    }

    /**
     * The speed of a disc on a static circle that moves, and that is so large that the disc hardly notices that it is round; before it
     * rolls off.
     */
    private static double platform(int kind, int steps) {
        World.Builder builder = SurfaceBall.builder(0.5, 0, 0).bounds(-3000, -3000, 3000, 3000);
        try (SurfaceBall ball = SurfaceBall.at(builder, R, kind)) {
            ball.world.add(0, -1000, 1000, Float.POSITIVE_INFINITY, 3, 0);
            ball.step(steps);
            return ball.vx();
        }
    }

    private static List<RowFigure> rollers() {
        World.Builder builder = SurfaceBall.builder(0.6, 0, 0).bounds(-10, -10, 10, 10);
        try (SurfaceBall ball = SurfaceBall.at(builder, 0.8f, 0)) {
            for (int side = -1; side <= 1; side += 2) {
                long roller = ball.world.add(0.6f * side, 0, R, Float.POSITIVE_INFINITY, 0, 0);
                ball.world.setAngularVelocity(roller, 4);
            }
            ball.step(600);
            return List.of(
                    RowFigure.share(
                            "A17",
                            "on two rollers at 4 rad/s: angular velocity, rad/s",
                            -4,
                            -4.03568,
                            0.01,
                            ball.world.angularVelocity(ball.handle)),
                    RowFigure.within("A17", "on two rollers at 4 rad/s: speed, m/s", 0, 0.0677726, 0.05, ball.speed()));
        }
    }
}
