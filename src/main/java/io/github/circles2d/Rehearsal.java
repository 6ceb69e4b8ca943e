package io.github.circles2d;

import io.github.circles2d.opencl.RunningBuilds;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.shared.Mover;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.function.BooleanSupplier;

/**
 * A world that is made up, and moves to a device and back on a thread beside another one. When that moves, there is memory that has been touched,
 * kernels have run, and code is compiled. Nothing that is made up stays on the device but room.
 */
final class Rehearsal implements Mover {
    private static final float STEP = 1 / 60f;

    /** The first round has no impulses to carry, the second has; fewer circles need more rounds until code is compiled. */
    private static final int LEAST_ROUNDS = 3;

    private static final int MOST_ROUNDS = 40;
    private static final int CIRCLES_OF_ALL_ROUNDS = 1_000_000;

    /** What a circle of it takes on the heap at most: alone, and with all features. */
    private static final long HEAP_BYTES = 750;

    private static final long HEAP_BYTES_WITH_ALL = 2500;

    // a lattice, in which each circle overlaps six others a little
    private static final float RADIUS = 0.5f;
    private static final float COLUMN = 0.99f;
    private static final float ROW = 0.85f;
    private static final int LEAST_COLUMNS = 16;

    /** Of one circle, so that steps look for fast ones, too. */
    private static final float SPEED = 30;

    private final Pipeline home;
    private final Pipeline device;
    private final World world;
    private final float[] read;
    private Pipeline next;

    /** Why the device would not take the world, or make its steps; null if it does. */
    private Throwable refusal;

    private Rehearsal(Pipeline device, Readiness wanted, int circles) {
        this.device = device;
        home = new JvmPipeline(savers(), JvmPipeline.LEAST_SHARE, circles, false);
        next = home;
        int columns = Math.max(LEAST_COLUMNS, (int) Math.sqrt(circles));
        int rows = circles / columns + 1;
        world = new World(
                builder(wanted).bounds(0, 0, COLUMN * columns + 2 * RADIUS, ROW * rows + 2 * RADIUS),
                new BackendChoice(Backend.JVM, home, "a rehearsal"));
        world.simulation().moves.by(this);
        read = new float[4 * circles];
        fill(wanted, circles, columns);
    }

    /**
     * Makes a rehearsal with a device that has compiled what is wanted. Throws what the device throws. It is left out where the heap has little
     * room.
     *
     * @param goesOn is asked now and then, and ends it
     * @return memory for as many circles on their way; null if there is none
     */
    static SavedState of(Pipeline device, Readiness wanted, int circles, BooleanSupplier goesOn) {
        if (lacksHeap(wanted, circles)) {
            return null;
        }
        Rehearsal rehearsal = new Rehearsal(device, wanted, circles);
        try {
            rehearsal.goToAndFro(circles, goesOn);
            return rehearsal.world.simulation().moves.memory();
        } finally {
            rehearsal.world.close();
        }
    }

    /** As few threads as make the code run that many threads save a world by. */
    private static int savers() {
        return World.Builder.defaultThreads() < JvmPipeline.LEAST_SAVERS ? 1 : JvmPipeline.LEAST_SAVERS;
    }

    /** The world beside keeps at least half of the heap that is free. */
    private static boolean lacksHeap(Readiness wanted, int circles) {
        Runtime heap = Runtime.getRuntime();
        long free = heap.maxMemory() - heap.totalMemory() + heap.freeMemory();
        long each = wanted.equals(Readiness.USUAL) ? HEAP_BYTES : HEAP_BYTES_WITH_ALL;
        return circles * each > free / 2;
    }

    private void goToAndFro(int circles, BooleanSupplier goesOn) {
        try {
            device.forget(); // the world beside may have been there
            int rounds = Math.max(LEAST_ROUNDS, Math.min(MOST_ROUNDS, CIRCLES_OF_ALL_ROUNDS / circles));
            for (int round = 0; round < rounds && goesOn.getAsBoolean(); round++) {
                RunningBuilds.make(this::goThereAndBack); // an exit must not unload a driver that is at work
            }
        } finally {
            device.forget();
        }
    }

    /**
     * Circles are read all at once. Positions are not, for they would be laid out in memory that the game may still look into.
     */
    private void goThereAndBack() {
        next = device;
        world.step(STEP);
        world.read(read);
        next = home;
        world.simulation().moves.beforeSteps(1); // a step at home would disturb more than it gains
        if (refusal instanceof Error e) {
            throw e;
        }
        if (refusal != null) {
            throw (RuntimeException) refusal;
        }
    }

    private static World.Builder builder(Readiness wanted) {
        Features features = wanted.features();
        World.Builder builder = World.builder().gravity(0, -10).sleep(features.sleeping());
        if (wanted.tuned()) {
            builder.restitutionThreshold(1);
        }
        if (features.edges()) {
            builder.edges(Edge.WRAP, Edge.WALL);
        }
        if (features.turning()) {
            builder.friction(0.5f);
        }
        return builder;
    }

    /** Adds circles, and what makes the world need all that is wanted. */
    private void fill(Readiness wanted, int circles, int columns) {
        long first = 0;
        long last = 0;
        for (int k = 0; k < circles; k++) {
            int row = k / columns;
            float x = RADIUS + COLUMN * (k % columns) + (row % 2 == 0 ? 0 : COLUMN / 2);
            last = world.add(x, RADIUS + ROW * row, RADIUS, 1, 0, k == circles - 1 ? SPEED : 0, k == 0 ? 1 : 0);
            first = k == 0 ? last : first;
        }
        Features features = wanted.features();
        if (features.terrain()) {
            world.terrain().addSegment(0, 0, world.maxX() / 4, 0, 0, 2); // of a kind that nobody is told of alone
        }
        if (features.joints()) {
            world.joints().add(first, last, Joint.rope(world.maxX() + world.maxY()));
        }
        if (features.ownMotion()) {
            world.setGravityScale(first, 0.5f);
        }
        if (features.bodies()) {
            world.bodies().add(Outline.box(1, 1), world.maxX() / 2, world.maxY() / 2, 0, 1); // among the circles
        }
        if (wanted.recording()) {
            world.report(Events.BEGIN);
        } else if (wanted.reporting()) {
            world.kind(1).setSensor(true);
            world.report(0, 1, Events.BEGIN);
        }
    }

    @Override
    public Pipeline choose(Pipeline now, Readiness wanted, int circles, int awake, double nanos) {
        return next == home || device.isReady(wanted) ? next : home;
    }

    @Override
    public Pipeline home() {
        return home;
    }

    @Override
    public boolean isHome(Pipeline pipeline) {
        return pipeline == home;
    }

    @Override
    public void moved(Pipeline from, Pipeline to, long nanos, Throwable cause) {
        refusal = cause;
    }

    @Override
    public void refused(Pipeline chosen, Throwable why) {
        refusal = why;
    }

    @Override
    public void lost(Pipeline failed, Throwable why) {
        refusal = why;
    }

    /** Closes what is made up. */
    @Override
    public void close() {
        home.close();
    }
}
