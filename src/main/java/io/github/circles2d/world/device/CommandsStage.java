package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.device.memory.CachedImpulse;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.GrownBuffer;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.PairTable;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;

/** Applies commands on a device; {@code kernels/world/stages/Commands.cl}. */
final class CommandsStage {
    private static final int LEAST_CAPACITY = 64;
    private static final long RECORD_BYTES = (long) Integer.BYTES * Commands.STRIDE;

    // The link of a record: the next record of the same circle or NONE; then (slot of a new circle) times 2, plus 1 for
    // its
    // circle's first record.
    private static final int LINK_STRIDE = 2;
    private static final int AT_NEXT = 0;
    private static final int AT_SLOT = 1;
    private static final long LINK_BYTES = (long) Integer.BYTES * LINK_STRIDE;

    /** Two of x, y, radius, and whether there is one. */
    private static final long CHANGED_BYTES = 2L * 4 * Float.BYTES;

    private static final long KINDS_BYTES = PairTable.KINDS / Byte.SIZE;

    private final DeviceArrays arrays;
    private StageKernels kernels;
    private Kernel apply;
    private Kernel confine;

    /** Null, as the next, unless circles sleep. */
    private Kernel wake;

    /** By record: the circle before and behind a change that wakes those near to it. */
    private final GrownBuffer changed;

    /** A bit of each kind whose circles wake. */
    private final GrownBuffer kindsToWake;

    private final GrownBuffer records;
    private final GrownBuffer links;

    /** By id: its last record so far of the batch numbered by {@link #batchOf}. */
    private int[] last = new int[LEAST_CAPACITY];

    private int[] batchOf = new int[LEAST_CAPACITY];
    private int batch;
    private int[] link = new int[0];

    /** By id: the slot that it was given since the slots were last put in order, the time of which is {@link #orderOf}. */
    private int[] given = new int[LEAST_CAPACITY];

    private int[] orderOf = new int[LEAST_CAPACITY];
    private int order = 1;

    /** Slots that have been given and left since then: without a step between, circles that come and go need no others. */
    private int[] free = new int[LEAST_CAPACITY];

    private int freeCount;

    CommandsStage(Session session, StageKernels kernels, DeviceArrays arrays) {
        this.arrays = arrays;
        records = new GrownBuffer(session, "commands");
        links = new GrownBuffer(session, "command links");
        changed = new GrownBuffer(session, "changed circles");
        kindsToWake = new GrownBuffer(session, "kinds to wake");
        use(kernels);
    }

    /** Applies commands by kernels that know whether circles turn, and sleep. */
    void use(StageKernels withAll) {
        kernels = withAll;
        apply = withAll.staged("commands_apply");
        confine = withAll.plain("commands_confine");
        if (arrays.features().sleeping()) {
            wake = withAll.plain("commands_wake");
            changed.ensureRoomy(0);
            kindsToWake.ensure(KINDS_BYTES);
        }
    }

    /** Makes room for commands, of which {@link #apply} says what they need. */
    void makeRoom(Commands commands, int slots) {
        int count = commands.count();
        int removed = 0;
        for (int r = 0; r < count; r++) {
            removed += commands.operation(r) == Commands.REMOVE ? 1 : 0;
            int id = commands.id(r);
            if (id >= last.length) {
                ensureIds(id + (id >> 1));
            }
        }
        if (free.length < freeCount + removed) {
            free = Arrays.copyOf(free, Math.max(2 * free.length, freeCount + removed));
        }
        if (link.length < LINK_STRIDE * count) {
            link = new int[LINK_STRIDE * (count + (count >> 1))];
        }
        arrays.ensureIds(last.length);
        records.ensureRoomy(RECORD_BYTES * count);
        links.ensureRoomy(LINK_BYTES * count);
        if (wake != null) {
            changed.ensureRoomy(CHANGED_BYTES * (count + commands.areas())); // twice as much as areas need
        }
        arrays.ensureSlots(slots + Math.max(0, commands.added() - freeCount), slots);
    }

    /** In call order; bodies sleep as circles do, or are null. New circles take free slots, then those from slots on; returns the slots at home afterwards. */
    int apply(Commands commands, int slots, int circles, Bounds arena, RigidStep bodies) {
        int count = commands.count();
        if (count == 0) {
            wake(commands, slots, arena, bodies);
            return slots;
        }
        int nextSlot = link(commands, slots);
        kernels.bind(arrays, nextSlot, circles);
        records.get().write(0, IntBuffer.wrap(commands.records(), 0, Commands.STRIDE * count));
        links.get().write(0, IntBuffer.wrap(link, 0, LINK_STRIDE * count));
        apply.arg(StageKernels.own(0), records.get())
                .arg(StageKernels.own(1), links.get())
                .arg(StageKernels.own(2), count);
        if (wake != null) {
            apply.arg(StageKernels.own(3), changed.get());
        }
        apply.run(count);
        wake(commands, nextSlot, arena, bodies);
        return nextSlot;
    }

    /** Wakes those near to circles that have changed, and those of kinds and at walls. */
    private void wake(Commands commands, int slots, Bounds arena, RigidStep bodies) {
        boolean near = wakesNear(commands);
        if (wake == null || !(commands.wakesSome() || near || commands.areas() > 0)) {
            return;
        }
        if (bodies != null && bodies.anySleeps()) {
            wakeBodies(commands, near, arena, bodies);
        }
        putAreas(commands);
        if (commands.wakesSome()) {
            kindsToWake.get().write(0, IntBuffer.wrap(commands.kindsToWake()));
        }
        wake.arg(0, arrays.get(DeviceArray.HOME_ID))
                .arg(1, arrays.get(DeviceArray.HOME_CIRCLE))
                .arg(2, arrays.get(DeviceArray.HOME_MOTION))
                .arg(3, arrays.get(DeviceArray.HOME_TRAITS))
                .arg(4, arrays.get(DeviceArray.HOME_SLEEP))
                .arg(5, slots)
                .arg(6, changed.get())
                .arg(7, 2 * commands.count() + commands.areas())
                .arg(8, arena.periodX())
                .arg(9, arena.periodY())
                .arg(10, commands.wakesSome() ? 1 : 0)
                .arg(11, kindsToWake.get())
                .arg(12, commands.wallsToWake())
                .arg(13, arrays.get(DeviceArray.FIELDS))
                .run(slots);
    }

    /** Wakes bodies by what wakes circles. */
    private void wakeBodies(Commands commands, boolean near, Bounds arena, RigidStep bodies) {
        if (commands.wakesSome()) {
            bodies.wakeBy(commands);
        }
        if (near) {
            float[] circles = new float[CircleRow.of(2 * commands.count())];
            changed.get().read(FloatBuffer.wrap(circles));
            for (int s = 0; s < circles.length; s += CircleRow.STRIDE) {
                if (circles[s + CircleRow.MASS] > 0f) {
                    bodies.wakeNear(
                            -1,
                            circles[s + CircleRow.X],
                            circles[s + CircleRow.Y],
                            circles[s + CircleRow.RADIUS],
                            arena.periodX(),
                            arena.periodY());
                }
            }
        }
    }

    /** Places around which circles wake are like circles that have changed, behind these. */
    private void putAreas(Commands commands) {
        if (commands.areas() == 0) {
            return;
        }
        float[] rows = new float[CircleRow.of(commands.areas())];
        for (int k = 0; k < commands.areas(); k++) {
            System.arraycopy(commands.areaValues(), Commands.AREA * k, rows, CircleRow.of(k), Commands.AREA);
            rows[CircleRow.of(k) + CircleRow.MASS] = 1f;
        }
        changed.get().write(CHANGED_BYTES * commands.count(), FloatBuffer.wrap(rows));
    }

    private static boolean wakesNear(Commands commands) {
        for (int r = 0; r < commands.count(); r++) {
            switch (commands.operation(r)) {
                case Commands.ADD,
                        Commands.REMOVE,
                        Commands.POSITION,
                        Commands.RADIUS,
                        Commands.GROW,
                        Commands.MASS,
                        Commands.ANGULAR_VELOCITY,
                        Commands.ARRIVE,
                        Commands.FIELD -> {
                    return true;
                }
                default -> {
                    // it moves no other circle, and none loses what carries it
                }
            }
        }
        return false;
    }

    /** Takes note that the slots were put in order, without gaps: by a step, or anew. */
    void slotsInOrder() {
        order++;
        freeCount = 0;
    }

    /** Brings circles that are outside of new bounds inside, unless the next step does. */
    void confine(Bounds from, Bounds bounds, Bounds calm, int slots) {
        confine.arg(0, arrays.get(DeviceArray.HOME_ID))
                .arg(1, arrays.get(DeviceArray.HOME_CIRCLE))
                .arg(2, arrays.get(DeviceArray.HOME_MOTION))
                .arg(3, arrays.get(DeviceArray.HOME_TRAITS))
                .arg(4, slots);
        bind(confine, 5, bounds);
        bind(confine, 9, from);
        if (wake != null) {
            confine.arg(13, arrays.get(DeviceArray.HOME_SLEEP));
            bind(confine, 14, calm);
        }
        confine.run(slots);
    }

    private static void bind(Kernel kernel, int first, Bounds bounds) {
        kernel.arg(first, bounds.minX())
                .arg(first + 1, bounds.minY())
                .arg(first + 2, bounds.maxX())
                .arg(first + 3, bounds.maxY());
    }

    /** Links the records of each circle. */
    private int link(Commands commands, int slots) {
        batch++;
        int nextSlot = slots;
        // What becomes free now is for the next batch: circles are independent of each other within one.
        int reusable = freeCount;
        int reused = 0;
        for (int r = 0; r < commands.count(); r++) {
            int operation = commands.operation(r);
            int id = commands.id(r);
            boolean first = batchOf[id] != batch;
            if (!first) {
                link[LINK_STRIDE * last[id] + AT_NEXT] = r;
            }
            batchOf[id] = batch;
            last[id] = r;
            link[LINK_STRIDE * r + AT_NEXT] = CachedImpulse.NONE;
            int slot = 0;
            if (operation == Commands.ADD) {
                slot = reused < reusable ? free[reused++] : nextSlot++;
                given[id] = slot;
                orderOf[id] = order;
            } else if (operation == Commands.REMOVE && orderOf[id] == order) {
                free[freeCount++] = given[id];
            }
            link[LINK_STRIDE * r + AT_SLOT] = 2 * slot + (first ? 1 : 0);
        }
        freeCount -= reused;
        System.arraycopy(free, reused, free, 0, freeCount);
        return nextSlot;
    }

    /** Makes room for ids. All arrays are made before one is assigned: a growth that fails changes nothing. */
    private void ensureIds(int ids) {
        int[] newBatchOf = Arrays.copyOf(batchOf, ids);
        int[] newGiven = Arrays.copyOf(given, ids);
        int[] newOrderOf = Arrays.copyOf(orderOf, ids);
        int[] newLast = Arrays.copyOf(last, ids);
        batchOf = newBatchOf;
        given = newGiven;
        orderOf = newOrderOf;
        last = newLast;
    }
}
