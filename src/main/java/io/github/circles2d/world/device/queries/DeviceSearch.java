package io.github.circles2d.world.device.queries;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelBuildException;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.WorldSource;
import io.github.circles2d.world.queries.QueryShape;
import io.github.circles2d.world.queries.RemoteSearch;
import java.util.function.IntSupplier;

/**
 * Searches on a device; {@code kernels/world/queries/Search.cl}. They find in double precision what the searches of the host find, and
 * hand over ids and distances; the host makes hits of them.
 */
public final class DeviceSearch implements RemoteSearch {
    /** Most circles that one call may find: some 80 MB. The host answers calls that find more. */
    private static final int MOST_FOUND = 1 << 22;

    /** Most numbers of the queries of a call. */
    private static final int MOST_NUMBERS = 1 << 24;

    // a place: the distance, x, y
    private static final int PLACE_BYTES = 16;
    private static final int AT_X = 8;
    private static final int AT_Y = 12;

    /** The state in which no tree is. */
    private static final long NONE = -1;

    private final Session session;
    private final DeviceArrays arrays;
    private final IntSupplier slots;
    private final IntSupplier circles;

    /** Null before the first search. */
    private DeviceTree tree;

    private Kernel count;
    private Kernel list;
    private Kernel few;

    private boolean refused;

    private DeviceBuffer words;
    private DeviceBuffer ends;
    private DeviceBuffer ids;
    private DeviceBuffer places;
    private HostBuffer hostWords;
    private HostBuffer hostIds;
    private HostBuffer hostPlaces;

    /** Which state the tree shows, and whether it can be searched. */
    private long shown = NONE;

    private boolean usable;

    /** The queries that have been counted. */
    private QueryShape counted;

    private boolean countedFiltered;

    /** Takes no memory before the first search. */
    public DeviceSearch(Session session, DeviceArrays arrays, IntSupplier slots, IntSupplier circles) {
        this.session = session;
        this.arrays = arrays;
        this.slots = slots;
        this.circles = circles;
    }

    /** Compiles the searches, which takes a moment. Returns false if the compiler refuses them. */
    private boolean open() {
        if (tree == null && !refused) {
            try {
                StageKernels kernels = new StageKernels(session, source(), StageKernels.USUAL_GROUPS);
                count = kernels.plain("queries_count");
                list = kernels.plain("queries_list");
                few = kernels.plain("queries_few");
                tree = new DeviceTree(session, kernels, arrays);
            } catch (KernelBuildException e) {
                refused = true;
            }
        }
        return !refused;
    }

    private static KernelSource source() {
        KernelSource source = WorldSource.tables().and("world/queries/Search.cl");
        for (QueryShape shape : QueryShape.values()) {
            source = source.define("QUERY_" + shape.name(), shape.ordinal());
        }
        return DeviceTree.define(source.define("FILTER_WORDS", FILTER_WORDS).define("LEFT_OUT", LEFT_OUT));
    }

    @Override
    public boolean pays() {
        return session.device().kind() == Device.Kind.GPU;
    }

    @Override
    public boolean show(long state) {
        if (circles.getAsInt() == 0 || !session.device().doublePrecision()) {
            return false;
        }
        if (shown != state) {
            shown = NONE;
            usable = did(() -> open() && tree.build(slots.getAsInt(), circles.getAsInt()));
            shown = state;
        }
        return usable;
    }

    /** Does something that may lack memory. Returns whether it was done. */
    private static boolean did(Attempt attempt) {
        try {
            return attempt.make();
        } catch (DeviceMemoryException e) {
            return false;
        }
    }

    private interface Attempt {
        boolean make();
    }

    @Override
    public boolean count(QueryShape shape, float[] queries, int n, int[] filter, int[] counts) {
        return n <= MOST_NUMBERS / shape.stride()
                && did(() -> {
                    write(shape, queries, n, filter);
                    ends = grown(ends, "ends of queries", Integer.BYTES, n);
                    hostIds = grown(hostIds, Integer.BYTES, n);
                    bind(count, shape, filter != null, n).arg(10, ends).run(n);
                    ends.read(0, hostIds, 0, (long) Integer.BYTES * n);
                    hostIds.ints().get(0, counts, 0, n);
                    return true;
                });
    }

    @Override
    public boolean list(int n, int[] endsOfQueries, boolean withPlaces) {
        int found = endsOfQueries[n - 1];
        return found <= MOST_FOUND
                && did(() -> {
                    hostIds.ints().put(0, endsOfQueries, 0, n);
                    ends.write(0, hostIds, 0, (long) Integer.BYTES * n);
                    makeRoom(found);
                    bind(list, counted, countedFiltered, n)
                            .arg(10, ends)
                            .arg(11, ids)
                            .arg(12, places)
                            .run(n);
                    read(found, withPlaces);
                    return true;
                });
    }

    @Override
    public boolean few(
            QueryShape shape, float[] queries, int n, float within, int most, int[] filter, boolean withPlaces) {
        return n <= MOST_NUMBERS / shape.stride()
                && (long) n * most <= MOST_FOUND
                && did(() -> {
                    write(shape, queries, n, filter);
                    makeRoom(n * most);
                    bind(few, shape, filter != null, n)
                            .arg(10, within)
                            .arg(11, most)
                            .arg(12, ids)
                            .arg(13, places)
                            .run(n);
                    read(n * most, withPlaces);
                    return true;
                });
    }

    private void write(QueryShape shape, float[] queries, int n, int[] filter) {
        int numbers = shape.stride() * n;
        hostWords = grown(hostWords, Integer.BYTES, FILTER_WORDS + numbers);
        words = grown(words, "queries", Integer.BYTES, FILTER_WORDS + numbers);
        for (int k = 0; k < FILTER_WORDS; k++) {
            hostWords.ints().put(k, filter == null ? 0 : filter[k]);
        }
        hostWords.floats().put(FILTER_WORDS, queries, 0, numbers);
        words.write(0, hostWords, 0, (long) Integer.BYTES * (FILTER_WORDS + numbers));
        counted = shape;
        countedFiltered = filter != null;
    }

    private Kernel bind(Kernel search, QueryShape shape, boolean filtered, int n) {
        return tree.bind(search)
                .arg(5, shape.ordinal())
                .arg(6, words)
                .arg(7, filtered ? 1 : 0)
                .arg(8, arrays.get(DeviceArray.FIELDS))
                .arg(9, n);
    }

    private void makeRoom(int found) {
        ids = grown(ids, "found circles", Integer.BYTES, found);
        places = grown(places, "places of found circles", PLACE_BYTES, found);
        hostIds = grown(hostIds, Integer.BYTES, found);
        hostPlaces = grown(hostPlaces, PLACE_BYTES, found);
    }

    private void read(int found, boolean withPlaces) {
        ids.read(0, hostIds, 0, (long) Integer.BYTES * found);
        if (withPlaces) {
            places.read(0, hostPlaces, 0, (long) PLACE_BYTES * found);
        }
    }

    private DeviceBuffer grown(DeviceBuffer held, String name, long elementBytes, long elements) {
        return DeviceTree.grown(session, held, name, elementBytes * elements);
    }

    private HostBuffer grown(HostBuffer held, long elementBytes, long elements) {
        long bytes = elementBytes * elements;
        if (held != null && held.size() >= bytes) {
            return held;
        }
        HostBuffer larger = session.hostBuffer(bytes + (bytes >> 1));
        if (held != null) {
            held.close();
        }
        return larger;
    }

    @Override
    public int id(int k) {
        return hostIds.ints().get(k);
    }

    @Override
    public double distance(int k) {
        return hostPlaces.bytes().getDouble(PLACE_BYTES * k);
    }

    @Override
    public float x(int k) {
        return hostPlaces.bytes().getFloat(PLACE_BYTES * k + AT_X);
    }

    @Override
    public float y(int k) {
        return hostPlaces.bytes().getFloat(PLACE_BYTES * k + AT_Y);
    }
}
