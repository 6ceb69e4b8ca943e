package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.EventRow;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.PairTable;
import java.nio.IntBuffer;
import java.util.Objects;
import java.util.stream.Stream;

/** The memory in which a device decides what steps report; {@code kernels/world/stages/Events.cl}. */
public final class EventArrays implements AutoCloseable {
    /** Arguments of {@link #bind}. */
    public static final int ARGUMENTS = 16;

    /** Ints of a pair in the table of those that touch. */
    public static final int PAIR = 4;

    // Of a pair, from its beginning.
    public static final int PAIR_LOWER = 0;
    public static final int PAIR_HIGHER = 1;
    public static final int PAIR_STEP = 2;
    public static final int PAIR_OPEN = 3;

    /** Instead of a hit that is not complete. */
    public static final int NO_HIT = -1;

    /** Floats of a hit that is not complete; there are two of each number, one for each parity of the step. */
    private static final int OPEN_HIT = 8;

    /** Of the header before the events, which is as long as one of them. */
    public static final int HEADER_EVENTS = 0;

    public static final int HEADER_STEP = 1;
    public static final int HEADER_UNORDERED = 2;

    /** A step's number is that of the steps made before it and this: the table uses those below for itself. */
    public static final int FIRST_STEP = 2;

    /** The most work-groups that decide in one launch: each has a sum among {@link #blockSums}. */
    public static final int MOST_DECIDERS = 256;

    private static final int LEAST_ROOM = 512;
    private static final int LEAST_OPEN_ROOM = 256;
    private static final int KINDS = PairTable.KINDS;
    private static final int REPORTED_HEAD = 4;

    /** Events of both halves: while the host reads one, steps write into the other. */
    private final GrownBuffer[] decided;

    private final Session session;
    private DeviceBuffer touching;
    private DeviceBuffer openHits;
    private final GrownBuffer newcomers;
    private final GrownBuffer drafts;
    private final GrownBuffer order;
    private final GrownBuffer tally;
    private final GrownBuffer starts;
    private final GrownBuffer blockSums;
    private final GrownBuffer reported;
    private int reportedVersion = -1;
    private int reportedAxes;
    private boolean reportedByKind;

    /** Places of the table: a power of two. */
    private int places;

    /** Pairs that begin, events of a step, and events that the host has not read. */
    private int room;

    private int openRoom;
    private int ids;

    // Of the steps that are enqueued next.
    private int step;
    private boolean starting;
    private int half;
    private float hitSpeed;

    /** No memory yet. */
    public EventArrays(Session session) {
        this.session = session;
        decided = new GrownBuffer[] {new GrownBuffer(session, "events"), new GrownBuffer(session, "events")};
        newcomers = new GrownBuffer(session, "events: newcomers");
        drafts = new GrownBuffer(session, "events: drafts");
        order = new GrownBuffer(session, "events: order");
        tally = new GrownBuffer(session, "events: by id");
        starts = new GrownBuffer(session, "events: starts");
        blockSums = new GrownBuffer(session, "events: blocks");
        reported = new GrownBuffer(session, "events: reported");
    }

    /** What kernels have of this memory, if they are compiled for steps that report (REPORTING); see {@link TouchArrays#text}. */
    static String text() {
        return """
                #ifdef REPORTING
                typedef struct {
                    global int4 *touching; // the rest: see Events.cl
                    global int4 *newcomers;
                    global float4 *openHits;
                    global int4 *drafts;
                    global int4 *decided;
                    global int *eventTally;
                    global int *eventStart;
                    global int *eventOrder;
                    global const int *reported;
                    int mask; // one less than the table has places
                    int room; // for newcomers, for drafts, for events that the host has not read
                    int openRoom; // for hits that are not complete
                    int ids; // that there is room for
                    int step; // its number: two more than steps were made before it
                    int starting; // whether it is the first that the host reads together
                    float hitSpeed; // that counts as a hit; negative: that of the pair
                } Reporting;
                #define REPORTING_PARAMETERS , global int4 *touching, global int4 *newcomers, global float4 *openHits, \
                    global int4 *drafts, global int4 *decided, global int *eventTally, global int *eventStart, \
                    global int *eventOrder, global const int *reported, int eventMask, int eventRoom, int openRoom, \
                    int eventIds, int stepNumber, int startsBatch, float hitSpeed
                #define REPORT_IN(w) Reporting reporting = {touching, newcomers, openHits, drafts, decided, eventTally, \
                    eventStart, eventOrder, reported, eventMask, eventRoom, openRoom, eventIds, stepNumber, startsBatch, \
                    hitSpeed}; (w).reporting = reporting
                #else
                #define REPORTING_PARAMETERS
                #define REPORT_IN(w)
                #endif
                """
                + "#define TYPE_BEGIN " + ContactEvents.BEGIN + "\n"
                + "#define TYPE_HIT " + ContactEvents.HIT + "\n"
                + "#define TYPE_END " + ContactEvents.END + "\n"
                + "#define RANK_BEGIN " + EventRow.BEGIN + "\n"
                + "#define RANK_HIT " + EventRow.HIT + "\n"
                + "#define RANK_END " + EventRow.END + "\n";
    }

    /** Gives a kernel of a stage its REPORTING_PARAMETERS, of which the first is an argument of its own. */
    public Kernel bind(Kernel kernel, int first) {
        return bindAt(kernel, StageKernels.own(first));
    }

    /** Gives a kernel its REPORTING_PARAMETERS, from an argument on. */
    public Kernel bindAt(Kernel kernel, int first) {
        return kernel.arg(first, touching)
                .arg(first + 1, newcomers.get())
                .arg(first + 2, openHits)
                .arg(first + 3, drafts.get())
                .arg(first + 4, decided[half].get())
                .arg(first + 5, tally.get())
                .arg(first + 6, starts.get())
                .arg(first + 7, order.get())
                .arg(first + 8, reported.get())
                .arg(first + 9, places - 1)
                .arg(first + 10, room)
                .arg(first + 11, openRoom)
                .arg(first + 12, ids)
                .arg(first + 13, step)
                .arg(first + 14, starting ? 1 : 0)
                .arg(first + 15, hitSpeed);
    }

    /** Sets the number of the step that is enqueued next, whether it is the first that the host reads together, and where to. */
    public void setStep(int stepsMade, boolean startsBatch, int ofHalf) {
        step = FIRST_STEP + stepsMade;
        starting = startsBatch;
        half = ofHalf;
    }

    /** Goes on to the next step of those that one call of a plan enqueues. */
    public void nextStep() {
        step++;
        starting = false;
    }

    /** Sets the speed that counts as a hit; negative: that of the pair. */
    public void setHitSpeed(float speed) {
        hitSpeed = speed;
    }

    /** Makes room for ids that other arrays have room for; at first also for so many events of a step. */
    public void ensure(DeviceArrays arrays, int events) {
        ensureRoom(Math.max(LEAST_ROOM, events));
        if (arrays.idCapacity() > ids) {
            int elements = Scan.padded(arrays.idCapacity() + 1);
            tally.ensure((long) Integer.BYTES * elements);
            tally.get().write(0, IntBuffer.wrap(new int[elements]));
            starts.ensure((long) Integer.BYTES * elements);
            int sums = Math.max(MOST_DECIDERS, Scan.blocks(elements));
            blockSums.ensure((long) Integer.BYTES * sums);
            ids = arrays.idCapacity();
        }
        if (openHits == null) {
            openHits = openHits(LEAST_OPEN_ROOM);
        }
    }

    /** Makes room for so many pairs that begin, events of a step and events to read; those that are there may be lost. */
    public void ensureRoom(int wanted) {
        if (wanted > room) {
            long c = Math.max(wanted, room + (long) (room >> 1));
            if (c > Integer.MAX_VALUE / EventRow.STRIDE - 1) {
                throw new IllegalStateException(wanted + " events of a step, but a device takes at most "
                        + (Integer.MAX_VALUE / EventRow.STRIDE - 1));
            }
            long event = (long) Integer.BYTES * EventRow.STRIDE;
            for (int k = decided.length - 1; k >= 0; k--) {
                decided[k].ensure(event * (1 + c));
            }
            newcomers.ensure((long) Integer.BYTES * PAIR * c);
            drafts.ensure(event * c);
            order.ensure(Integer.BYTES * c);
            room = (int) c;
        }
    }

    /** Makes room for hits that are not complete; those that are there stay. */
    public void ensureOpenHits(int wanted) {
        if (wanted > openRoom) {
            DeviceBuffer held = openHits;
            int before = openRoom;
            DeviceBuffer larger = openHits(Math.max(wanted, before + (before >> 1)));
            held.copyTo(larger, openBytes(before));
            session.finish();
            openHits = larger;
            held.close();
        }
    }

    private DeviceBuffer openHits(int hits) {
        DeviceBuffer buffer = session.allocate("events: open hits", openBytes(hits));
        openRoom = hits;
        return buffer;
    }

    private static long openBytes(int hits) {
        return 2L * Float.BYTES * OPEN_HIT * hits;
    }

    /** Takes a table that is not empty yet. Returns the one before, which the caller closes, or null. */
    public DeviceBuffer replaceTable(int pairs) {
        long wanted = Long.highestOneBit(Math.max(LEAST_ROOM, 4L * pairs) - 1) << 1;
        if (wanted > 1 << 28) {
            throw new IllegalStateException(pairs + " pairs touch, but a device takes at most " + (1 << 26));
        }
        DeviceBuffer before = touching;
        touching = session.allocate("events: pairs", (long) Integer.BYTES * PAIR * wanted);
        places = (int) wanted;
        return before;
    }

    /** Sends what is reported, if it is not there yet. */
    public void send(ContactEvents events) {
        Bounds arena = events.arena();
        int axes = (arena.edgeX() == AxisEdge.WALL ? 1 : 0) | (arena.edgeY() == AxisEdge.WALL ? 2 : 0);
        if (reportedVersion == events.version() && reportedAxes == axes) {
            return;
        }
        reportedByKind = events.dependsOnKinds();
        int[] words = new int[REPORTED_HEAD + (reportedByKind ? (KINDS * KINDS + KINDS) / Integer.BYTES : 0)];
        words[0] = reportedByKind ? 1 : 0;
        words[1] = events.typesOfKinds(0, 0);
        words[2] = events.typesOfWalls(0);
        words[3] = axes;
        for (int a = 0; a < KINDS && reportedByKind; a++) {
            for (int b = 0; b < KINDS; b++) {
                put(words, KINDS * a + b, events.typesOfKinds(a, b));
            }
            put(words, KINDS * KINDS + a, events.typesOfWalls(a));
        }
        reported.ensure((long) Integer.BYTES * words.length);
        reported.get().write(0, IntBuffer.wrap(words));
        reportedVersion = events.version();
        reportedAxes = axes;
    }

    /** A hit that is not complete after a step, as the table has it. */
    public static int openHit(int hit, int step) {
        return hit << 2 | step & 3;
    }

    /** The number of a hit that is not complete, as {@link #openHit} put it; -1 if it is of another step, or none. */
    public static int hitOf(int open, int step) {
        return open == NO_HIT || (open & 3) != (step & 3) ? -1 : open >>> 2;
    }

    /** Where the values of a hit that is not complete begin, in floats. */
    public static int placeOfHit(int hit, int step) {
        return OPEN_HIT * (2 * hit + (step & 1));
    }

    private static void put(int[] words, int n, int types) {
        words[REPORTED_HEAD + n / Integer.BYTES] |= types << Byte.SIZE * (n % Integer.BYTES);
    }

    public DeviceBuffer touching() {
        return touching;
    }

    public DeviceBuffer newcomers() {
        return newcomers.get();
    }

    public DeviceBuffer openHits() {
        return openHits;
    }

    public DeviceBuffer tally() {
        return tally.get();
    }

    public DeviceBuffer starts() {
        return starts.get();
    }

    public DeviceBuffer blockSums() {
        return blockSums.get();
    }

    /** The events of a half, behind their header. */
    public DeviceBuffer decided(int ofHalf) {
        return decided[ofHalf].get();
    }

    public int places() {
        return places;
    }

    /** Places of the table that pairs may still take, if some have been: a quarter of it stays free. */
    public int freePlaces(int used) {
        return places - 1 - (places - 1 >> 2) - used;
    }

    public int room() {
        return room;
    }

    public int openRoom() {
        return openRoom;
    }

    public int ids() {
        return ids;
    }

    @Override
    public void close() {
        Stream.of(newcomers, drafts, order, tally, starts, blockSums, reported, decided[0], decided[1])
                .forEach(GrownBuffer::close);
        Stream.of(touching, openHits).filter(Objects::nonNull).forEach(DeviceBuffer::close);
    }
}
