package io.github.circles2d;

import static io.github.circles2d.TerrainBall.DT;
import static io.github.circles2d.TerrainBall.G;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The scenes of a few discs with joints; {@link JointNets} has those of many. Exact are joints that do not give. */
final class JointRows {
    private static final double NONE = Double.NaN;

    private JointRows() {}

    static List<FigureRow> all() {
        return List.of(
                new FigureRow("C1", JointRows::pendulums),
                new FigureRow("C4", JointRows::springs),
                new FigureRow("C5", JointRows::ropes),
                new FigureRow("C6", JointRows::mouse),
                new FigureRow("C7", JointRows::motors),
                new FigureRow("C13", JointRows::heavyOnLight));
    }

    /** A figure that is to be 0, and may be less. */
    static RowFigure atMost(String row, String what, double box2d, double most, double world) {
        return new RowFigure(row, what, 0, box2d, -1, most, NONE, world);
    }

    // ---- pendulums

    private static List<RowFigure> pendulums() {
        List<RowFigure> figures = new ArrayList<>();
        figures.addAll(pendulum("C1", 10, 1.001907, 2.81533, -0.231478, 0.00405086));
        figures.addAll(pendulum("C1b", 90, 1.180341, 3.31669, -0.169268, 0.0377716));
        return figures;
    }

    /** A disc on a rod of 2 m. */
    private static List<RowFigure> pendulum(
            String row, double degrees, double series, double box2dPeriod, double box2dEnergy, double box2dLength) {
        double length = 2;
        double angle = Math.toRadians(degrees);
        try (JointScene scene = new JointScene(G)) {
            long ball = scene.ball(length * Math.sin(angle), -length * Math.cos(angle), 0.1, 1);
            scene.hold(ball, 0, 0, Joint.distance((float) length));
            double first = G * scene.y(ball);
            double top = -length;
            double stretch = 0;
            Crossings crossings = new Crossings(scene.x(ball));
            for (int step = 1; step <= 3600; step++) {
                scene.step(1);
                crossings.look(scene.x(ball), step);
                stretch = Math.max(stretch, Math.abs(scene.distance(ball, 0, 0) - length));
                top = step > 3360 ? Math.max(top, scene.y(ball)) : top;
            }
            String what = String.format(Locale.ROOT, "pendulum of 2 m, %.0f degrees: ", degrees);
            double exact = 2 * Math.PI * Math.sqrt(length / G) * series;
            double energy = 100 * (top * G - first) / (first + G * length);
            return List.of(
                    RowFigure.share(row, what + "period, s", exact, box2dPeriod, 0.001, crossings.period()),
                    RowFigure.within(row, what + "change of energy in 60 s, %", 0, box2dEnergy, 1, energy),
                    RowFigure.within(
                            row,
                            what + "greatest error of its length, %",
                            0,
                            box2dLength,
                            0.1,
                            100 * stretch / length));
        }
    }

    /** The times at which a number comes down through 0. */
    private static final class Crossings {
        private double before;
        private double first = Double.NaN;
        private double last;
        private int periods = -1;

        Crossings(double start) {
            before = start;
        }

        void look(double now, int step) {
            if (before > 0 && now <= 0) {
                last = (step - now / (now - before)) * DT;
                first = Double.isNaN(first) ? last : first;
                periods++;
            }
            before = now;
        }

        double period() {
            return (last - first) / periods;
        }
    }

    // ---- springs

    private static List<RowFigure> springs() {
        List<RowFigure> figures = new ArrayList<>();
        figures.addAll(spring(0.5, 0.499961, 45.7805));
        figures.addAll(spring(1, 0.999686, 20.9596));
        figures.addAll(spring(2, 1.9975, 4.38993));
        figures.addAll(spring(5, 4.96151, 0.0404119));
        figures.addAll(spring(10, 9.76756, NONE));
        figures.addAll(spring(20, 17.528, NONE));
        return figures;
    }

    /** A disc of 3 kg on a spring that is not damped. */
    private static List<RowFigure> spring(double frequency, double box2dFrequency, double box2dAmplitude) {
        try (JointScene scene = new JointScene(0)) {
            long ball = scene.ball(2.5, 0, 0.1, 3);
            scene.hold(ball, 0, 0, Joint.spring((float) frequency, 0).withLength(2));
            Crossings crossings = new Crossings(0.5);
            double amplitude = 0;
            double period = 1 / frequency;
            for (int step = 1; step * DT < 10.6 * period + 1 && crossings.periods < 10; step++) {
                scene.step(1);
                double x = scene.x(ball) - 2;
                crossings.look(x, step);
                boolean tenth = step * DT > 9.5 * period && step * DT < 10.5 * period;
                amplitude = tenth ? Math.max(amplitude, Math.abs(x)) : amplitude;
            }
            String what = String.format(Locale.ROOT, "spring of %.1f Hz, not damped: ", frequency);
            List<RowFigure> figures = new ArrayList<>();
            figures.add(RowFigure.share(
                    "C4", what + "frequency, Hz", frequency, box2dFrequency, 0.01, 1 / crossings.period()));
            if (frequency <= 5) {
                figures.add(new RowFigure(
                        "C4",
                        what + "amplitude after ten periods, %",
                        100,
                        box2dAmplitude,
                        95,
                        101,
                        NONE,
                        200 * amplitude));
            }
            return figures;
        }
    }

    // ---- ropes

    private static List<RowFigure> ropes() {
        List<RowFigure> figures = new ArrayList<>(caught());
        try (JointScene scene = new JointScene(G)) {
            long ball = scene.ball(2, -0.5, 0.1, 1);
            scene.hold(ball, 0, 0, Joint.rope(3));
            scene.world.setVelocity(ball, 6, 0);
            double longest = 0;
            for (int step = 0; step < 1200; step++) {
                scene.step(1);
                longest = Math.max(longest, scene.distance(ball, 0, 0));
            }
            double over = 100 * (longest / 3 - 1);
            figures.add(atMost("C5b", "rope of 3 m, thrown across: longer by, %", 0.0204682, 0.1, over));
        }
        return figures;
    }

    private static List<RowFigure> caught() {
        try (JointScene scene = new JointScene(G)) {
            long ball = scene.ball(0, 0, 0.1, 1);
            scene.hold(ball, 0, 0, Joint.rope(3));
            double longest = 0;
            double rebound = -9;
            boolean taut = false;
            for (int step = 0; step < 300; step++) {
                scene.step(1);
                double length = scene.distance(ball, 0, 0);
                longest = Math.max(longest, length);
                taut |= length > 2.99;
                rebound = taut ? Math.max(rebound, scene.vy(ball)) : rebound;
            }
            String what = "rope of 3 m catches a ball that falls: ";
            return List.of(
                    atMost("C5", what + "longer by, %", 0.00234445, 0.1, 100 * (longest / 3 - 1)),
                    RowFigure.within("C5", what + "speed of the rebound, m/s", 0, 2.91038e-11, 0.01, rebound),
                    RowFigure.share("C5", what + "length at rest, m", 3, 3.00007, 0.001, scene.distance(ball, 0, 0)));
        }
    }

    // ---- pins and motors

    private static List<RowFigure> mouse() {
        try (JointScene scene = new JointScene(G)) {
            long ball = scene.ball(0, 0, 0.5, 1);
            long mouse = scene.hold(ball, 0, 0, Joint.mouse(7.5f, 1, (float) (100 * G)));
            scene.step(300);
            double omega = 2 * Math.PI * 7.5;
            double sag = -scene.y(ball);
            scene.world.joints().setAnchor(mouse, 1, 0);
            double near = Double.NaN;
            double farthest = 0;
            for (int step = 1; step <= 60; step++) {
                scene.step(1);
                near = Double.isNaN(near) && scene.x(ball) > 0.99 ? step * DT : near;
                farthest = Math.max(farthest, scene.x(ball));
            }
            String what = "mouse of 7.5 Hz: ";
            double time = 6.638 / omega;
            return List.of(
                    RowFigure.share("C6", what + "sag, m", G / (omega * omega), 0.00450316, 0.01, sag),
                    new RowFigure("C6", what + "moves 1 m, within 1 % after, s", time, 0.183333, 0, 0.2, NONE, near),
                    new RowFigure("C6", what + "overshoots by, %", 0, 0, -1, 1, NONE, 100 * (farthest - 1)));
        }
    }

    private static List<RowFigure> motors() {
        List<RowFigure> figures = new ArrayList<>();
        try (JointScene scene = new JointScene(0)) {
            long ball = scene.ball(0, 0, 0.5, 2);
            scene.world.joints().add(ball, Joint.motor(20, 1));
            double time = Double.NaN;
            for (int step = 1; step <= 600; step++) {
                scene.step(1);
                time = Double.isNaN(time) && scene.world.angularVelocity(ball) > 19.99 ? step * DT : time;
            }
            double omega = scene.world.angularVelocity(ball);
            String what = "motor of 1 N m, inertia 0.25, to 20 rad/s: ";
            figures.add(RowFigure.within("C7", what + "time, s", 5, 5, DT + 1e-6, time));
            figures.add(RowFigure.share("C7", what + "speed, rad/s", 20, 20, 0.001, omega));
        }
        figures.add(drivenCart());
        return figures;
    }

    /** A torque on one of two discs that roll and keep their distance. */
    private static RowFigure drivenCart() {
        try (JointScene scene = new JointScene(G)) {
            TerrainBall.ground(scene.world, false, 500, 0, -50, 0);
            long driven = scene.ball(0, 0.5, 0.5, 1);
            long other = scene.ball(2, 0.5, 0.5, 1);
            scene.hold(driven, other, Joint.distance(2));
            for (int step = 0; step < 120; step++) {
                scene.world.applyTorque(driven, -1.5f);
                scene.step(1);
            }
            return RowFigure.share(
                    "C7b",
                    "two discs joined, 1.5 N m on one: acceleration, m/s2",
                    1.5 / (0.5 * 3),
                    0.994115,
                    0.01,
                    scene.vx(driven) / 2);
        }
    }

    private static List<RowFigure> heavyOnLight() {
        try (JointScene scene = new JointScene(G)) {
            long light = scene.ball(0, -1, 0.1, 0.1);
            long heavy = scene.ball(0, -2, 0.5, 100);
            scene.hold(light, 0, 0, Joint.distance(1));
            scene.hold(light, heavy, Joint.distance(1));
            scene.step(600);
            double stretch = 100 * (-scene.y(heavy) / 2 - 1);
            return List.of(atMost("C13", "the world, 0.1 kg, 100 kg: stretch, %", 7.09416, 10, stretch));
        }
    }
}
