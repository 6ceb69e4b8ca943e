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
import io.github.circles2d.world.device.memory.GrownBuffer;
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

    private final GrownBuffer words;
    private final GrownBuffer ends;
    private final GrownBuffer ids;
    private final GrownBuffer places;
    private final GrownBuffer.OnHost hostWords;
    private final GrownBuffer.OnHost hostIds;
    private final GrownBuffer.OnHost hostPlaces;

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
        words = new GrownBuffer(session, "queries");
        ends = new GrownBuffer(session, "ends of queries");
        ids = new GrownBuffer(session, "found circles");
        places = new GrownBuffer(session, "places of found circles");
        hostWords = new GrownBuffer.OnHost(session);
        hostIds = new GrownBuffer.OnHost(session);
        hostPlaces = new GrownBuffer.OnHost(session);
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
                    long bytes = (long) Integer.BYTES * n;
                    DeviceBuffer to = ends.ensureRoomy(bytes);
                    bind(count, shape, filter != null, n).arg(10, to).run(n);
                    to.read(0, hostIds.ensure(bytes), 0, bytes);
                    hostIds.get().ints().get(0, counts, 0, n);
                    return true;
                });
    }

    @Override
    public boolean list(int n, int[] endsOfQueries, boolean withPlaces) {
        int found = endsOfQueries[n - 1];
        return found <= MOST_FOUND
                && did(() -> {
                    hostIds.get().ints().put(0, endsOfQueries, 0, n);
                    ends.get().write(0, hostIds.get(), 0, (long) Integer.BYTES * n);
                    makeRoom(found);
                    bind(list, counted, countedFiltered, n)
                            .arg(10, ends.get())
                            .arg(11, ids.get())
                            .arg(12, places.get())
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
                            .arg(12, ids.get())
                            .arg(13, places.get())
                            .run(n);
                    read(n * most, withPlaces);
                    return true;
                });
    }

    private void write(QueryShape shape, float[] queries, int n, int[] filter) {
        int numbers = shape.stride() * n;
        long bytes = (long) Integer.BYTES * (FILTER_WORDS + numbers);
        HostBuffer host = hostWords.ensure(bytes);
        for (int k = 0; k < FILTER_WORDS; k++) {
            host.ints().put(k, filter == null ? 0 : filter[k]);
        }
        host.floats().put(FILTER_WORDS, queries, 0, numbers);
        words.ensureRoomy(bytes).write(0, host, 0, bytes);
        counted = shape;
        countedFiltered = filter != null;
    }

    private Kernel bind(Kernel search, QueryShape shape, boolean filtered, int n) {
        return tree.bind(search)
                .arg(5, shape.ordinal())
                .arg(6, words.get())
                .arg(7, filtered ? 1 : 0)
                .arg(8, arrays.get(DeviceArray.FIELDS))
                .arg(9, n);
    }

    private void makeRoom(int found) {
        ids.ensureRoomy((long) Integer.BYTES * found);
        places.ensureRoomy((long) PLACE_BYTES * found);
        hostIds.ensure((long) Integer.BYTES * found);
        hostPlaces.ensure((long) PLACE_BYTES * found);
    }

    private void read(int found, boolean withPlaces) {
        ids.get().read(0, hostIds.get(), 0, (long) Integer.BYTES * found);
        if (withPlaces) {
            places.get().read(0, hostPlaces.get(), 0, (long) PLACE_BYTES * found);
        }
    }

    @Override
    public int id(int k) {
        return hostIds.get().ints().get(k);
    }

    @Override
    public double distance(int k) {
        return hostPlaces.get().bytes().getDouble(PLACE_BYTES * k);
    }

    @Override
    public float x(int k) {
        return hostPlaces.get().bytes().getFloat(PLACE_BYTES * k + AT_X);
    }

    @Override
    public float y(int k) {
        return hostPlaces.get().bytes().getFloat(PLACE_BYTES * k + AT_Y);
    }
}
