package io.github.circles2d;

import static io.github.circles2d.TerrainBall.G;

import java.util.ArrayList;
import java.util.List;

/** The scenes of many joints. */
final class JointNets {
    private static final double NONE = Double.NaN;

    private JointNets() {}

    static List<FigureRow> all() {
        return List.of(
                new FigureRow("C2", () -> chain("C2", 100, 1, false, false, 6.77637, 3.68647, 7.8, 4.7)),
                new FigureRow("C2b", () -> chain("C2b", 100, 100, false, false, 20.4349, 13.2904, 22.4, 15.3)),
                new FigureRow("C2c", () -> chain("C2c", 100, 100, true, false, 42.3053, NONE, 45, NONE)),
                new FigureRow("C2d", () -> chain("C2d", 100, 100, false, true, 0.000648499, 0.000524521, 0.1, 0.1)),
                new FigureRow("C2e", () -> chain("C2e", 20, 1, true, false, 4.85315, NONE, 6.9, NONE)),
                new FigureRow("C2f", () -> chain("C2f", 20, 10, true, false, 9.81657, NONE, 11.8, NONE)),
                new FigureRow("C2g", () -> chain("C2g", 20, 100, true, false, 32.8908, NONE, 34.9, NONE)),
                new FigureRow("C2h", () -> chain("C2h", 20, 100, true, true, 2.82914, NONE, 4, NONE)),
                new FigureRow("C3", () -> bridge("C3", false, 2.88817, 1.49313, 0.499111)),
                new FigureRow("C3b", () -> bridge("C3b", true, 7.04995, 2.45341, 1.3182)),
                new FigureRow("C8", JointNets::ring),
                new FigureRow("C12, 12", () -> hub(12, 0.0620452, 2397.47)),
                new FigureRow("C12, 20", () -> hub(20, 0.0687779, 3995.84)),
                new FigureRow("C12, 40", () -> hub(40, 0.0863514, 7992.07)),
                new FigureRow("C12, 80", () -> hub(80, 76.296, 1.38057e6)),
                new FigureRow("C12, 150", () -> hub(150, 128.89, 6.20425e6)),
                new FigureRow("C12, 300", () -> hub(300, 295.599, 1.18374e7)));
    }

    /** A chain of links of 0.2 m, which hangs, or starts level; a rope joint may hold its end, too. */
    private static List<RowFigure> chain(
            String row,
            int links,
            double end,
            boolean swings,
            boolean rope,
            double box2dGreatest,
            double box2dLast,
            double most,
            double mostAtLast) {
        double link = 0.2;
        try (JointScene scene = new JointScene(G)) {
            long[] balls = new long[links];
            for (int i = 0; i < links; i++) {
                double s = (i + 1) * link;
                balls[i] = scene.alone(swings ? s : 0, swings ? 0 : -s, 0.08, i == links - 1 ? end : 1);
                Joint joint = Joint.distance((float) link);
                if (i == 0) {
                    scene.hold(balls[i], 0, 0, joint);
                } else {
                    scene.hold(balls[i - 1], balls[i], joint);
                }
            }
            if (rope) {
                scene.hold(balls[links - 1], 0, 0, Joint.rope((float) (links * link)));
            }
            double greatest = 0;
            double last = 0;
            for (int step = 0; step < 1200; step++) {
                scene.step(1);
                last = scene.distance(balls[0], 0, 0);
                for (int i = 1; i < links; i++) {
                    last += scene.distance(balls[i], balls[i - 1]);
                }
                greatest = Math.max(greatest, last);
            }
            String what = (swings ? "chain of " + links + " links swings" : "chain of " + links + " links hangs")
                    + (end == 1 ? "" : String.format(", end of %.0f masses", end))
                    + (rope ? ", rope at the end" : "");
            List<RowFigure> figures = new ArrayList<>();
            figures.add(stretch(row, what + ": greatest stretch, %", box2dGreatest, most, greatest / (links * link)));
            if (!swings) {
                figures.add(stretch(row, what + ": after 20 s, %", box2dLast, mostAtLast, last / (links * link)));
            }
            return figures;
        }
    }

    private static RowFigure stretch(String row, String what, double box2d, double most, double relative) {
        return JointRows.atMost(row, what, box2d, most, 100 * (relative - 1));
    }

    /** A bridge of 40 balls, and perhaps a ball of 50 masses on it. */
    private static List<RowFigure> bridge(
            String row, boolean loaded, double box2dWorst, double box2dSag, double box2dSpeed) {
        double link = 0.5;
        try (JointScene scene = new JointScene(G)) {
            long[] balls = new long[40];
            for (int i = 0; i < balls.length; i++) {
                balls[i] = scene.ball((i + 1) * link, 0, 0.25, 1);
                if (i == 0) {
                    scene.hold(balls[i], 0, 0, Joint.distance((float) link));
                } else {
                    scene.hold(balls[i - 1], balls[i], Joint.distance((float) link));
                }
            }
            scene.hold(balls[39], 41 * link, 0, Joint.distance((float) link));
            long heavy = loaded ? scene.ball(20 * link, 2, 1, 50) : -1;
            double worst = 0;
            for (int step = 0; step < 1200; step++) {
                scene.step(1);
                for (int i = 1; i < balls.length && step > 600; i++) {
                    worst = Math.max(worst, scene.distance(balls[i], balls[i - 1]) / link - 1);
                }
            }
            String what = loaded ? "bridge of 40 with a ball of 50 masses: " : "bridge of 40: ";
            double sag = -scene.y(balls[20]);
            List<RowFigure> figures = new ArrayList<>();
            figures.add(stretch(row, what + "worst link after 10 s, %", box2dWorst, loaded ? 10 : 4, worst + 1));
            figures.add(RowFigure.between(row, what + "sag, m", box2dSag, 0, loaded ? 3 : 2, sag));
            if (loaded) {
                double height = scene.y(heavy);
                figures.add(RowFigure.between(row, what + "height of the ball, m", -1.27452, -2, 0, height));
            }
            figures.add(RowFigure.between(
                    row, what + "mean speed after 20 s, m/s", box2dSpeed, 0, 2 * box2dSpeed, scene.meanSpeed(balls)));
            return figures;
        }
    }

    /** A soft ring of 24 on a floor: springs to the next two of each ball, and across. */
    private static List<RowFigure> ring() {
        int n = 24;
        double radius = 2;
        try (JointScene scene = new JointScene(G)) {
            TerrainBall.ground(scene.world, false, 50, 0, -50, 0);
            long[] balls = new long[n];
            for (int i = 0; i < n; i++) {
                double a = 2 * Math.PI * i / n;
                balls[i] = scene.ball(radius * Math.cos(a), 4 + radius * Math.sin(a), 0.24, 1);
            }
            for (int i = 0; i < n; i++) {
                for (int to = 1; to <= 2; to++) {
                    float length = (float) (2 * radius * Math.sin(to * Math.PI / n));
                    scene.hold(
                            balls[i],
                            balls[(i + to) % n],
                            Joint.spring(10, 0.7f).withLength(length));
                }
                if (i < n / 2) {
                    float length = (float) (2 * radius);
                    scene.hold(balls[i], balls[i + n / 2], Joint.spring(4, 0.7f).withLength(length));
                }
            }
            double first = area(scene, balls);
            double least = first;
            for (int step = 0; step < 1200; step++) {
                scene.step(1);
                least = Math.min(least, area(scene, balls));
            }
            double last = area(scene, balls);
            String what = "soft ring of 24: ";
            return List.of(
                    RowFigure.between("C8", what + "least area, %", 86.6949, 80, 101, 100 * least / first),
                    RowFigure.between("C8", what + "area after 20 s, %", 95.5204, 90, 101, 100 * last / first),
                    new RowFigure(
                            "C8",
                            what + "mean speed after 20 s, m/s",
                            0,
                            0.083547,
                            0,
                            0.1,
                            NONE,
                            scene.meanSpeed(balls)));
        }
    }

    private static double area(JointScene scene, long[] balls) {
        double sum = 0;
        for (int i = 0; i < balls.length; i++) {
            long next = balls[(i + 1) % balls.length];
            sum += 0.5 * (scene.x(balls[i]) * scene.y(next) - scene.x(next) * scene.y(balls[i]));
        }
        return sum;
    }

    /** A hub with spokes of 5 m turns; a tension of 80 N in each. */
    private static List<RowFigure> hub(int spokes, double box2dWorst, double box2dEnergy) {
        double radius = 5;
        double omega = 4;
        try (JointScene scene = new JointScene(0)) {
            long hub = scene.alone(0, 0, 1, 10);
            long[] rim = new long[spokes];
            for (int i = 0; i < spokes; i++) {
                double a = 2 * Math.PI * i / spokes;
                double c = Math.cos(a);
                double s = Math.sin(a);
                rim[i] = scene.alone(radius * c, radius * s, 0.04, 1);
                scene.world.setVelocity(rim[i], (float) (-omega * radius * s), (float) (omega * radius * c));
                scene.hold(hub, rim[i], Joint.distance((float) radius));
            }
            double worst = 0;
            for (int step = 0; step < 600; step++) {
                scene.step(1);
                for (long ball : rim) {
                    worst = Math.max(worst, Math.abs(scene.distance(hub, ball) / radius - 1));
                }
            }
            double energy = 0;
            for (long ball : rim) {
                energy += 0.5 * scene.speed(ball) * scene.speed(ball);
            }
            double exact = 0.5 * spokes * omega * omega * radius * radius;
            String what = "hub with " + spokes + " spokes at 4 rad/s: ";
            return List.of(
                    RowFigure.within(
                            "C12", what + "worst spoke in 10 s, %", 0, box2dWorst, spokes > 40 ? 1 : 0.2, 100 * worst),
                    new RowFigure(
                            "C12",
                            what + "energy of the rim, J",
                            exact,
                            box2dEnergy,
                            0.98 * exact,
                            1.001 * exact,
                            NONE,
                            energy));
        }
    }
}
