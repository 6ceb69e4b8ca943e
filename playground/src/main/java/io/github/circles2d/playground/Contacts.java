package io.github.circles2d.playground;

import io.github.circles2d.Events;
import io.github.circles2d.World;

/**
 * The contacts of the last step, with their normals and impulses, if a person wants to see them: of circles, walls and terrain. They are
 * the hits of a world whose hit speed is 0, so each is a pair between which an impulse acted: pairs that sleep are not among them. A world
 * reports nothing unless this is on.
 */
final class Contacts {
    /** Elements of a contact: its place, its normal and its impulse. */
    static final int STRIDE = 5;

    /** Of more contacts only every second, third and so on is shown. */
    static final int MOST = 4_000;

    /** How much of the mean impulse is that of the last step. */
    private static final double SHARE = 0.1;

    private final float[] values = new float[STRIDE * MOST];
    private boolean on;
    private int count;
    private double mean;

    boolean isOn() {
        return on;
    }

    /** Begins or ends to follow the contacts of a world, from its next step on. */
    void set(World world, boolean wanted) {
        on = wanted;
        forget();
        report(world, on ? Events.HIT | Events.WALL : 0);
    }

    /** Another world has come, or the past of this one, which keeps no reports. */
    void start(World world) {
        forget();
        if (on) {
            report(world, Events.HIT | Events.WALL);
        }
    }

    private static void report(World world, int types) {
        world.report(types);
        world.setHitSpeed(0);
        world.events(); // those of before
    }

    private void forget() {
        count = 0;
        mean = 0;
    }

    /** Takes what was reported in so many steps, and keeps the contacts of the last. */
    void read(World world, int steps) {
        if (!on || steps == 0) {
            return;
        }
        Events events = world.events();
        int first = 0;
        while (first < events.size() && events.step(first) < steps - 1) {
            first++;
        }
        int all = events.size() - first;
        int every = Math.max(1, (all + MOST - 1) / MOST);
        count = 0;
        double sum = 0;
        for (int event = first; event < events.size(); event += every) {
            int at = STRIDE * count++;
            values[at] = events.x(event);
            values[at + 1] = events.y(event);
            values[at + 2] = events.normalX(event);
            values[at + 3] = events.normalY(event);
            values[at + 4] = events.impulse(event);
            sum += events.impulse(event);
        }
        if (count > 0) {
            mean = mean == 0 ? sum / count : mean + SHARE * (sum / count - mean);
        }
    }

    /** Fills the contacts of a frame. */
    void fill(Frame frame, Grain grain) {
        frame.showsContacts = on;
        frame.ensureContacts(count);
        System.arraycopy(values, 0, frame.contact, 0, STRIDE * count);
        frame.contacts = count;
        frame.meanImpulse = (float) mean;
        frame.normalLength = grain.radius();
    }
}
