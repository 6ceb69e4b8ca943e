package io.github.circles2d;

import static io.github.circles2d.TerrainBall.DT;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Predicate;

/** Fast circles and pieces, which none of them passes: neither pieces at rest nor pieces that move and turn. */
final class TerrainShots {
    private static final int STEPS = 20;

    /** Circles of one group do not meet each other. */
    private static final int GROUP = 1;

    private final World world = TerrainBall.builder(0, 0.6, 0).build();
    private final SplittableRandom random = new SplittableRandom(6);
    private final float r;
    private final float speed;
    private final List<Long> shots = new ArrayList<>();

    private TerrainShots(float r, float speed) {
        this.r = r;
        this.speed = speed;
    }

    /** Radius 0.1 at 100 m/s, and 0.02 at 390. */
    private static TerrainShots[] guns() {
        return new TerrainShots[] {new TerrainShots(0.1f, 100), new TerrainShots(0.02f, 390)};
    }

    static List<FigureRow> all() {
        return List.of(new FigureRow("B6", TerrainShots::through), new FigureRow("B7", TerrainShots::flippers));
    }

    /** Where a circle is, in the coordinates of a body. */
    private record Place(double x, double y) {
        Place in(TerrainBody body) {
            double dx = x - body.x();
            double dy = y - body.y();
            double c = Math.cos(body.angle());
            double s = Math.sin(body.angle());
            return new Place(c * dx + s * dy, c * dy - s * dx);
        }

        double length() {
            return Math.hypot(x, y);
        }

        boolean inSquare(double half) {
            return Math.abs(x) < half && Math.abs(y) < half;
        }
    }

    private double unit() {
        return random.nextInt(1 << 24) * 0x1p-24;
    }

    /** A circle that reaches a point with a velocity, if nothing is in its way, after a part of a step that is random. */
    private void shoot(double x, double y, double directionX, double directionY, double before) {
        double length = Math.hypot(directionX, directionY);
        double vx = speed * directionX / length;
        double vy = speed * directionY / length;
        double time = (before + unit() * speed * DT) / speed;
        long shot = world.add((float) (x - time * vx), (float) (y - time * vy), r, 1, (float) vx, (float) vy);
        world.setGroup(shot, GROUP);
        shots.add(shot);
    }

    /** How many circles are ever where none should be. */
    private int passed(Predicate<Place> beyond) {
        boolean[] gone = new boolean[shots.size()];
        try (world) {
            for (int step = 0; step < STEPS; step++) {
                world.step((float) DT);
                for (int k = 0; k < gone.length; k++) {
                    gone[k] |= beyond.test(new Place(world.x(shots.get(k)), world.y(shots.get(k))));
                }
            }
        }
        int passed = 0;
        for (boolean is : gone) {
            passed += is ? 1 : 0;
        }
        return passed;
    }

    private static List<RowFigure> through() {
        List<RowFigure> figures = new ArrayList<>();
        for (TerrainShots gun : guns()) {
            figures.add(gun.atLine("segments, from above", false, 1, 0));
        }
        for (TerrainShots gun : guns()) {
            figures.add(gun.atLine("segments, from below", false, -1, gun.r == 0.1f ? 0 : Double.NaN));
        }
        for (TerrainShots gun : guns()) {
            figures.add(gun.atLine("a chain, in front", true, 1, gun.r == 0.1f ? 0 : Double.NaN));
        }
        for (TerrainShots gun : guns()) {
            figures.add(gun.atCorners());
        }
        for (TerrainShots gun : guns()) {
            figures.add(gun.intoCorners());
        }
        for (TerrainShots gun : guns()) {
            figures.add(gun.atArcs());
        }
        for (TerrainShots gun : guns()) {
            figures.add(gun.inRing());
        }
        for (TerrainShots gun : guns()) {
            figures.add(gun.inStadium());
        }
        for (TerrainShots gun : guns()) {
            figures.add(gun.atMovingBox());
        }
        for (TerrainShots gun : guns()) {
            figures.add(gun.inTurningBox());
        }
        for (TerrainShots gun : guns()) {
            figures.add(gun.atTurningBlade());
        }
        return figures;
    }

    private RowFigure figure(String what, double box2d, Predicate<Place> beyond) {
        String scene = what + ", r " + r + " at " + Math.round(speed) + " m/s: through, of " + shots.size();
        return RowFigure.within("B6", scene, 0, box2d, 0, passed(beyond));
    }

    /** At 0 to 60 degrees from the normal. */
    private RowFigure atLine(String what, boolean chain, int side, double box2d) {
        TerrainBall.ground(world, chain, 300, 0, 200, 0, 50, 0, -50, 0, -200, 0, -300, 0);
        for (int degrees = 0; degrees <= 60; degrees += 15) {
            for (int k = 0; k < 24; k++) {
                double a = Math.toRadians(degrees);
                shoot(0, side * r, Math.sin(a), -side * Math.cos(a), 0.05);
            }
        }
        return figure(what, box2d, p -> p.y() * side < 0);
    }

    /** A square, drawn so that its front is outside or inside. */
    private static Chain square(double half, boolean outside) {
        float h = (float) half;
        return outside
                ? Chain.of(h, h, -h, h, -h, -h, h, -h).close()
                : Chain.of(h, h, h, -h, -h, -h, -h, h).close();
    }

    /** At the corners of a square from all around, as far beside them as the circle is large at most. */
    private RowFigure atCorners() {
        world.terrain().addChain(square(1, true));
        for (int k = 0; k < 120; k++) {
            double a = Math.PI / 4 + k % 4 * Math.PI / 2 + (unit() - 0.5) * Math.PI * 0.9;
            shootBeside(1.0 * corner(k), 1.0 * corner(k + 3), -Math.cos(a), -Math.sin(a), 4 * r);
        }
        return figure("a square, at its corners", Double.NaN, p -> p.inSquare(1));
    }

    /** The sign of the x of corner k, anticlockwise from the upper right one; that of its y is the one of k + 3. */
    private static int corner(int k) {
        return k % 4 == 0 || k % 4 == 3 ? 1 : -1;
    }

    private void shootBeside(double x, double y, double directionX, double directionY, double before) {
        double off = (2 * unit() - 1) * r;
        shoot(x - off * directionY, y + off * directionX, directionX, directionY, before);
    }

    private RowFigure intoCorners() {
        world.terrain().addChain(square(20, false));
        for (int k = 0; k < 120; k++) {
            double a = Math.PI / 4 + k % 4 * Math.PI / 2 + (unit() - 0.5) * Math.PI / 2 * 0.9;
            shootBeside((20 - 3 * r) * corner(k), (20 - 3 * r) * corner(k + 3), Math.cos(a), Math.sin(a), 4 * r);
        }
        return figure("a room, into its corners", Double.NaN, p -> !p.inSquare(20));
    }

    /** At a whole circle and at half of one, from outside. */
    private RowFigure atArcs() {
        world.terrain().addArc(0, 0, 1, 0, 2 * (float) Math.PI, ArcSide.OUTER);
        for (int k = 0; k < 120; k++) {
            double a = 2 * Math.PI * unit();
            double aim = a + (unit() - 0.5) * 2;
            shoot(Math.cos(a), Math.sin(a), -Math.cos(aim), -Math.sin(aim), 3 * r);
        }
        return figure("an arc, from outside", Double.NaN, p -> p.length() < 1);
    }

    private RowFigure inRing() {
        world.terrain().addArc(0, 0, 8, 0, 2 * (float) Math.PI, ArcSide.INNER);
        for (int k = 0; k < 120; k++) {
            double a = 2 * Math.PI * unit();
            double aim = a + (unit() - 0.5) * 2;
            shoot(7.5 * Math.cos(a), 7.5 * Math.sin(a), Math.cos(aim), Math.sin(aim), 0);
        }
        return figure("an arc, from inside", Double.NaN, p -> p.length() > 8);
    }

    /** Two lines and two half circles: half of the circles fly at the joints. */
    private RowFigure inStadium() {
        float pi = (float) Math.PI;
        world.terrain()
                .addChain(Chain.from(10, 8)
                        .arcTo(10, 0, -pi)
                        .lineTo(-10, -8)
                        .arcTo(-10, 0, -pi)
                        .close());
        for (int k = 0; k < 120; k++) {
            double aim = 2 * Math.PI * unit();
            if (k % 2 == 0) {
                int up = k % 4 == 0 ? 1 : -1;
                int right = k % 8 < 4 ? 1 : -1;
                double x = right * Math.abs(Math.cos(aim));
                shootBeside(right * 10, up * (8 - 2.2 * r), x, up * Math.abs(Math.sin(aim)), r);
            } else {
                shoot(0, 0, Math.cos(aim), Math.sin(aim), 0);
            }
        }
        return figure(
                "a chain of lines and arcs, from inside",
                Double.NaN,
                p -> new Place(Math.max(Math.abs(p.x()) - 10, 0), p.y()).length() > 8);
    }

    /** A square that flies and turns, from all around. */
    private RowFigure atMovingBox() {
        TerrainBody body = world.terrain().addBody(-2, 0, 0);
        body.addChain(square(1, true), 0, null);
        body.setVelocity(12, 5);
        body.setAngularVelocity(9);
        for (int k = 0; k < 120; k++) {
            double a = 2 * Math.PI * unit();
            double aim = a + (unit() - 0.5);
            shoot(-2 + 1.5 * Math.cos(a), 1.5 * Math.sin(a), -Math.cos(aim), -Math.sin(aim), 2 * r);
        }
        return figure(
                "a square that moves and turns", Double.NaN, p -> p.in(body).inSquare(1));
    }

    private RowFigure inTurningBox() {
        TerrainBody body = world.terrain().addBody(0, 0, 0);
        body.addChain(square(10, false), 0, null);
        body.setVelocity(-8, 3);
        body.setAngularVelocity(4);
        for (int k = 0; k < 120; k++) {
            double aim = 2 * Math.PI * unit();
            shoot(10 * (unit() - 0.5), 10 * (unit() - 0.5), Math.cos(aim), Math.sin(aim), 0);
        }
        return figure(
                "a room that moves and turns", Double.NaN, p -> !p.in(body).inSquare(10));
    }

    /** Fast circles on both sides of a segment that flies and turns. */
    private RowFigure atTurningBlade() {
        TerrainBody body = world.terrain().addBody(0, 0, 0);
        body.addSegment(-60, 0, 60, 0);
        body.setAngularVelocity(3);
        body.setVelocity(2, -3);
        List<Integer> sides = new ArrayList<>();
        for (int k = 0; k < 120; k++) {
            int side = k % 2 == 0 ? 1 : -1;
            double a = (unit() - 0.5) * 2;
            shoot(8 * (unit() - 0.5), side * (1 + r), Math.sin(a), -side * Math.cos(a), r);
            sides.add(side);
        }
        int passed = 0;
        try (world) {
            boolean[] gone = new boolean[shots.size()];
            for (int step = 0; step < STEPS; step++) {
                world.step((float) DT);
                for (int k = 0; k < gone.length; k++) {
                    Place p = new Place(world.x(shots.get(k)), world.y(shots.get(k))).in(body);
                    gone[k] |= Math.abs(p.x()) < 59 && p.y() * sides.get(k) < 0;
                }
            }
            for (boolean is : gone) {
                passed += is ? 1 : 0;
            }
        }
        String scene = "a long blade that moves and turns, r " + r + " at " + Math.round(speed) + " m/s: through, of ";
        return RowFigure.within("B6", scene + shots.size(), 0, Double.NaN, 0, passed);
    }

    // ---- flippers

    private static List<RowFigure> flippers() {
        List<RowFigure> figures = new ArrayList<>();
        figures.addAll(flipper(10, 20.9341, 3));
        figures.addAll(flipper(30, 49.9967, 9));
        return figures;
    }

    /** Twelve balls at rest at different places in the way of a segment that turns about its end. */
    private static List<RowFigure> flipper(double omega, double box2d, double box2dThrough) {
        double slowest = Double.POSITIVE_INFINITY;
        double fastest = 0;
        int through = 0;
        for (int k = 0; k < 12; k++) {
            double gap = 0.02 + 0.05 * k;
            try (World world = TerrainBall.builder(0, 0.3, 0.5).build()) {
                float r = 0.1f;
                TerrainBody body = world.terrain().addBody(0, 0, 0);
                body.addSegment(0, 0, 2, 0);
                body.setAngularVelocity((float) omega);
                long ball = world.add(1, r + (float) gap, r, 0.1f, 0, 0);
                double arm = Math.sqrt(1 + (r + gap) * (r + gap) - r * r);
                double speed = 0;
                boolean passed = false;
                int steps = (int) (60 / omega) + 2;
                for (int step = 0; step < steps; step++) {
                    world.step((float) DT);
                    Place p = new Place(world.x(ball), world.y(ball)).in(body);
                    passed |= p.x() > 0 && p.x() < 2 && p.y() < 0;
                    speed = speed > 0 ? speed : Math.hypot(world.vx(ball), world.vy(ball));
                }
                through += passed ? 1 : 0;
                slowest = Math.min(slowest, speed / (1.5 * omega * arm));
                fastest = Math.max(fastest, speed / (1.5 * omega * arm));
            }
        }
        String scene = "flipper of " + Math.round(omega) + " rad/s, e 0.5, 12 balls about 1 m from its axis: ";
        double share = box2d / (1.5 * omega);
        return List.of(
                RowFigure.share("B7", scene + "slowest, of (1 + e) w d", 1, share, 0.1, slowest),
                RowFigure.share("B7", scene + "fastest, of (1 + e) w d", 1, share, 0.1, fastest),
                RowFigure.within("B7", scene + "through", 0, box2dThrough, 0, through));
    }
}
