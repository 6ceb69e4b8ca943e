package io.github.circles2d;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/**
 * The scenes of bodies that are pushed: boxes of 1 m with a rounding of 0.05 and density 1, friction 0.6, gravity 10, on terrain, unless a row says
 * otherwise. Exact are rigid bodies.
 */
final class BodyRows {
    private static final double NONE = Double.NaN;
    private static final double FAR = Double.POSITIVE_INFINITY;
    private static final double ROUNDING = 0.05;
    private static final float PI = (float) Math.PI;

    private BodyRows() {}

    /** Those of a second or so. */
    static List<FigureRow> quick() {
        return List.of(
                new FigureRow("D1", BodyRows::stackOfTen),
                new FigureRow("D5", BodyRows::slopes),
                new FigureRow("D6", BodyRows::slides),
                new FigureRow("D7", BodyRows::tips),
                new FigureRow("D8", BodyRows::drops),
                new FigureRow("D9", BodyRows::hits),
                new FigureRow("D10", BodyRows::dominoes),
                new FigureRow("D13", BodyRows::seeSaw),
                new FigureRow("D14", BodyRows::disc),
                new FigureRow("D15", BodyRows::gears),
                new FigureRow("D16", BodyRows::hook),
                new FigureRow("D18", BodyRows::heavyOnLight),
                new FigureRow("D19", BodyRows::thinPlank),
                new FigureRow("D21", BodyRows::slidesOverJoints),
                new FigureRow("D22", BodyRows::ballOnCrates));
    }

    /** Those that take longer. */
    static List<FigureRow> slow() {
        return List.of(
                new FigureRow("D2", BodyRows::stackOfTwenty),
                new FigureRow("D3", BodyRows::otherStacks),
                new FigureRow("D4", BodyRows::pyramid),
                new FigureRow("D11", BodyRows::circlesOnCrates),
                new FigureRow("D12", BodyRows::cratesOnPit),
                new FigureRow("D17", BodyRows::loadedPlanks),
                new FigureRow("D20", BodyRows::cardHouses),
                new FigureRow("D23", BodyRows::gas));
    }

    /** All, in the order of the page. */
    static List<FigureRow> all() {
        List<FigureRow> all = new ArrayList<>(quick());
        all.addAll(slow());
        all.sort((a, b) -> Integer.compare(number(a), number(b)));
        return all;
    }

    private static int number(FigureRow row) {
        return Integer.parseInt(row.name().substring(1));
    }

    private static RowFigure atMost(String row, String what, double box2d, double most, double world) {
        return new RowFigure(row, what, 0, box2d, -most, most, NONE, world);
    }

    /** A world of one thread with such scenes. */
    private static final class Scene implements AutoCloseable {
        final World world;
        final Bodies bodies;
        private final float dt;

        Scene(double friction, double restitution, double gravity, double dt) {
            this.dt = (float) dt;
            world = WorldScenes.jvm()
                    .bounds(-400, -400, 400, 400)
                    .gravity(0, (float) -gravity)
                    .friction((float) friction)
                    .restitution((float) restitution)
                    .threads(1)
                    .build();
            bodies = world.bodies();
        }

        static Scene onFloor(double friction, double restitution) {
            return new Scene(friction, restitution, 10, 1 / 60.0).floor(0);
        }

        static Scene free(double friction, double restitution) {
            return new Scene(friction, restitution, 0, 1 / 60.0);
        }

        /** A floor through the origin that rises to the right by an angle. */
        Scene floor(double angle) {
            float x = (float) (390 * Math.cos(angle));
            float y = (float) (390 * Math.sin(angle));
            world.terrain().addChain(Chain.of(x, y, -x, -y));
            return this;
        }

        /** Of terrain, by half extents. */
        void wall(double x, double y, double halfX, double halfY) {
            float left = (float) (x - halfX);
            float right = (float) (x + halfX);
            float low = (float) (y - halfY);
            float high = (float) (y + halfY);
            world.terrain()
                    .addChain(Chain.of(left, low, right, low, right, high, left, high)
                            .close());
        }

        long box(double x, double y, double angle, double halfX, double halfY, double rounding, double density) {
            Outline outline =
                    Outline.box((float) (2 * halfX), (float) (2 * halfY)).round((float) rounding);
            return bodies.add(outline, (float) x, (float) y, (float) angle, (float) (density * outline.area()));
        }

        long crate(double x, double y) {
            return box(x, y, 0, 0.5, 0.5, ROUNDING, 1);
        }

        long[] stack(int crates, double rounding) {
            long[] all = new long[crates];
            for (int k = 0; k < crates; k++) {
                all[k] = box(0, 0.5 + k, 0, 0.5, 0.5, rounding, 1);
            }
            return all;
        }

        long circle(double x, double y, double r, double density) {
            return world.add((float) x, (float) y, (float) r, (float) (density * Math.PI * r * r));
        }

        void run(int steps) {
            world.step(dt, steps);
        }

        double kinetic(long body) {
            double v2 = (double) bodies.vx(body) * bodies.vx(body) + (double) bodies.vy(body) * bodies.vy(body);
            double w = bodies.angularVelocity(body);
            return (bodies.mass(body) * v2 + bodies.inertia(body) * w * w) / 2;
        }

        /** Of all bodies and circles. */
        double kinetic() {
            double sum = 0;
            for (int id = 0; id < bodies.idLimit(); id++) {
                sum += kinetic(bodies.handle(id));
            }
            for (int id = 0; id < world.idLimit(); id++) {
                long c = world.handle(id);
                sum += 0.5 * world.mass(c) * (square(world.vx(c)) + square(world.vy(c)));
            }
            return sum;
        }

        double along(long body, double angle) {
            return bodies.x(body) * Math.cos(angle) + bodies.y(body) * Math.sin(angle);
        }

        @Override
        public void close() {
            world.close();
        }
    }

    private static double square(double x) {
        return x * x;
    }

    // ---- piles

    private static double drift(Scene scene, long... crates) {
        return Arrays.stream(crates)
                .mapToDouble(c -> Math.abs(scene.bodies.x(c)))
                .max()
                .orElseThrow();
    }

    private static List<RowFigure> stackOfTen() {
        try (Scene scene = Scene.onFloor(0.6, 0)) {
            long[] crates = scene.stack(10, ROUNDING);
            scene.run(3600);
            double sag = 9.5 - scene.bodies.y(crates[9]);
            return List.of(
                    atMost("D1", "a stack of 10, 60 s: sag, m", 0.029, 0.01, sag),
                    atMost("D1", "a stack of 10, 60 s: drift, m", NONE, 0.005, drift(scene, crates)));
        }
    }

    private static List<RowFigure> stackOfTwenty() {
        try (Scene scene = Scene.onFloor(0.6, 0)) {
            long[] crates = scene.stack(20, ROUNDING);
            scene.run(36_000);
            double sag = 19.5 - scene.bodies.y(crates[19]);
            return List.of(
                    atMost("D2", "a stack of 20, 600 s: sag, m", 0.12, 0.2, sag),
                    atMost("D2", "a stack of 20, 600 s: drift, m", NONE, 0.2, drift(scene, crates)));
        }
    }

    private static List<RowFigure> otherStacks() {
        return List.of(
                RowFigure.within("D3", "a stack of 15, rounding 0.2, 60 s: stands", 1, 1, 0, stands(15, 0.2, 60)),
                RowFigure.within(
                                "D3", "a stack of 15, steps of 1/30 s, 60 s: stands", 1, 1, 0, stands(15, ROUNDING, 30))
                        .notBelow(0),
                new RowFigure("D3", "a stack of 20, rounding 0.2, 60 s: stands", 1, 1, 0, 1, NONE, stands(20, 0.2, 60)),
                new RowFigure(
                        "D3",
                        "a stack of 20, steps of 1/30 s, 60 s: stands",
                        1,
                        1,
                        0,
                        1,
                        NONE,
                        stands(20, ROUNDING, 30)));
    }

    /** 1 if a stack stands after a minute of so many steps a second, else 0. */
    private static double stands(int crates, double rounding, int rate) {
        try (Scene scene = new Scene(0.6, 0, 10, 1.0 / rate).floor(0)) {
            long[] stack = scene.stack(crates, rounding);
            scene.run(60 * rate);
            return scene.bodies.y(stack[crates - 1]) > crates - 1 ? 1 : 0;
        }
    }

    private static List<RowFigure> pyramid() {
        try (Scene scene = Scene.onFloor(0.6, 0)) {
            List<long[]> rows = new ArrayList<>();
            for (int row = 0; row < 20; row++) {
                long[] crates = new long[20 - row];
                for (int k = 0; k < crates.length; k++) {
                    crates[k] = scene.crate(ofPyramid(row, k), 0.5 + row);
                }
                rows.add(crates);
            }
            scene.run(1200);
            double drift = 0;
            double sag = 0;
            for (int row = 0; row < 20; row++) {
                for (int k = 0; k < 20 - row; k++) {
                    long crate = rows.get(row)[k];
                    drift = Math.max(drift, Math.abs(scene.bodies.x(crate) - ofPyramid(row, k)));
                    sag = Math.max(sag, 0.5 + row - scene.bodies.y(crate));
                }
            }
            return List.of(
                    atMost("D4", "a pyramid of 20 rows, 20 s: drift, m", 0.010, 0.02, drift),
                    atMost("D4", "a pyramid of 20 rows, 20 s: sag, m", 0.030, 0.02, sag));
        }
    }

    private static double ofPyramid(int row, int k) {
        return (k - (19 - row) / 2.0) * 1.1;
    }

    private static List<RowFigure> loadedPlanks() {
        double underCrates;
        try (Scene scene = Scene.onFloor(0.6, 0)) {
            scene.box(0, 0.2, 0, 30, 0.2, 0.02, 1);
            for (int k = 0; k < 50; k++) {
                scene.crate(-29 + k * 1.15, 0.9);
            }
            scene.run(1200);
            underCrates = scene.kinetic();
        }
        try (Scene scene = Scene.onFloor(0.6, 0)) {
            scene.wall(-3, 0.5, 0.5, 0.5);
            scene.wall(3, 0.5, 0.5, 0.5);
            scene.wall(-4.3, 5, 0.1, 4);
            scene.wall(4.3, 5, 0.1, 4);
            scene.box(0, 1.15, 0, 4, 0.15, 0.02, 1);
            Random random = new Random(3);
            for (int k = 0; k < 300; k++) {
                double r = 0.1 + 0.02 * random.nextDouble();
                scene.circle(-3.8 + k % 30 * 0.26 + 0.02 * random.nextDouble(), 1.6 + k / 30 * 0.3, r, 1);
            }
            scene.run(900);
            return List.of(
                    atMost("D17", "a plank under 50 crates, 20 s: kinetic energy, J", 2e-11, 1e-9, underCrates),
                    atMost("D17", "a plank under 300 balls, 15 s: kinetic energy, J", 3e-4, 5e-3, scene.kinetic()));
        }
    }

    private static List<RowFigure> heavyOnLight() {
        List<RowFigure> figures = new ArrayList<>();
        double[] box2d = {0.039, 0.295};
        for (int crates = 1; crates <= 5; crates += 4) {
            try (Scene scene = Scene.onFloor(0.6, 0)) {
                scene.stack(crates, ROUNDING);
                long heavy = scene.box(0, 0.5 + crates, 0, 0.5, 0.5, ROUNDING, 100);
                scene.run(1200);
                String what = "a crate of 100 masses on " + crates + ": sag, m";
                figures.add(atMost("D18", what, box2d[crates / 5], 0.5, 0.5 + crates - scene.bodies.y(heavy)));
            }
        }
        return figures;
    }

    private static List<RowFigure> cardHouses() {
        int stand = 0;
        for (int house = 0; house < 10; house++) {
            stand += topOfCards(0.55 + 0.05 * house) > 2.2 ? 1 : 0;
        }
        String what = "card houses of 15, friction 0.55 to 1, 60 s: stand of 10";
        return List.of(new RowFigure("D20", what, 10, 10, 9, 10, 0, stand));
    }

    private static double topOfCards(double friction) {
        try (Scene scene = Scene.onFloor(friction, 0)) {
            double lean = 0.45;
            double thick = 0.02;
            double width = 2 * Math.sin(lean) + 0.03;
            double height = 2 * Math.cos(lean);
            double y = 0;
            long last = 0;
            for (int level = 0; level < 3; level++) {
                for (int k = 0; k < 3 - level; k++) {
                    double x = (k - (2 - level) / 2.0) * width;
                    for (int side = -1; side <= 1; side += 2) {
                        double at = x + side * (Math.sin(lean) * 0.5 + 0.012);
                        double high = y + height / 4 + thick * Math.sin(lean);
                        last = scene.box(at, high, side * lean, thick / 2, 0.5, 0.008, 1);
                    }
                }
                y += height / 2 + 2 * thick * Math.sin(lean) - 0.005;
                for (int k = 0; k < 2 - level; k++) {
                    last = scene.box((k - (1 - level) / 2.0) * width, y + thick / 2, 0, 0.5, thick / 2, 0.008, 1);
                }
                y += thick;
            }
            scene.run(3600);
            return scene.bodies.y(last);
        }
    }

    private static List<RowFigure> ballOnCrates() {
        List<RowFigure> figures = new ArrayList<>();
        int[] masses = {5, 20, 100};
        int[] box2d = {10, 10, 4};
        int[] least = {7, 0, 0};
        for (int k = 0; k < masses.length; k++) {
            int stand = 0;
            for (int shot = 0; shot < 10; shot++) {
                try (Scene scene = Scene.onFloor(0.6, 0)) {
                    long[] crates = scene.stack(3, ROUNDING);
                    scene.circle(-0.09 + 0.02 * shot, 6, 0.4, masses[k] / (Math.PI * 0.16));
                    scene.run(400);
                    stand += scene.bodies.y(crates[2]) > 2.3 ? 1 : 0;
                }
            }
            String what = "a ball of " + masses[k] + " masses falls from 3 m on three crates: stand of 10";
            figures.add(new RowFigure("D22", what, NONE, box2d[k], least[k], 10, 3, stand));
        }
        return figures;
    }

    // ---- friction

    private static List<RowFigure> slopes() {
        List<RowFigure> figures = new ArrayList<>();
        double[] frictions = {0.2, 0.5, 0.9};
        double[] box2d = {1.20, 1.10, 1.01};
        for (int k = 0; k < frictions.length; k++) {
            for (int side = -1; side <= 1; side += 2) {
                double friction = frictions[k];
                double angle = Math.atan(friction) + side * 0.005;
                try (Scene scene = new Scene(friction, 0, 10, 1 / 60.0).floor(angle)) {
                    double x = -0.25 * Math.sin(angle);
                    long box = scene.box(x, 0.25 * Math.cos(angle), angle, 0.5, 0.25, ROUNDING, 1);
                    scene.run(60);
                    double from = scene.along(box, angle);
                    double v = scene.bodies.vx(box) * Math.cos(angle) + scene.bodies.vy(box) * Math.sin(angle);
                    scene.run(240);
                    double way = scene.along(box, angle) - from;
                    double exact = 4 * v - 8 * 10 * (Math.sin(angle) - friction * Math.cos(angle));
                    String what = String.format(Locale.ROOT, "slope of friction %.1f, 5 mrad ", friction);
                    figures.add(
                            side < 0
                                    ? atMost("D5", what + "below its angle, 4 s: way, m", 1e-6, 1e-5, way)
                                    : RowFigure.share(
                                            "D5",
                                            what + "above its angle: way by the exact one",
                                            1,
                                            box2d[k],
                                            0.01,
                                            way / exact));
                }
            }
        }
        return figures;
    }

    private static List<RowFigure> slides() {
        List<RowFigure> figures = new ArrayList<>();
        double[] frictions = {0.2, 0.6};
        double[] box2d = {8.988, 2.987};
        for (int k = 0; k < frictions.length; k++) {
            try (Scene scene = Scene.onFloor(frictions[k], 0)) {
                long box = scene.box(0, 0.25, 0, 0.5, 0.25, ROUNDING, 1);
                scene.run(30);
                double from = scene.bodies.x(box);
                scene.bodies.setVelocity(box, 6, 0);
                scene.run(600);
                String what =
                        String.format(Locale.ROOT, "slides from 6 m/s to rest, friction %.1f: way, m", frictions[k]);
                double way = scene.bodies.x(box) - from;
                figures.add(RowFigure.share("D6", what, 36 / (20 * frictions[k]), box2d[k], 0.005, way));
            }
        }
        return figures;
    }

    private static List<RowFigure> tips() {
        List<RowFigure> figures = new ArrayList<>();
        for (int side = -1; side <= 1; side += 2) {
            double angle = Math.atan(0.25 / 0.9) + side * 0.01;
            try (Scene scene = new Scene(3, 0, 10, 1 / 60.0).floor(angle)) {
                long box = scene.box(-0.9 * Math.sin(angle), 0.9 * Math.cos(angle), angle, 0.3, 0.9, ROUNDING, 1);
                scene.run(240);
                double tips = scene.bodies.angle(box) - angle > 1 ? 1 : 0;
                String what =
                        "a slim box, 10 mrad " + (side < 0 ? "below" : "above") + " the angle at which it tips: tips";
                double exact = side < 0 ? 0 : 1;
                figures.add(RowFigure.within("D7", what, exact, exact, 0, tips));
            }
        }
        return figures;
    }

    private static List<RowFigure> disc() {
        double angle = 0.2;
        try (Scene scene = new Scene(1, 0, 10, 1 / 60.0).floor(angle)) {
            Outline disc = Outline.of(Chain.from(0.5f, 0).arcTo(0, 0, 2 * PI).close());
            float x = (float) (-0.5 * Math.sin(angle));
            long body = scene.bodies.add(disc, x, (float) (0.5 * Math.cos(angle)), 0, disc.area());
            scene.run(240);
            double exact = 0.5 * 10 * Math.sin(angle) * 16 / 1.5;
            String what = "a disc of arcs rolls down 0.2 rad, 4 s: way, m";
            return List.of(RowFigure.share("D14", what, exact, 10.688, 0.002, -scene.along(body, angle)));
        }
    }

    private static List<RowFigure> slidesOverJoints() {
        double overTiles = FAR;
        try (Scene scene = new Scene(0, 0, 10, 1 / 60.0)) {
            for (int k = 0; k < 60; k++) {
                scene.wall(k - 1, -0.5, 0.5, 0.5);
            }
            long box = scene.box(0, 0.3, 0, 0.4, 0.3, ROUNDING, 1);
            scene.run(60);
            scene.bodies.setVelocity(box, 4.7f, 0);
            for (int k = 0; k < 600; k++) {
                scene.run(1);
                overTiles = Math.min(overTiles, scene.bodies.vx(box));
            }
        }
        double overCrates = FAR;
        try (Scene scene = Scene.onFloor(0, 0)) {
            for (int k = 0; k < 12; k++) {
                scene.crate(k, 0.5);
            }
            scene.run(60);
            long box = scene.box(2, 1.3, 0, 0.4, 0.3, ROUNDING, 1);
            scene.run(120);
            scene.bodies.setVelocity(box, 3, 0);
            for (int k = 0; k < 140; k++) {
                scene.run(1);
                overCrates = Math.min(overCrates, scene.bodies.vx(box));
            }
        }
        double overLines;
        try (Scene scene = new Scene(0, 0, 10, 1 / 60.0)) {
            float[] flat = new float[2 * 81];
            for (int k = 0; k <= 80; k++) {
                flat[2 * k] = 80 - k;
            }
            scene.world.terrain().addChain(Chain.of(flat));
            long plank = scene.box(2, 0.1, 0, 0.5, 0.1, ROUNDING, 1);
            scene.run(60);
            scene.bodies.setVelocity(plank, 20, 0);
            scene.run(220);
            overLines = scene.bodies.vx(plank);
        }
        return List.of(
                RowFigure.share(
                        "D21",
                        "a plank slides over 73 joints of a flat chain: speed, m/s",
                        20,
                        Double.NaN,
                        0.001,
                        overLines),
                RowFigure.share("D21", "slides over 60 tiles: least speed, m/s", 4.7, -0.22, 0.01, overTiles),
                RowFigure.share("D21", "slides over 12 loose crates: least speed, m/s", 3, 0.68, 0.01, overCrates));
    }

    // ---- bounces and hits

    private static List<RowFigure> drops() {
        List<RowFigure> figures = new ArrayList<>();
        double[] restitutions = {1, 0.5};
        double[] box2d = {0.89, 0.82};
        for (int k = 0; k < restitutions.length; k++) {
            double e = restitutions[k];
            try (Scene scene = Scene.onFloor(0, e)) {
                long crate = scene.crate(0, 3.5);
                double high = 0;
                boolean up = false;
                for (int step = 0; step < 150 && !(up && scene.bodies.vy(crate) < 0); step++) {
                    scene.run(1);
                    up |= scene.bodies.vy(crate) > 0;
                    high = up ? Math.max(high, scene.bodies.y(crate)) : 0;
                }
                String what = String.format(Locale.ROOT, "falls flat from 3 m, e %.1f: ", e);
                double share = (high - 0.5) / (3 * e * e);
                figures.add(RowFigure.share("D8", what + "height by the exact one", 1, box2d[k], 0.02, share));
                figures.add(atMost("D8", what + "spin, rad/s", NONE, 1e-4, scene.bodies.angularVelocity(crate)));
            }
        }
        try (Scene scene = Scene.onFloor(0, 1)) {
            long crate = scene.box(0, 3.5, 0.4, 0.5, 0.5, ROUNDING, 1);
            double before = energy(scene, crate);
            scene.run(1200);
            String what = "falls on its corner, e 1: energy after 20 s";
            figures.add(RowFigure.share("D8", what, 1, 0.54, 0.01, energy(scene, crate) / before));
        }
        return figures;
    }

    private static double energy(Scene scene, long body) {
        return scene.kinetic(body) + scene.bodies.mass(body) * 10 * scene.bodies.y(body);
    }

    private static List<RowFigure> hits() {
        List<RowFigure> figures = new ArrayList<>();
        double[] box2d = {-1.1785, -2.3581};
        for (int e = 0; e <= 1; e++) {
            try (Scene scene = Scene.free(0, e)) {
                long box = scene.box(0, 0, 0, 1, 0.5, ROUNDING, 1);
                long circle = scene.circle(0.7, 3, 0.3, 2);
                scene.world.setVelocity(circle, 0, -4);
                for (int k = 0; k < 120 && scene.world.vy(circle) < -3.9; k++) {
                    scene.run(1);
                }
                double inertia = scene.bodies.inertia(box);
                double mass = 1.0 / scene.bodies.mass(box) + 1.0 / scene.world.mass(circle) + 0.49 / inertia;
                double exact = -0.7 * (1 + e) * 4 / mass / inertia;
                String what = "a circle hits a free box, e " + e + ": its spin, rad/s";
                double spin = scene.bodies.angularVelocity(box);
                figures.add(RowFigure.within("D9", what, exact, box2d[e], 1e-4, spin));
            }
        }
        try (Scene scene = Scene.free(0.5, 0.5)) {
            long box = scene.box(0, 0, 0.3, 1, 0.5, ROUNDING, 1);
            scene.bodies.setVelocity(box, 0.1f, 0);
            scene.bodies.setAngularVelocity(box, 3);
            long circle = scene.circle(0.7, 3, 0.3, 2);
            scene.world.setVelocity(circle, 0, -4);
            scene.world.setAngularVelocity(circle, 1);
            double[] before = momenta(scene);
            double error = 0;
            for (int k = 0; k < 240; k++) {
                scene.run(1);
                double[] now = momenta(scene);
                for (int m = 0; m < 3; m++) {
                    error = Math.max(error, Math.abs(now[m] - before[m]));
                }
            }
            figures.add(atMost("D9", "both spinning, friction 0.5: greatest error of momenta", 0.017, 1e-6, error));
        }
        return figures;
    }

    /** Along x and y, and angular about the origin. */
    private static double[] momenta(Scene scene) {
        double[] sum = new double[3];
        Bodies b = scene.bodies;
        for (int id = 0; id < b.idLimit(); id++) {
            long body = b.handle(id);
            add(sum, b.mass(body), b.x(body), b.y(body), b.vx(body), b.vy(body));
            sum[2] += (double) b.inertia(body) * b.angularVelocity(body);
        }
        World world = scene.world;
        for (int id = 0; id < world.idLimit(); id++) {
            long c = world.handle(id);
            add(sum, world.mass(c), world.x(c), world.y(c), world.vx(c), world.vy(c));
            sum[2] += 0.5 * world.mass(c) * square(world.radius(c)) * world.angularVelocity(c);
        }
        return sum;
    }

    private static void add(double[] sum, double m, double x, double y, double vx, double vy) {
        sum[0] += m * vx;
        sum[1] += m * vy;
        sum[2] += m * (x * vy - y * vx);
    }

    private static List<RowFigure> thinPlank() {
        try (Scene scene = Scene.free(0, 0)) {
            long plank = scene.box(0, 0, 0, 0.05, 1, 0.02, 1);
            long circle = scene.circle(-3.03, 0.9, 0.1, 1);
            scene.world.setVelocity(circle, 100, 0);
            scene.run(5);
            double mass = scene.bodies.mass(plank);
            double inverse = 1 / mass + 1.0 / scene.world.mass(circle) + 0.81 / scene.bodies.inertia(plank);
            String what = "a circle hits a free plank 0.1 thick at 100 m/s: its speed, m/s";
            return List.of(RowFigure.share("D19", what, 100 / inverse / mass, 0, 0.002, scene.bodies.vx(plank)));
        }
    }

    /** Each start goes another way: the mean of twelve. */
    private static List<RowFigure> gas() {
        double sum = 0;
        for (int seed = 1; seed <= 12; seed++) {
            sum += energyOfGas(new Random(seed));
        }
        String what = "36 boxes and 100 circles, e 1, 20 s: energy by the first, mean of 12";
        return List.of(new RowFigure("D23", what, 1, 0.74, 0.9, 1.1, 0.88, sum / 12));
    }

    private static double energyOfGas(Random random) {
        try (Scene scene = Scene.free(0, 1)) {
            scene.wall(0, -10.5, 11, 0.5);
            scene.wall(0, 10.5, 11, 0.5);
            scene.wall(-10.5, 0, 0.5, 11);
            scene.wall(10.5, 0, 0.5, 11);
            for (int k = 0; k < 36; k++) {
                double x = -8 + k % 6 * 3.2;
                double y = -8 + k / 6 * 3.2;
                long box = scene.box(x, y, 3 * random.nextDouble(), 0.5, 0.5, ROUNDING, 1);
                scene.bodies.setVelocity(box, speed(random), speed(random));
                scene.bodies.setAngularVelocity(box, 4 * random.nextFloat() - 2);
            }
            for (int k = 0; k < 100; k++) {
                long circle = scene.circle(-9.3 + k % 10 * 1.9, -6.4 + k / 10 * 1.6, 0.15, 1);
                scene.world.setVelocity(circle, speed(random), speed(random));
            }
            scene.run(1);
            double first = scene.kinetic();
            scene.run(1200);
            return scene.kinetic() / first;
        }
    }

    private static float speed(Random random) {
        return 6 * random.nextFloat() - 3;
    }

    // ---- games

    private static List<RowFigure> dominoes() {
        try (Scene scene = Scene.onFloor(0.6, 0)) {
            long[] all = new long[20];
            for (int k = 0; k < all.length; k++) {
                all[k] = scene.box(k * 0.6, 0.5, 0, 0.08, 0.5, 0.02, 1);
            }
            scene.run(120);
            scene.bodies.setVelocity(all[0], 1.25f, 0);
            scene.bodies.setAngularVelocity(all[0], -2.5f);
            int[] fell = new int[all.length];
            Arrays.fill(fell, -1);
            for (int step = 0; step < 600; step++) {
                scene.run(1);
                for (int k = 0; k < all.length; k++) {
                    fell[k] = fell[k] < 0 && scene.bodies.angle(all[k]) < -0.1 ? step : fell[k];
                }
            }
            double fallen = Arrays.stream(all)
                    .filter(each -> scene.bodies.angle(each) < -0.5)
                    .count();
            double wave = 14 * 0.6 / ((fell[19] - fell[5]) / 60.0);
            return List.of(
                    RowFigure.within("D10", "20 dominoes: fall", 20, 20, 0, fallen),
                    RowFigure.between("D10", "20 dominoes: wave, m/s", 2.88, 0.97 * 2.9, 1.03 * 2.9, wave));
        }
    }

    private static List<RowFigure> circlesOnCrates() {
        try (Scene scene = Scene.onFloor(0.6, 0)) {
            scene.wall(-7.5, 10, 0.5, 20);
            scene.wall(7.5, 10, 0.5, 20);
            long[] crates = new long[10];
            for (int k = 0; k < crates.length; k++) {
                crates[k] = scene.box(-5.5 + k % 5 * 2.6, 1 + k / 5 * 2.2, 0, 0.9, 0.9, ROUNDING, 1);
            }
            Random random = new Random(7);
            long[] circles = new long[1000];
            for (int k = 0; k < circles.length; k++) {
                double x = -6.5 + k % 40 * 0.33 + 0.02 * random.nextDouble();
                circles[k] = scene.circle(x, 6 + k / 40 * 0.4, 0.12 + 0.04 * random.nextDouble(), 1);
            }
            scene.run(900);
            double inside = 0;
            double fastest = 0;
            Bodies b = scene.bodies;
            for (long crate : crates) {
                fastest = Math.max(fastest, Math.hypot(b.vx(crate), b.vy(crate)));
                double cos = Math.cos(b.angle(crate));
                double sin = Math.sin(b.angle(crate));
                for (long c : circles) {
                    double dx = scene.world.x(c) - b.x(crate);
                    double dy = scene.world.y(c) - b.y(crate);
                    inside += Math.abs(cos * dx + sin * dy) < 0.9 && Math.abs(cos * dy - sin * dx) < 0.9 ? 1 : 0;
                }
            }
            return List.of(
                    RowFigure.within("D11", "1,000 circles fall on 10 crates: centres inside a crate", 0, 0, 0, inside),
                    atMost("D11", "1,000 circles on 10 crates, 15 s: fastest crate, m/s", 6e-6, 1e-4, fastest));
        }
    }

    private static List<RowFigure> cratesOnPit() {
        double[] densities = {0.2, 1, 5};
        double[] box2d = {0.12, -0.42, -1.66};
        double[] bottoms = Arrays.stream(densities).map(BodyRows::bottomOnPit).toArray();
        List<RowFigure> figures = new ArrayList<>();
        for (int k = 0; k < densities.length; k++) {
            String what = String.format(
                    Locale.ROOT,
                    "a crate of 2 m and density %.1f on a pit of balls: bottom over the surface, m",
                    densities[k]);
            // asked is that a heavier one lies lower
            double least = k + 1 < densities.length ? bottoms[k + 1] : -3;
            double greatest = k > 0 ? bottoms[k - 1] : 0.5;
            figures.add(RowFigure.between("D12", what, box2d[k], least, greatest, bottoms[k]));
        }
        return figures;
    }

    private static double bottomOnPit(double density) {
        try (Scene scene = Scene.onFloor(0.3, 0)) {
            scene.wall(-5.5, 10, 0.5, 20);
            scene.wall(5.5, 10, 0.5, 20);
            Random random = new Random(7);
            for (int k = 0; k < 500; k++) {
                double r = 0.15 + 0.02 * random.nextDouble();
                scene.circle(-4.6 + k % 26 * 0.36 + 0.02 * random.nextDouble(), 0.3 + k / 26 * 0.36, r, 1);
            }
            scene.run(400);
            double middle = 0;
            for (int id = 0; id < 500; id++) {
                middle += scene.world.y(scene.world.handle(id)) / 500;
            }
            long crate = scene.box(0, 2 * middle + 1.6, 0, 1, 1, ROUNDING, density);
            scene.run(900);
            return scene.bodies.y(crate) - 1 - 2 * middle;
        }
    }

    private static List<RowFigure> seeSaw() {
        try (Scene scene = Scene.onFloor(0.8, 0)) {
            scene.world
                    .terrain()
                    .addChain(Chain.of(-0.6f, 0.02f, 0.6f, 0.02f, 0, 1.02f).close());
            long plank = scene.box(0, 1.1, 0, 3, 0.1, 0.02, 1);
            scene.box(-2, 1.5, 0, 0.3, 0.3, ROUNDING, 1);
            scene.box(1.95, 1.5, 0, 0.3, 0.3, ROUNDING, 1);
            scene.run(600);
            String what = "a see-saw, arms of 1.95 and 2 m: angle";
            return List.of(RowFigure.share("D13", what, 0.349, 0.349, 0.01, scene.bodies.angle(plank)));
        }
    }

    private static List<RowFigure> gears() {
        try (Scene scene = Scene.free(0.1, 0)) {
            int teeth = 12;
            double pitch = 2 * Math.PI / teeth;
            float[] points = new float[8 * teeth];
            for (int k = 0; k < 4 * teeth; k++) {
                double angle = pitch * (k / 4 + new double[] {-0.27, -0.13, 0.13, 0.27}[k % 4]);
                double r = k % 4 == 1 || k % 4 == 2 ? 1.74 : 1.4;
                points[2 * k] = (float) (r * Math.cos(angle));
                points[2 * k + 1] = (float) (r * Math.sin(angle));
            }
            Outline gear =
                    Outline.polygon(BodiesPhysicsTest.grown(points, 0.01)).round(0.01f);
            Bodies b = scene.bodies;
            long driver = b.add(gear, 0, 0, 0, 1e6f);
            long driven = b.add(gear, 3.22f, 0, (float) (PI + pitch / 2), 1e6f);
            b.setInertia(driver, 1.01e-3f * gear.inertia(1e6f));
            b.setInertia(driven, 1.01e-3f * gear.inertia(1e6f));
            double sum = 0;
            double lag = 0;
            float last = b.angle(driver);
            float lastDriven = b.angle(driven);
            for (int k = 0; k < 1200; k++) {
                b.setVelocity(driver, 0, 0);
                b.setVelocity(driven, 0, 0);
                b.setAngularVelocity(driver, 3);
                scene.run(1);
                sum += turn(last, b.angle(driver)) + turn(lastDriven, b.angle(driven));
                lag = Math.max(lag, Math.abs(sum));
                last = b.angle(driver);
                lastDriven = b.angle(driven);
            }
            String what = "gears of 12 teeth, 20 s: lag by a pitch of 0.52";
            return List.of(RowFigure.between("D15", what, 0.054, 0, 0.06, lag));
        }
    }

    private static double turn(float from, float to) {
        return Math.IEEEremainder((double) to - from, 2 * Math.PI);
    }

    private static List<RowFigure> hook() {
        try (Scene scene = new Scene(0.6, 0, 10, 1 / 60.0)) {
            scene.wall(0, 5, 0.2, 0.2);
            Outline hook = Outline.polygon(0, 0, 1, 0, 1, 0.25f, 0.25f, 0.25f, 0.25f, 2, 0, 2)
                    .round(0.03f);
            scene.bodies.add(hook, 0.45f - hook.centroidX(), 5.6f - hook.centroidY(), PI, hook.area());
            scene.run(900);
            return List.of(atMost("D16", "an L hangs on a peg, 15 s: kinetic energy, J", NONE, 1e-9, scene.kinetic()));
        }
    }
}
