package io.github.circles2d.world.device;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.joints.JointEnds;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.shared.Call;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/** The calls that each simulation of a comparison gets: circles and bodies that come to rest upon each other, and what wakes some of them. */
final class SleepingBodies {
    /** Disturbances of {@link #disturb}. */
    static final int DISTURBANCES = 24;

    private static final float WIDTH = 12;

    private final Simulation simulation;
    private final SplittableRandom random;
    private final List<Long> bodies = new ArrayList<>();
    private final List<Long> circles = new ArrayList<>();
    private long lift;
    private long rod;
    private int mostSleepers;
    private int mostSleepingBodies;

    SleepingBodies(Simulation simulation, int seed) {
        this.simulation = simulation;
        random = new SplittableRandom(seed);
        simulation.rigidReads.report(seed % 2 == 1);
        simulation.reports.report(seed % 4 == 3 ? ContactEvents.ALL : 0);
    }

    /** The same world elsewhere. */
    SleepingBodies goOn(Simulation elsewhere) {
        SleepingBodies next = new SleepingBodies(elsewhere, 0);
        next.restore(snapshot());
        next.bodies.addAll(bodies);
        next.circles.addAll(circles);
        next.lift = lift;
        next.rod = rod;
        return next;
    }

    Simulation simulation() {
        return simulation;
    }

    /** Balls between crates, on crates and below planks, beside a shelf and a lift. */
    void fill() {
        simulation.kinds.set(KindField.FRICTION, 0, Float.floatToRawIntBits(0.6f));
        simulation.kinds.set(KindField.ROLLING_RESISTANCE, 0, Float.floatToRawIntBits(0.05f));
        simulation.kinds.setSetting(2, 0, KindTable.RESPONSE + PairTable.SENSE);
        lift = simulation.bodies.add(6.5f, 0.1f, 0);
        simulation.pieces.addSegment(lift, 0, -0.8f, 0, 0.8f, 0, 0);
        simulation.pieces.addSegment(simulation.bodies.ground(), 0, 0, 2.5f, 1.5f, 2.5f, 0);
        for (int k = 0; k < 16; k++) {
            circle(0.4f + 0.45f * k, 0.2f + 0.3f * (k % 2), 0.2f, 0);
        }
        circle(0.5f, 2.7f, 0.2f, 0);
        circle(4, 0.3f, 0.3f, Float.POSITIVE_INFINITY);
        body(1.6f, 0.2f, 1.4f, 1);
        body(0.5f, 0.5f, 3, 1.2f);
        body(0.5f, 0.5f, 5, 1.2f);
        body(2, 0.2f, 4, 1.8f);
        body(0.6f, 0.4f, 6.5f, 0.9f);
        body(0.4f, 0.4f, 1.1f, 2.75f);
        body(0.8f, 0.3f, WIDTH - 0.1f, 0.3f); // across the seam, if there is one
        circle(WIDTH - 0.3f, 0.9f, 0.2f, 0);
        circle(4, 2.3f, 0.25f, 0);
        JointForm pin = new JointForm(JointRow.POINT | JointRow.RIGID);
        long first = body(0.4f, 0.2f, 2.4f, 3);
        long other = body(0.4f, 0.2f, 2.8f, 3);
        simulation.joints.add(JointEnds.RIGID, first, 0.2f, 0, JointEnds.RIGID, other, -0.2f, 0, pin);
        long cart = body(0.8f, 0.2f, 7, 2);
        rod = simulation.joints.add(
                JointEnds.RIGID, cart, 0.3f, 0, JointEnds.CIRCLE, circle(7.3f, 2.4f, 0.15f, 0), 0, 0, pin);
    }

    private long circle(float x, float y, float r, float mass) {
        long circle = simulation.newCircles.add(x, y, r, mass == 0 ? r * r : mass, 0, 0, 0);
        circles.add(circle);
        return circle;
    }

    private long body(float width, float height, float x, float y) {
        long body = simulation.rigids.add(BodyChanges.box(width, height), x, y, 0, width * height, 0);
        bodies.add(body);
        return body;
    }

    /** Wakes some, or all, or changes something near to them. */
    void disturb(int which) {
        long circle = circles.get(random.nextInt(circles.size()));
        long body = bodies.get(random.nextInt(bodies.size()));
        float x = between(1, WIDTH - 1);
        switch (which) {
            case 0 -> simulation.circles.set(Commands.VELOCITY, circle, between(-3, 3), between(0, 3));
            case 1 -> simulation.rigids.applyImpulse(body, between(-1, 1), between(0, 1));
            case 2 -> body(between(0.3f, 1), between(0.2f, 0.5f), x, 5);
            case 3 -> circle(x, 5, between(0.1f, 0.3f), 0);
            case 4 -> {
                bodies.remove(body);
                simulation.calls.change(Call.REMOVE_RIGID, body);
                body(0.5f, 0.5f, x, 4);
            }
            case 5 -> {
                circles.remove(circle);
                simulation.circles.remove(circle);
            }
            case 6 -> simulation.circles.set(Commands.POSITION, circle, x, between(0.5f, 3));
            case 7 ->
                simulation.calls.changeByFloats(Call.TELEPORT_RIGID, body, x, between(0.5f, 3), between(-1, 1), 0);
            case 8 -> simulation.calls.makeOfFloats(Call.GRAVITY, between(-1, 1), -10, 0, 0);
            case 9 -> simulation.kinds.set(KindField.FRICTION, 0, Float.floatToRawIntBits(between(0.3f, 0.8f)));
            case 10 ->
                simulation.calls.changeByFloats(
                        Call.RIGID_LASTING_FORCE, body, between(-0.2f, 0.2f), between(-0.2f, 0.2f), 0, 0);
            case 11 ->
                simulation.calls.changeByFloats(Call.RIGID_LASTING_TORQUE, body, between(-0.05f, 0.05f), 0, 0, 0);
            case 12 -> simulation.circles.setForce(circle, between(-0.1f, 0.1f), between(-0.1f, 0.1f));
            case 13 -> simulation.calls.changeByFloats(Call.BODY_VELOCITY, lift, 0, between(0, 0.05f), 0, 0);
            case 14 -> simulation.calls.changeByFloats(Call.BODY_VELOCITY, lift, 0, 0, 0, 0);
            case 15 -> simulation.calls.makeOfFloats(Call.BOUNDS, 0, between(-0.02f, 0.02f), 12, 8);
            case 16 -> simulation.circles.set(Commands.RADIUS, circle, between(0.1f, 0.3f), 0);
            case 17 -> circle(x, between(0.2f, 1), 0.2f, Float.POSITIVE_INFINITY);
            case 18 -> simulation.calls.make(Call.WAKE_ALL);
            case 19 -> {
                simulation.calls.change(Call.WAKE_RIGID, body);
                simulation.circles.setKind(circle, random.nextInt(3));
            }
            case 20 -> simulation.bulk.explode(false, 0, x, 0.5f, 0.3f, 1, 0.5f);
            case 21 -> simulation.calls.change(Call.RIGID_GROUP, body, random.nextInt(2), 0, 0);
            case 22 -> Twins.setWall(simulation, random.nextInt(4), between(0.4f, 0.8f), 0.05f, 0);
            default -> {
                simulation.fields.setOwn(CircleField.GRAVITY_SCALE, circle, between(0.5f, 1.5f));
                if (simulation.jointIds.contains(rod)) {
                    simulation.calls.change(Call.REMOVE_JOINT, rod);
                }
            }
        }
    }

    private float between(float from, float to) {
        return from + (to - from) * (float) random.nextDouble();
    }

    /** A bit of each id of a circle, and behind them of a body, that is awake. */
    String awake() {
        mostSleepers = Math.max(
                mostSleepers, simulation.circles.size() - simulation.figures().awake());
        mostSleepingBodies = Math.max(mostSleepingBodies, simulation.rigidIds.size() - simulation.rigidReads.awake());
        long[] ids = new long[simulation.circles.idLimit() / Long.SIZE + 1];
        simulation.readings.readAwakeById(ids);
        StringBuilder all = new StringBuilder(Arrays.toString(ids));
        for (long body : bodies) {
            all.append(simulation.rigidReads.isAwake(body) ? '1' : '0');
        }
        return all.toString();
    }

    /** How many circles slept at most when {@link #awake} was asked. */
    int mostSleepers() {
        return mostSleepers;
    }

    int mostSleepingBodies() {
        return mostSleepingBodies;
    }

    float[] poses() {
        float[] poses = new float[3 * simulation.rigidIds.limit()];
        simulation.rigidReads.readById(poses, null);
        return poses;
    }

    /** What bodies and circles have begun and ended to touch since the last time. */
    List<String> touches() {
        List<String> lines = BodyChanges.touches(simulation);
        lines.addAll(Twins.events(simulation.reports.take()));
        return lines;
    }

    byte[] snapshot() {
        ByteBuffer bytes = ByteBuffer.allocate(simulation.snapshots.bytes());
        simulation.snapshots.write(bytes);
        return Arrays.copyOf(bytes.array(), bytes.position());
    }

    void restore(byte[] bytes) {
        simulation.snapshots.restore(ByteBuffer.wrap(bytes));
    }
}
