package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.DeviceArray.Index;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.KindMotion;
import io.github.circles2d.world.model.PairTable;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToIntFunction;
import java.util.function.ToLongFunction;

/** The state and the working memory of a World on a device. It grows by at least half, and keeps the elements that must outlive a step. */
public final class DeviceArrays {
    /** log2 of the columns, and of the rows, of a block of cells. */
    static final int BLOCK_LOG = 2;

    /** Says of an index that its arrays do not grow. */
    private static final long AS_IT_IS = 0;

    /** Of the rows of kinds, and of those of walls behind them. */
    private static final int LEAST_CAPACITY = 64;

    private static final int LEAST_BUCKETS = 16;
    private static final int LEAST_TILES = 32;
    private static final int CONTACTS_PER_CIRCLE = 4;

    /** Elements that an array grows to at most. */
    private static final int MOST_ELEMENTS = 1 << 30;

    private final Session session;
    private final boolean tiled;
    private final Map<DeviceArray, DeviceBuffer> arrays = new EnumMap<>(DeviceArray.class);
    private Map<Index, Block> blocks = new EnumMap<>(Index.class);
    private int slotCapacity;
    private int idCapacity;
    private int bucketCapacity;
    private int contactCapacity;
    private int copyCapacity;
    private int tileCapacity;

    /** Those that there are arrays for; edges need none. */
    private Features features = Features.NONE;

    private final TableRoom terrainRoom = TerrainArray.room();
    private final TableRoom jointRoom = JointArray.room();

    /** Counts how often arrays were replaced, so that kernels know when to bind again. */
    private int version;

    /** Without steps by tiles, the arrays for these alone have one element. */
    public DeviceArrays(Session session, int capacity, boolean tiled) {
        this.session = session;
        this.tiled = tiled;
        allocateOnce(DeviceArray.CONSTANTS, StepParameters.CONSTANTS.words());
        allocateOnce(DeviceArray.LEVELS, StepParameters.LEVELS.words());
        allocateOnce(DeviceArray.WALLS, StepParameters.WALLS.words());
        allocateOnce(DeviceArray.STATUS, StatusWord.WORDS);
        allocateOnce(DeviceArray.RESPONSES, PairTable.WORDS);
        allocateOnce(DeviceArray.KIND_MOTION, KindMotion.of(PairTable.KINDS));
        get(DeviceArray.KIND_MOTION).write(0, IntBuffer.wrap(new int[KindMotion.of(PairTable.KINDS)]));
        get(DeviceArray.RESPONSES).write(0, IntBuffer.wrap(new int[PairTable.WORDS]));
        int circles = Math.max(capacity, LEAST_CAPACITY);
        ensureSlots(circles, 0);
        ensureBuckets(LEAST_BUCKETS);
        ensureTiles(tiled ? LEAST_TILES : 1);
        ensureContacts(CONTACTS_PER_CIRCLE * circles);
        ensureIds(circles);
    }

    private void allocateOnce(DeviceArray array, int words) {
        arrays.put(array, session.allocate(array.kernelName(), (long) Integer.BYTES * words));
    }

    /** An array, until it grows. */
    public DeviceBuffer get(DeviceArray array) {
        Index index = array.index();
        return index.block() == null ? arrays.get(array) : blocks.get(index).get(array);
    }

    int version() {
        return version;
    }

    public int slotCapacity() {
        return slotCapacity;
    }

    /** Number of ids that there is memory for. */
    public int idCapacity() {
        return idCapacity;
    }

    public int contactCapacity() {
        return contactCapacity;
    }

    /** Makes room for slots; what is at home in the first {@code kept} of them stays. */
    public void ensureSlots(int slots, int kept) {
        if (slots > slotCapacity) {
            int capacity = grown(slotCapacity, slots);
            grow(kept, index -> switch (index) {
                case HOME_SLOT, SLOT, RANK, TILED_SLOT -> capacity;
                default -> AS_IT_IS;
            });
            slotCapacity = capacity;
        }
    }

    /** Makes room for ids; new ones belong to no circle. */
    public void ensureIds(int ids) {
        if (ids > idCapacity) {
            int capacity = grown(idCapacity, ids);
            grow(idCapacity, index -> index == Index.ID || index == Index.FIELDS_BY_ID ? capacity : AS_IT_IS);
            int[] none = new int[Math.min(capacity - idCapacity, 1 << 18)];
            Arrays.fill(none, CachedImpulse.NONE);
            for (int from = idCapacity; from < capacity; from += none.length) {
                get(DeviceArray.SLOT_OF)
                        .write(
                                (long) Integer.BYTES * from,
                                IntBuffer.wrap(none, 0, Math.min(none.length, capacity - from)));
            }
            idCapacity = capacity;
        }
    }

    public void ensureBuckets(int buckets) {
        if (buckets > bucketCapacity) {
            int capacity = grown(bucketCapacity, buckets);
            // One more element for the end; both scans share the block sums.
            int elements = Scan.padded(capacity + 1);
            grow(0, index -> switch (index) {
                case BUCKET, TALLY -> elements;
                case SCAN_BLOCK -> Scan.blocks(capacity + 1);
                case CELL_BLOCK -> cellBlocks(capacity);
                default -> AS_IT_IS;
            });
            get(DeviceArray.TALLY).write(0, IntBuffer.wrap(new int[elements]));
            bucketCapacity = capacity;
        }
    }

    /** Makes room for records of tiles; they do not outlive a step. */
    public void ensureTiles(int tiles) {
        if (tiles > tileCapacity) {
            int capacity = grown(tileCapacity, tiles);
            grow(0, index -> index == Index.TILE ? (long) TileRecord.WORDS * capacity : AS_IT_IS);
            tileCapacity = capacity;
        }
    }

    /** Makes room for contacts; the impulse cache stays. */
    public void ensureContacts(int contacts) {
        if (contacts > contactCapacity) {
            int capacity = grown(contactCapacity, contacts);
            int copies = Math.max(copyCapacity, tiled ? TileRecord.copies(capacity) : capacity);
            grow(contactCapacity, index -> switch (index) {
                case CONTACT, TILED_CONTACT, OLD_CONTACT -> capacity;
                case COPY, TILED_COPY -> copies > copyCapacity ? copies : AS_IT_IS;
                default -> AS_IT_IS;
            });
            contactCapacity = capacity;
            copyCapacity = copies;
        }
    }

    /** False if there cannot be so much. */
    public boolean ensureCopies(int copies) {
        if (copies < 0 || copies > MOST_ELEMENTS) {
            return false;
        }
        if (copies > copyCapacity) {
            int capacity = grown(copyCapacity, copies);
            try {
                grow(0, index -> index == Index.COPY || index == Index.TILED_COPY ? capacity : AS_IT_IS);
            } catch (DeviceMemoryException e) {
                return false;
            }
            copyCapacity = capacity;
        }
        return true;
    }

    /** What there are arrays for. */
    public Features features() {
        return features;
    }

    /**
     * Makes room for what features need, and fills it: no circle has turned, sleeps or is near to a piece, none has a surface of its own or moves
     * in another way than those of its kind, and there are no joints. Bodies that are pushed have their memory elsewhere, and edges need none.
     */
    public void ensure(Features wanted) {
        Features before = features;
        List<Features> added = new ArrayList<>();
        for (Features feature : DeviceArray.FEATURES) {
            if (wanted.have(feature) && !before.have(feature)) {
                added.add(feature);
                features = features.and(feature);
            }
        }
        if (!added.isEmpty()) {
            try {
                growTables(
                        terrainEnd(),
                        jointRoom); // kernels without the features can use larger tables, but not other blocks
                grow(this::capacity, index -> added.stream().anyMatch(index::isOf) ? capacity(index) : AS_IT_IS);
            } catch (RuntimeException | Error e) {
                features = before;
                throw e;
            }
        }
        for (DeviceArray array : DeviceArray.values()) {
            if (added.contains(array.feature()) && array.kept()) {
                fill(array, capacity(array.index()), array.initial());
            }
        }
        features = features.and(Features.BODIES.when(wanted.bodies()));
    }

    /** Elements of the arrays of an index that some feature has arrays by. */
    private int capacity(Index index) {
        return switch (index) {
            case HOME_SLOT, SLOT, TILED_SLOT -> slotCapacity;
            case FIELDS_BY_ID -> idCapacity;
            case CONTACT, TILED_CONTACT, OLD_CONTACT -> contactCapacity;
            case TILED_COPY -> copyCapacity;
            default -> throw new IllegalStateException("no feature has arrays " + index);
        };
    }

    /**
     * Makes room for tables behind those of kinds, up to the end of terrain's if they are given so many floats, and for those of joints behind
     * all. What is there stays, but for tables of joints that the host has too: if these move, they have to be written again.
     */
    private void growTables(int floats, TableRoom joints) {
        DeviceBuffer before = get(DeviceArray.KIND_MOTION);
        int behind = Math.max(floats, terrainEnd());
        int end = features.joints() ? behind + joints.words() : floats;
        boolean moves = features.joints() && (joints != jointRoom || behind != terrainEnd());
        if (before.bytes() >= bytesOf(end) && !moves) {
            return;
        }
        DeviceBuffer tables = session.allocate("tables of kinds", bytesOf(end));
        try {
            before.copyTo(tables, Math.min(before.bytes(), bytesOf(terrainEnd())));
            if (features.joints()) {
                keepJoints(before, terrainEnd(), tables, behind, joints);
            }
            session.finish();
        } catch (RuntimeException | Error e) {
            tables.close();
            throw e;
        }
        arrays.put(DeviceArray.KIND_MOTION, tables).close();
        version++;
        if (moves) {
            jointRoom.take(joints);
        }
    }

    private static long bytesOf(int words) {
        return (long) Integer.BYTES * words;
    }

    /** Words up to the end of the tables of terrain, behind which those of joints lie. */
    private int terrainEnd() {
        return DeviceArray.TERRAIN_AT + terrainRoom.words();
    }

    /** Takes along what joints keep, and gives those that there is new room for nothing. */
    private void keepJoints(DeviceBuffer before, int from, DeviceBuffer tables, int to, TableRoom joints) {
        for (JointArray table : JointArray.ALL) {
            if (table.kept()) {
                int held = jointRoom.words(table);
                int words = joints.words(table);
                if (held > 0) {
                    long at = bytesOf(from + jointRoom.at(table));
                    before.copyTo(at, tables, bytesOf(to + joints.at(table)), bytesOf(held));
                }
                clear(tables, to + joints.at(table) + held, words - held);
            }
        }
    }

    private static void clear(DeviceBuffer tables, int at, int words) {
        int[] zeros = new int[Math.min(words, 1 << 16)];
        for (int k = 0; k < words; k += zeros.length) {
            tables.write(bytesOf(at + k), IntBuffer.wrap(zeros, 0, Math.min(zeros.length, words - k)));
        }
    }

    /** Makes room for the tables of joints; if it was too little, those that the host has, too, have to be written. */
    void ensureJoints(int[] needed) {
        TableRoom wanted = jointRoom.with(needed);
        if (wanted != null) {
            growTables(terrainEnd(), wanted);
        }
    }

    /** Makes room for so many joints; what they keep is there. */
    public void ensureJoints(int joints) {
        int[] needed = new int[JointArray.Count.COUNT];
        needed[JointArray.Count.JOINTS.ordinal()] = joints;
        ensureJoints(needed);
    }

    TableRoom jointRoom() {
        return jointRoom;
    }

    /** Makes room for the tables of terrain; if it was too little, all of them have to be written. */
    void ensureTerrain(int pieces, int nodes, int motion) {
        TableRoom wanted = terrainRoom.with(pieces, nodes, motion);
        if (wanted != null) {
            growTables(DeviceArray.TERRAIN_AT + wanted.words(), jointRoom);
            terrainRoom.take(wanted);
        }
    }

    TableRoom terrainRoom() {
        return terrainRoom;
    }

    /** Words before a table of joints in the buffer of tables. */
    int at(JointArray table) {
        return terrainEnd() + jointRoom.at(table);
    }

    /** Writes a part of a table of joints or terrain. */
    void write(TableRoom.Table table, int[] values, int from, int to) {
        if (from < to) {
            writeTable(at(table, from, to), IntBuffer.wrap(values, from, to - from));
        }
    }

    void write(TableRoom.Table table, float[] values, int from, int to) {
        if (from < to) {
            writeTable(at(table, from, to), FloatBuffer.wrap(values, from, to - from));
        }
    }

    private int at(TableRoom.Table table, int from, int to) {
        return table instanceof JointArray
                ? terrainEnd() + jointRoom.at(table, from, to)
                : DeviceArray.TERRAIN_AT + terrainRoom.at(table, from, to);
    }

    /** Gives all elements of an array the same value. */
    private void fill(DeviceArray array, int elements, int... value) {
        int[] values = new int[value.length * Math.min(elements, 1 << 16)];
        for (int k = 0; k < values.length; k++) {
            values[k] = value[k % value.length];
        }
        long ints = (long) value.length * elements;
        for (long from = 0; from < ints; from += values.length) {
            int length = (int) Math.min(values.length, ints - from);
            get(array).write(Integer.BYTES * from, IntBuffer.wrap(values, 0, length));
        }
    }

    /** Writes to the buffer of tables; at: words before them. */
    void writeTable(int at, IntBuffer words) {
        get(DeviceArray.KIND_MOTION).write(bytesOf(at), words);
    }

    void writeTable(int at, FloatBuffer words) {
        get(DeviceArray.KIND_MOTION).write(bytesOf(at), words);
    }

    public static int cellBlocks(int buckets) {
        return buckets >> 2 * BLOCK_LOG;
    }

    static int grown(int capacity, int needed) {
        return (int) Math.min(Math.max(needed, capacity + (long) (capacity >> 1)), MOST_ELEMENTS);
    }

    private void grow(int kept, ToLongFunction<Index> elements) {
        grow(index -> kept, elements);
    }

    /** All or none; {@link #AS_IT_IS} for those that do not grow, and kept elements stay in arrays that are kept. */
    private void grow(ToIntFunction<Index> kept, ToLongFunction<Index> elements) {
        Map<Index, Block> added = new EnumMap<>(Index.class);
        try {
            for (Index index : DeviceArguments.BLOCKS) {
                long wanted = elements.applyAsLong(index);
                boolean stub = index.forTilesAlone() && !tiled;
                if (wanted != AS_IT_IS && !(stub && blocks.containsKey(index))) {
                    added.put(index, new Block(session, index, stub ? 1 : wanted, features));
                }
            }
        } catch (RuntimeException | Error e) {
            added.values().forEach(Block::close);
            throw e;
        }
        for (DeviceArray array : DeviceArray.values()) {
            Block block = added.get(array.index());
            Block before = blocks.get(array.index());
            if (block != null && array.kept() && before != null && before.has(array) && block.has(array)) {
                get(array).copyTo(block.get(array), (long) kept.applyAsInt(array.index()) * array.elementBytes());
            }
        }
        session.finish();
        Map<Index, Block> next = new EnumMap<>(blocks);
        next.putAll(added);
        for (Index index : added.keySet()) {
            if (blocks.containsKey(index)) {
                blocks.get(index).close();
            }
        }
        blocks = next;
        version++;
    }

    /**
     * Gives a stage's kernel the buffers that it uses and what says where arrays lie in them; its other counts are set by
     * {@link StageKernels}.
     */
    void bind(Kernel kernel, BitSet used) {
        for (int k = 0; k < DeviceArguments.ARRAYS.size(); k++) {
            bind(kernel, used, k, arrays.get(DeviceArguments.ARRAYS.get(k)));
        }
        blocks.forEach((index, block) -> {
            bind(kernel, used, DeviceArguments.position(index), block.buffer());
            if (index.stride() != null && !index.forTilesAlone()) {
                kernel.arg(index.stride().position(), block.stride());
            }
        });
        kernel.arg(DeviceCount.CONTACT_ROOM.position(), contactCapacity);
    }

    private static void bind(Kernel kernel, BitSet used, int position, DeviceBuffer buffer) {
        if (used.get(position)) {
            kernel.arg(position, buffer);
        } else {
            kernel.withoutBuffer(position);
        }
    }

    /** A buffer with all arrays of an index, one behind the other. */
    private static final class Block implements AutoCloseable {
        /** Arrays begin at multiples of so many elements, so that each can be a buffer of its own, too. */
        private static final long ALIGNMENT = 1024;

        private final DeviceBuffer buffer;
        private final long stride;
        private final Features features;
        private final Map<DeviceArray, DeviceBuffer> slices = new EnumMap<>(DeviceArray.class);

        /** With the arrays of worlds with these features. */
        Block(Session session, Index index, long elements, Features features) {
            this.features = features;
            stride = (elements + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
            buffer = session.allocate(index.block(), index.elementBytes(features) * stride);
        }

        DeviceBuffer buffer() {
            return buffer;
        }

        /** Elements from the start of an array to that of the next. */
        int stride() {
            return Math.toIntExact(stride);
        }

        boolean has(DeviceArray array) {
            return array.isHeld(features);
        }

        DeviceBuffer get(DeviceArray array) {
            return slices.computeIfAbsent(
                    array,
                    a -> buffer.slice(a.kernelName(), a.bytesBefore(features) * stride, a.elementBytes() * stride));
        }

        @Override
        public void close() {
            slices.values().forEach(DeviceBuffer::close);
            buffer.close();
        }
    }
}
