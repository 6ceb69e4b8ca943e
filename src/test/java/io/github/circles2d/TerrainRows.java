package io.github.circles2d;

import static io.github.circles2d.TerrainBall.DT;
import static io.github.circles2d.TerrainBall.G;
import static io.github.circles2d.TerrainBall.R;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The scenes of one disc on terrain; {@link TerrainShots} has those of fast ones, {@link TerrainCrowds} those of many. */
final class TerrainRows {
    private static final double HEIGHT_OFF = 2e-4;

    private TerrainRows() {}

    static List<FigureRow> all() {
        return List.of(
                new FigureRow("B1", TerrainRows::chains),
                new FigureRow("B2", TerrainRows::looseSegments),
                new FigureRow("B3", TerrainRows::oneSegment),
                new FigureRow("B4", TerrainRows::concaveCorners),
                new FigureRow("B5", TerrainRows::convexCorners),
                new FigureRow("B8", TerrainRows::fromBehind),
                new FigureRow("B8b", TerrainRows::turnsBack),
                new FigureRow("B9", TerrainRows::rests),
                new FigureRow("B10", TerrainRows::bouncesOn),
                new FigureRow("B11", TerrainRows::laps));
    }

    // ---- level grounds

    private static List<RowFigure> chains() {
        List<RowFigure> figures = new ArrayList<>();
        figures.addAll(rollOver("B1", true, 4, 0, 0.001, 3.99684, 0.00229132));
        figures.addAll(rollOver("B1", true, 20, 0, 0.001, 19.9319, 0.0105247));
        figures.addAll(rollOver("B1", true, 20, 0.5, 0.001, 19.9319, 0.0105247));
        return figures;
    }

    private static List<RowFigure> looseSegments() {
        List<RowFigure> figures = new ArrayList<>();
        figures.addAll(rollOver("B2", false, 4, 0, 0.01, 0.46082, 0.00858149));
        figures.addAll(rollOver("B2", false, 20, 0, 0.01, 12.1522, 0.742214));
        return figures;
    }

    /** Rolls 200 m over pieces of half a metre in a line. */
    private static List<RowFigure> rollOver(
            String row, boolean chain, double v, double e, double share, double box2d, double box2dOff) {
        float[] points = new float[1000];
        for (int k = 0; k < points.length; k += 2) {
            points[k] = (500 - k / 2) * 0.5f - 5;
        }
        String scene = String.format(
                Locale.ROOT, "500 collinear pieces, %s, v %.0f, e %.1f: ", chain ? "a chain" : "loose", v, e);
        try (TerrainBall ball =
                TerrainBall.at(0, R, TerrainBall.builder(G, 0.6, e)).on(chain, points)) {
            double off = heightOff(ball, v, (int) (200 / v * 60));
            return List.of(
                    RowFigure.share(row, scene + "speed after 200 m, m/s", v, box2d, share, ball.vx()),
                    RowFigure.within(row, scene + "height off, m", 0, box2dOff, HEIGHT_OFF, off));
        }
    }

    /** The greatest change of height of a disc that lies on the ground, and then rolls. */
    private static double heightOff(TerrainBall ball, double v, int steps) {
        ball.step(60);
        double y = ball.y();
        double off = 0;
        ball.roll(v);
        for (int step = 0; step < steps; step++) {
            ball.step(1);
            off = Math.max(off, Math.abs(ball.y() - y));
        }
        return off;
    }

    private static List<RowFigure> oneSegment() {
        List<RowFigure> figures = new ArrayList<>();
        try (TerrainBall ball =
                TerrainBall.at(0, R, TerrainBall.builder(G, 0.6, 0)).on(false, -10, 0, 300, 0)) {
            double off = heightOff(ball, 20, 600);
            figures.add(
                    RowFigure.share("B3", "one segment, v 20: speed after 200 m, m/s", 20, 19.9319, 0.001, ball.vx()));
            figures.add(RowFigure.within("B3", "the same: height off, m", 0, 0.0105247, HEIGHT_OFF, off));
        }
        figures.add(afterFifteenSeconds("rolls at 20", 0.6, 20, 0, 0.0101196));
        figures.add(afterFifteenSeconds("slides at 20, mu 0", 0, 20, 0, 0.000110328));
        figures.add(afterFifteenSeconds("slides at 20, does not turn", 0, 20, TerrainBall.LOCKED, 0.000110328));
        figures.add(afterFifteenSeconds("rolls at 4", 0.6, 4, 0, 0.00229451));
        return figures;
    }

    private static RowFigure afterFifteenSeconds(String what, double mu, double v, int kind, double box2d) {
        try (TerrainBall ball =
                TerrainBall.of(0, R, 1, kind, TerrainBall.builder(G, mu, 0)).on(false, -10, 0, 900, 0)) {
            ball.step(60);
            double y = ball.y();
            double off = 0;
            ball.slide(v, mu == 0 || kind == TerrainBall.LOCKED ? 0 : -v / R);
            for (int step = 0; step < 1800; step++) {
                ball.step(1);
                off = step > 900 ? Math.max(off, Math.abs(ball.y() - y)) : 0;
            }
            return RowFigure.within(
                    "B3b", "one segment, " + what + ", from 15 s to 30 s: height off, m", 0, box2d, HEIGHT_OFF, off);
        }
    }

    // ---- corners

    private static List<RowFigure> concaveCorners() {
        return List.of(concave(true, 30, 3.59788), concave(false, 30, 3.59789), concave(true, 10, 3.935));
    }

    /** The speed up the slope that a disc has rolled into, at the corner. */
    private static RowFigure concave(boolean chain, int degrees, double box2d) {
        double a = Math.toRadians(degrees);
        float x = (float) Math.cos(a);
        float y = (float) Math.sin(a);
        double corner = -R * Math.tan(a / 2);
        double up = Double.NaN;
        try (TerrainBall ball =
                TerrainBall.at(-4, R, TerrainBall.builder(G, 0.9, 0)).on(chain, 20 * x, 20 * y, 0, 0, -20, 0)) {
            ball.step(30);
            ball.roll(4);
            int hit = 0;
            for (int step = 0; step < 200 && hit < 5; step++) {
                ball.step(1);
                hit += ball.x() > corner + 0.002 ? 1 : 0;
            }
            double along = ball.vx() * Math.cos(a) + ball.vy() * Math.sin(a);
            double way = (ball.x() - corner) / Math.cos(a);
            up = hit < 5 ? Double.NaN : Math.sqrt(along * along + 4 * G / 3 * Math.sin(a) * way);
        }
        String scene = "concave corner of " + degrees + " degrees, " + (chain ? "a chain" : "segments") + ", v 4: ";
        return RowFigure.share("B4", scene + "speed behind it, m/s", 4 * (2 * Math.cos(a) + 1) / 3, box2d, 0.02, up);
    }

    private static List<RowFigure> convexCorners() {
        List<RowFigure> figures = new ArrayList<>();
        figures.addAll(convex(true, 0.000857133, -0.715325));
        figures.addAll(convex(false, 0.000830679, -0.775039));
        return figures;
    }

    /** A disc that rolls slowly over an edge, and stays on the ground. */
    private static List<RowFigure> convex(boolean chain, double box2dGap, double box2dEnergy) {
        double a = Math.toRadians(20);
        float x = 60 * (float) Math.cos(a);
        float y = -60 * (float) Math.sin(a);
        try (TerrainBall ball =
                TerrainBall.at(-1, R, TerrainBall.builder(G, 0.9, 0)).on(chain, x, y, 0, 0, -20, 0)) {
            ball.step(30);
            ball.roll(1);
            double height = ball.y();
            double first = 0.75 + G * height;
            double gap = 0;
            for (int step = 0; step < 180; step++) {
                ball.step(1);
                gap = Math.max(gap, distanceToEdge(ball.x(), ball.y(), a) - R);
            }
            double last = ball.kineticEnergy() + G * ball.y();
            double gained = G * (height - ball.y());
            String scene = "convex corner of 20 degrees, " + (chain ? "a chain" : "segments") + ", v 1: ";
            return List.of(
                    RowFigure.between("B5", scene + "greatest gap, m", box2dGap, 0, 0.002, gap),
                    RowFigure.within(
                            "B5",
                            scene + "change of energy behind it, % of the gain",
                            0,
                            box2dEnergy,
                            1,
                            100 * (last - first) / gained));
        }
    }

    private static double distanceToEdge(double x, double y, double a) {
        if (x < 0) {
            return y;
        }
        return x * Math.cos(a) - y * Math.sin(a) < 0 ? Math.hypot(x, y) : x * Math.sin(a) + y * Math.cos(a);
    }

    // ---- one-way

    /** A line that circles pass from below. */
    private static TerrainBall oneWay(double gravity, double y, double vy) {
        TerrainBall ball = TerrainBall.at(0, y, TerrainBall.builder(gravity, 0.6, 0));
        ball.world.kind(2).setOneWay(true);
        ball.world.terrain().addChain(Chain.of(60, 0, 50, 0, -50, 0, -60, 0), 2, null);
        ball.world.setVelocity(ball.handle, 0, (float) vy);
        return ball;
    }

    private static List<RowFigure> fromBehind() {
        int passed = 0;
        for (int k = 0; k < 24; k++) {
            try (TerrainBall ball = oneWay(0, -1.05 - 0.02 * k, 6)) {
                ball.step(60);
                passed += ball.y() > 0.6 && Math.abs(ball.vy() - 6) < 1e-3 ? 1 : 0;
            }
        }
        return List.of(RowFigure.within(
                "B8", "one-way, from behind at 6 m/s: pass and keep their speed, of 24", 24, 24, 0, passed));
    }

    private static List<RowFigure> turnsBack() {
        List<RowFigure> figures = new ArrayList<>();
        figures.addAll(turnsBack(2, 1.9811, 0.49993));
        figures.addAll(turnsBack(0.3, 0.49993, 0.49993));
        figures.addAll(turnsBack(0.05, 0.49993, 0.49993));
        return figures;
    }

    /** Thrown from below so that its centre turns back at a height above the line. */
    private static List<RowFigure> turnsBack(double height, double box2dTop, double box2dEnd) {
        try (TerrainBall ball = oneWay(G, -2, Math.sqrt(2 * G * (height + 2)))) {
            double top = -2;
            for (int step = 0; step < 240; step++) {
                ball.step(1);
                top = Math.max(top, ball.y());
            }
            String scene = String.format(Locale.ROOT, "one-way, thrown from 2 m below to %.2f m above: ", height);
            RowFigure rise = RowFigure.share("B8b", scene + "rises, m", height + 2, box2dTop + 2, 0.01, top + 2);
            boolean lands = height > R;
            RowFigure end = RowFigure.between(
                    "B8b",
                    scene + "height after 4 s, m",
                    box2dEnd,
                    lands ? R - 0.001 : -100,
                    lands ? R + 0.001 : -R,
                    ball.y());
            return List.of(rise, end);
        }
    }

    // ---- rest and bounces: as on a wall

    private static List<RowFigure> rests() {
        return List.of(
                rest("1 kg on a segment", 1, 7.03335e-5, depthOnWall(1)),
                rest("1,000 kg on a segment", 1000, 7.03335e-5, depthOnWall(1)),
                restInV());
    }

    private static RowFigure rest(String what, double mass, double box2d, double wall) {
        try (TerrainBall ball =
                TerrainBall.of(0, R, mass, 0, TerrainBall.builder(G, 0.6, 0)).on(false, -10, 0, 10, 0)) {
            ball.step(600);
            return depth(what, box2d, wall, R - ball.y());
        }
    }

    private static RowFigure restInV() {
        double diagonal = Math.sqrt(2);
        try (TerrainBall ball = TerrainBall.at(0, R * diagonal, TerrainBall.builder(G, 0.6, 0))
                .on(false, 10, 10, 0, 0)
                .on(false, 0, 0, -10, 10)) {
            ball.step(600);
            return depth("1 kg in a V", 4.51478e-5, depthInCorner(), R - ball.y() / diagonal);
        }
    }

    private static RowFigure depth(String what, double box2d, double wall, double depth) {
        double slack = 0.02 * wall + 1e-6;
        return RowFigure.between("B9", what + ", rests: depth, m", box2d, wall - slack, wall + slack, depth);
    }

    private static double depthOnWall(double mass) {
        World.Builder builder = SurfaceBall.builder(0.6, 0, 0);
        try (World world = builder.build()) {
            long ball = world.add(0, R, R, (float) mass, 0, 0);
            world.step((float) DT, 600);
            return R - world.y(ball);
        }
    }

    /** Of a disc in the corner of two walls, which the gravity leads into. */
    private static double depthInCorner() {
        float g = (float) (G * Math.sqrt(0.5));
        try (World world = SurfaceBall.builder(0.6, 0, 0)
                .bounds(0, 0, 20, 20)
                .gravity(-g, -g)
                .build()) {
            long ball = world.add(R, R, R, 1, 0, 0);
            world.step((float) DT, 600);
            return R - world.y(ball);
        }
    }

    private static List<RowFigure> bouncesOn() {
        double onWall;
        try (World world = SurfaceBall.builder(0, 0, 1).build()) {
            long ball = world.add(0, 5.5f, R, 1, 0, 0);
            onWall = heightAfterAMinute(world, ball);
        }
        double onSegment;
        try (TerrainBall ball =
                TerrainBall.at(0, 5.5, TerrainBall.builder(G, 0, 1)).on(false, -10, 0, 10, 0)) {
            onSegment = heightAfterAMinute(ball.world, ball.handle);
        }
        return List.of(RowFigure.between(
                "B10",
                "e 1, falls 5 m, for 60 s: height, m (a wall gives " + String.format(Locale.ROOT, "%.4f)", onWall),
                4.39357,
                onWall - 1e-3,
                onWall + 1e-3,
                onSegment));
    }

    private static double heightAfterAMinute(World world, long ball) {
        double top = 0;
        for (int step = 0; step < 3600; step++) {
            world.step((float) DT);
            top = step > 3300 ? Math.max(top, world.y(ball) - R) : 0;
        }
        return top;
    }

    // ---- loops

    private static List<RowFigure> laps() {
        return List.of(
                lap(32, 5.30643),
                lap(64, 6.52251),
                lap(128, 7.20495),
                RowFigure.share("B11", "a lap on an arc, v 8: speed, m/s", 8, Double.NaN, 0.005, lap(arc(), 5)));
    }

    private static World arc() {
        World world = TerrainBall.builder(0, 0.9, 0).build();
        world.terrain().addArc(0, 0, 5, 0, 2 * (float) Math.PI, ArcSide.INNER);
        return world;
    }

    private static RowFigure lap(int pieces, double box2d) {
        float[] points = new float[2 * pieces];
        for (int k = 0; k < pieces; k++) {
            double a = -2 * Math.PI * k / pieces;
            points[2 * k] = 5 * (float) Math.cos(a);
            points[2 * k + 1] = 5 * (float) Math.sin(a);
        }
        World world = TerrainBall.builder(0, 0.9, 0).build();
        world.terrain().addChain(Chain.of(points).close());
        double share = (2 * Math.cos(2 * Math.PI / pieces) + 1) / 3;
        double exact = 8 * Math.pow(share, pieces);
        String scene = "a lap in a loop of " + pieces + " lines, v 8: speed, m/s";
        return RowFigure.share("B11", scene, exact, box2d, 0.01, lap(world, 5 * Math.cos(Math.PI / pieces)));
    }

    /** The speed of a disc after a lap; without gravity. */
    private static double lap(World world, double inside) {
        try (world) {
            long ball = world.add(0, (float) (R - inside), R, 1, 8, 0);
            world.setAngularVelocity(ball, -8 / R);
            double turned = 0;
            double angle = Math.atan2(world.y(ball), world.x(ball));
            for (int step = 0; step < 2000 && turned < 2 * Math.PI; step++) {
                world.step((float) DT);
                double next = Math.atan2(world.y(ball), world.x(ball));
                turned += Math.IEEEremainder(next - angle, 2 * Math.PI);
                angle = next;
            }
            return turned < 2 * Math.PI ? Double.NaN : Math.hypot(world.vx(ball), world.vy(ball));
        }
    }
}
