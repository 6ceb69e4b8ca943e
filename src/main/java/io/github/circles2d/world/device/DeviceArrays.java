package io.github.circles2d.world.device;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.Session;
import java.nio.IntBuffer;
import java.util.Arrays;

/**
 * The state and the working memory of a World on a device: the list WORLD_PARAMETERS of {@code kernels/world/World.cl}, in
 * its order. Buffers grow by half at least; growing keeps what must outlive a step.
 */
final class DeviceArrays {
    // Parameters of every stage's kernels, by position.
    static final int CONSTANTS = 0;
    static final int LEVELS = 1;
    static final int STATUS = 2;
    static final int SLOTS = 3;
    static final int CIRCLES = 4;
    static final int CONTACT_ROOM = 5;
    static final int HOME_CIRCLE = 6;
    static final int HOME_MOTION = 7;
    static final int HOME_TRAITS = 8;
    static final int HOME_ID = 9;
    static final int HOME_MEMORY = 10;
    static final int SLOT_OF = 11;
    static final int BUCKET_BEFORE = 12;
    static final int RANK = 13;
    static final int ORDER = 14;
    static final int BUCKET_START = 15;
    static final int BUCKET_OF = 16;
    static final int SIGHT = 17;
    static final int CIRCLE = 18;
    static final int MOTION = 19;
    static final int TRAITS = 20;
    static final int ID = 21;
    static final int MEMORY = 22;
    static final int LOAD = 23;
    static final int WALL_BOUNCE = 24;
    static final int LEASH = 25;
    static final int SHARE = 26;
    static final int NEAR = 27;
    static final int BLOCK_RANGE = 28;
    static final int DRIVE = 29;
    static final int PUSHED_MOTION = 30;
    static final int BURDEN = 31;
    static final int PUSHED_BURDEN = 32;
    static final int GROUP_START = 33;
    static final int TALLY = 34;
    static final int KEY = 35;
    static final int PAIR = 36;
    static final int BASE = 37;
    static final int MASSES = 38;
    static final int CONTACT = 39;
    static final int LINK = 40;
    static final int ORDERED = 41;
    static final int SHAPE = 42;
    static final int HELD = 43;
    static final int IMPULSE = 44;
    static final int OLD = 45;
    static final int BLOCK_SUMS = 46;
    static final int TILES = 47;

    /** Number of parameters: the position of the first that is a kernel's own. */
    static final int COUNT = 48;

    /** Value of a memory: impulses under this id are not its circle's own. */
    static final int FRESH = -2;

    private static final String[] NAMES = {
        "constants",
        "levels",
        "status",
        null,
        null,
        null,
        "circles",
        "motions",
        "traits",
        "ids",
        "memories",
        "slots by id",
        "buckets before",
        "ranks",
        "order",
        "bucket starts",
        "buckets",
        "sights",
        "working circles",
        "working motions",
        "working traits",
        "working ids",
        "working memories",
        "loads",
        "wall bounces",
        "leashes",
        "free shares",
        "shares to contacts",
        "ranges of paths",
        "drives",
        "pushed motions",
        "burdens",
        "pushed burdens",
        "group starts",
        "tally",
        "contact keys",
        "contact pairs",
        "contact bases",
        "contact masses",
        "contacts",
        "contact links",
        "contact pairs in order",
        "contact shapes",
        "held impulses",
        "contact impulses",
        "remembered contacts",
        "block sums",
        "tiles"
    };

    /** Copies that tiles make of two contacts, as far as there is room for them from the start: 1.5 of each with usual tiles. */
    static final int COPIES_IN_TWO = 3;

    /** Ints of the status. */
    static final int STATUS_INTS = 64;

    /** Slots that no circle has: four at a time are read to the next multiple of four. */
    private static final int SPARE_SLOTS = 4;

    private static final int[] BY_SLOT_KEPT = {HOME_CIRCLE, HOME_MOTION, HOME_TRAITS, HOME_ID, HOME_MEMORY};
    private static final int[] BY_SLOT = {
        BUCKET_BEFORE,
        RANK,
        ORDER,
        BUCKET_OF,
        SIGHT,
        CIRCLE,
        MOTION,
        TRAITS,
        ID,
        MEMORY,
        LOAD,
        WALL_BOUNCE,
        LEASH,
        SHARE,
        NEAR
    };
    private static final int[] BY_SLOT_TILED = {DRIVE, PUSHED_MOTION, BURDEN, PUSHED_BURDEN};
    private static final int[] BY_BUCKET = {BUCKET_START, GROUP_START, TALLY};
    private static final int[] BY_CONTACT_KEPT = {OLD};
    private static final int[] BY_CONTACT = {KEY, PAIR, BASE, MASSES};
    private static final int[] BY_CONTACT_TILED = {LINK, ORDERED, HELD, IMPULSE};
    private static final int[] BY_COPY = {CONTACT};
    private static final int[] BY_COPY_TILED = {SHAPE};
    private static final int[] NO_BUFFERS = {};

    private final Session session;
    private final boolean tiled;
    private final DeviceBuffer[] buffers = new DeviceBuffer[COUNT];
    private int slotRoom;
    private int idRoom;
    private int bucketRoom;
    private int contactRoom;
    private int tileRoom;

    /** Counts how often a buffer was replaced, so that kernels know when to bind anew. */
    private int version;

    /**
     * Room for a number of circles.
     *
     * @param tiled whether there may be steps by tiles; otherwise their buffers stay as small as can be
     */
    DeviceArrays(Session session, int capacity, boolean tiled) {
        this.session = session;
        this.tiled = tiled;
        buffers[CONSTANTS] = session.allocate(NAMES[CONSTANTS], 4L * StepParameters.CONSTANT_INTS);
        buffers[LEVELS] = session.allocate(NAMES[LEVELS], 4L * StepParameters.LEVEL_INTS);
        buffers[STATUS] = session.allocate(NAMES[STATUS], 4L * STATUS_INTS);
        ensureSlots(Math.max(capacity, 64), 0);
        ensureIds(Math.max(capacity, 64));
        ensureBuckets(16);
        ensureTiles(1);
        if (!tiled) {
            grow(1, 0, NO_BUFFERS, BY_SLOT_TILED);
            grow(1, 0, NO_BUFFERS, BY_CONTACT_TILED);
            grow(1, 0, NO_BUFFERS, BY_COPY_TILED);
        }
        ensureContacts(4 * Math.max(capacity, 64));
    }

    private static int elementBytes(int parameter) {
        switch (parameter) {
            case HOME_CIRCLE,
                    HOME_MOTION,
                    HOME_TRAITS,
                    SIGHT,
                    CIRCLE,
                    MOTION,
                    TRAITS,
                    LOAD,
                    LEASH,
                    BLOCK_RANGE,
                    DRIVE,
                    PUSHED_MOTION,
                    BASE,
                    MASSES,
                    CONTACT,
                    OLD:
                return 16;
            case ORDER, WALL_BOUNCE, KEY, PAIR, ORDERED, SHAPE, IMPULSE:
                return 8;
            case TILES:
                return 4 * Tiles.RECORD;
            default:
                return 4;
        }
    }

    DeviceBuffer get(int parameter) {
        return buffers[parameter];
    }

    int version() {
        return version;
    }

    int slotRoom() {
        return slotRoom;
    }

    int contactRoom() {
        return contactRoom;
    }

    /** Makes room for slots; what is at home in the first {@code kept} of them stays. */
    void ensureSlots(int slots, int kept) {
        if (slots > slotRoom) {
            int room = grown(slotRoom, slots);
            grow(room + SPARE_SLOTS, kept, BY_SLOT_KEPT, BY_SLOT);
            if (tiled) {
                grow(room, 0, NO_BUFFERS, BY_SLOT_TILED);
            }
            slotRoom = room;
        }
    }

    /** Makes room for ids; new ones belong to no circle. */
    void ensureIds(int ids) {
        if (ids > idRoom) {
            int room = grown(idRoom, ids);
            grow(room, idRoom, new int[] {SLOT_OF}, NO_BUFFERS);
            int[] none = new int[Math.min(room - idRoom, 1 << 18)];
            Arrays.fill(none, -1);
            for (int from = idRoom; from < room; from += none.length) {
                buffers[SLOT_OF].write(4L * from, IntBuffer.wrap(none, 0, Math.min(none.length, room - from)));
            }
            idRoom = room;
        }
    }

    void ensureBuckets(int buckets) {
        if (buckets > bucketRoom) {
            int room = grown(bucketRoom, buckets);
            // One more element for the end; both scans share the block sums.
            int elements = Scan.padded(room + 1);
            grow(elements, 0, NO_BUFFERS, BY_BUCKET);
            buffers[TALLY].write(0, IntBuffer.wrap(new int[elements]));
            grow(Scan.blocks(room + 1), 0, NO_BUFFERS, new int[] {BLOCK_SUMS});
            grow(ContinuousCollisionStage.blocks(room), 0, NO_BUFFERS, new int[] {BLOCK_RANGE});
            bucketRoom = room;
        }
    }

    /** Makes room for records of tiles; they do not outlive a step. */
    void ensureTiles(int tiles) {
        if (tiles > tileRoom) {
            int room = grown(tileRoom, tiles);
            grow(room, 0, NO_BUFFERS, new int[] {TILES});
            tileRoom = room;
        }
    }

    /** Makes room for contacts; the remembered ones stay. */
    void ensureContacts(int contacts) {
        if (contacts > contactRoom) {
            int room = grown(contactRoom, contacts);
            grow(room, contactRoom, BY_CONTACT_KEPT, BY_CONTACT);
            grow(tiled ? copyRoom(room) : room, 0, NO_BUFFERS, BY_COPY);
            if (tiled) {
                grow(room, 0, NO_BUFFERS, BY_CONTACT_TILED);
                grow(copyRoom(room), 0, NO_BUFFERS, BY_COPY_TILED);
            }
            contactRoom = room;
        }
    }

    /** Makes room for copies that tiles make of contacts. */
    void ensureCopies(int copies) {
        if (copies > copyRoom(contactRoom)) {
            ensureContacts((int) (2L * copies / COPIES_IN_TWO) + 2);
        }
    }

    /** Room for copies where there is room for so many contacts; the same in {@code TileOrder.cl}. */
    private static int copyRoom(int contacts) {
        return (contacts >> 1) * COPIES_IN_TWO;
    }

    private static int grown(int room, int needed) {
        return (int) Math.min(Math.max(needed, room + (long) (room >> 1)), 1 << 30);
    }

    /** Replaces buffers by larger ones: all of them, or none where one does not fit. */
    private void grow(int elements, int keptElements, int[] kept, int[] working) {
        DeviceBuffer[] next = new DeviceBuffer[COUNT];
        try {
            for (int parameter : kept) {
                next[parameter] = session.allocate(NAMES[parameter], (long) elements * elementBytes(parameter));
            }
            for (int parameter : working) {
                next[parameter] = session.allocate(NAMES[parameter], (long) elements * elementBytes(parameter));
            }
        } catch (RuntimeException | Error e) {
            for (DeviceBuffer buffer : next) {
                if (buffer != null) {
                    buffer.close();
                }
            }
            throw e;
        }
        for (int parameter : kept) {
            if (buffers[parameter] != null) {
                buffers[parameter].copyTo(next[parameter], (long) keptElements * elementBytes(parameter));
            }
        }
        session.finish();
        for (int parameter = 0; parameter < COUNT; parameter++) {
            if (next[parameter] != null) {
                if (buffers[parameter] != null) {
                    buffers[parameter].close();
                }
                buffers[parameter] = next[parameter];
            }
        }
        version++;
    }

    /** Gives a stage's kernel its buffers; its counts are set by {@link StageKernels}. */
    void bind(Kernel kernel) {
        for (int parameter = 0; parameter < COUNT; parameter++) {
            if (buffers[parameter] != null) {
                kernel.arg(parameter, buffers[parameter]);
            }
        }
    }
}
