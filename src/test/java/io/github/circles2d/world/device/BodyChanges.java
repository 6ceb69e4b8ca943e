package io.github.circles2d.world.device;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.bodies.RigidTouches;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.joints.JointEnds;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.terrain.ChainPath;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** The calls that each simulation of a comparison gets: bodies that are pushed among circles of several sizes, and what happens to them. */
final class BodyChanges {
    /** A kind of what all others sense. */
    private static final int SENSED = 3;

    private final Simulation simulation;
    private final int atFirst;
    private final SplittableRandom random = new SplittableRandom(7);
    private final List<Long> bodies = new ArrayList<>();
    private final List<Long> circles = new ArrayList<>();
    private int sensed;

    /** So many circles are there at first. */
    BodyChanges(Simulation simulation, int atFirst) {
        this.simulation = simulation;
        this.atFirst = atFirst;
    }

    Simulation simulation() {
        return simulation;
    }

    /** What comes before a step. */
    void change(int step) {
        if (step == 0) {
            addCircles(atFirst);
            addBodies(6);
            join();
            simulation.kinds.setSetting(SENSED, 0, KindTable.RESPONSE + PairTable.SENSE);
            simulation.kinds.setSetting(SENSED, SENSED, KindTable.RESPONSE + PairTable.SENSE);
            simulation.rigidReads.report(true);
        } else if (step == 22) {
            circles.forEach(simulation.circles::remove);
            circles.clear();
        } else if (step == 26) {
            addCircles(atFirst / 2);
        } else if (step == 30) {
            addCrowd();
        }
        if (!circles.isEmpty() && step % 3 == 1) {
            long fast = circles.get(random.nextInt(circles.size()));
            simulation.circles.set(Commands.VELOCITY, fast, between(-400, 400), between(-400, 400));
        }
        long body = bodies.get(random.nextInt(bodies.size()));
        switch (step % 5) {
            case 1 -> simulation.rigids.applyImpulse(body, between(-9, 9), between(-9, 9));
            case 2 ->
                simulation.calls.changeByFloats(
                        Call.RIGID_FORCE, body, between(-90, 90), between(-90, 90), between(-9, 9), 0);
            case 3 ->
                simulation.calls.changeByFloats(
                        Call.TELEPORT_RIGID, body, between(2, 10), between(2, 10), between(-3, 3), 0);
            case 4 -> addBodies(1);
            default -> {}
        }
    }

    private void addCircles(int n) {
        for (int k = 0; k < n; k++) {
            float r = k % 5 == 0 ? 0.5f : between(0.08f, 0.2f);
            float mass = k % 23 == 3 ? Float.POSITIVE_INFINITY : r * r;
            circles.add(simulation.newCircles.add(
                    between(1, 11), between(1, 11), r, mass, between(-4, 4), between(-4, 4), k % 11 == 5 ? SENSED : 0));
        }
    }

    private void addCrowd() {
        for (int k = 0; k < 90; k++) {
            circles.add(simulation.newCircles.add(6 + 1e-3f * k, 6, 0.2f, 0.1f, 0, 0, 0));
        }
    }

    private void addBodies(int n) {
        for (int k = 0; k < n; k++) {
            bodies.add(simulation.rigids.add(
                    box(between(0.4f, 2), between(0.3f, 1)),
                    between(2, 10),
                    between(2, 10),
                    between(-3, 3),
                    between(0.2f, 5),
                    bodies.size() == 5 ? SENSED : 0));
        }
    }

    /** A hinge at the world, and rods and pins between bodies, and bodies and circles. */
    private void join() {
        JointForm rod = new JointForm(JointRow.AXIAL | JointRow.RIGID);
        JointForm pin = new JointForm(JointRow.POINT | JointRow.RIGID);
        simulation.joints.add(JointEnds.RIGID, bodies.get(0), 0.1f, 0, JointEnds.RIGID, bodies.get(1), 0, 0.1f, rod);
        for (int k = 3; k < 5; k++) { // a cart, and a rope
            JointForm form = k == 3 ? pin : rod;
            simulation.joints.add(
                    JointEnds.RIGID, bodies.get(3), 0.4f, 0, JointEnds.CIRCLE, circles.get(k), 0, 0, form);
            simulation.joints.add(
                    JointEnds.CIRCLE, circles.get(k + 2), 0, 0, JointEnds.RIGID, bodies.get(k), 0, 0, rod);
        }
        simulation.joints.add(
                JointEnds.RIGID, bodies.get(2), 0.1f, 0, JointEnds.ANCHOR, simulation.bodies.ground(), 6, 6, pin);
    }

    /** Adds boxes, one below the other, that hang at each other. */
    static void addChain(Simulation simulation, int boxes) {
        JointForm pin = new JointForm(JointRow.POINT | JointRow.RIGID);
        long before = 0;
        for (int k = 0; k < boxes; k++) {
            long box = simulation.rigids.add(box(0.4f, 1), 6, 9 - k, 0.1f * k, 1, 0);
            if (k > 0) {
                simulation.joints.add(JointEnds.RIGID, before, 0, -0.5f, JointEnds.RIGID, box, 0, 0.5f, pin);
            }
            before = box;
        }
    }

    static OutlineShape box(float width, float height) {
        ChainPath path = new ChainPath(0, 0);
        path.lineTo(width, 0);
        path.lineTo(width, height);
        path.lineTo(0, height);
        path.close();
        return OutlineShape.of(path, Float.NaN);
    }

    private float between(float from, float to) {
        return from + (to - from) * (float) random.nextDouble();
    }

    /** What bodies have begun and ended to touch since the last time. */
    List<String> touches() {
        List<String> lines = touches(simulation);
        for (String line : lines) {
            sensed += line.startsWith("true") && line.contains(" impulse 0.0 ") ? 1 : 0;
        }
        return lines;
    }

    static List<String> touches(Simulation simulation) {
        RigidTouches touches = new RigidTouches();
        simulation.rigidReads.take(touches);
        List<String> lines = new ArrayList<>();
        for (int k = 0; k < touches.count(); k++) {
            StringBuilder line = new StringBuilder();
            line.append(touches.begins(k)).append(' ').append(touches.type(k));
            line.append(' ').append(touches.body(k)).append(' ').append(touches.other(k));
            for (int value = 0; value < RigidStep.TOUCH_VALUES; value++) {
                line.append(value == RigidStep.TOUCH_IMPULSE ? " impulse " : " ");
                line.append(touches.value(k, value));
            }
            lines.add(line.toString());
        }
        return lines;
    }

    /** How many touches have begun without an impulse. */
    int sensed() {
        return sensed;
    }

    float[] poses() {
        float[] poses = new float[3 * simulation.rigidIds.limit()];
        simulation.rigidReads.readById(poses, null);
        return poses;
    }
}
