package io.github.circles2d.thesis;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import java.nio.IntBuffer;
import java.util.HashMap;
import java.util.Map;

/** The mappings from slot to pair for one n, run by themselves on a device: no MTV is computed or stored. */
final class PairProbe implements AutoCloseable {
    /** The slots of a work-item where mappings that are arithmetic are counted. */
    private static final int BLOCK = 256;

    private final Session session;
    private final Map<Integer, Program> programs = new HashMap<>();
    private final int n;
    private final int slots;

    PairProbe(Device device, int n) {
        session = Session.open(device);
        this.n = n;
        slots = (int) PairSlots.count(n);
    }

    /** A kernel for one mapping. All but the row search have one program for every n, which is compiled once. */
    private Kernel kernel(String name, String mapping) {
        int rounds = mapping.equals("rows") ? RowSearchPairs.rounds(n) : 1;
        return programs.computeIfAbsent(rounds, this::build).kernel(name + mapping);
    }

    private Program build(int rounds) {
        KernelSource source = KernelSource.of(
                        "CirclePhysV2.cl", "thesis/ExactPairs.cl", "thesis/WrongSlots.cl", "thesis/PairProbe.cl")
                .define("ROW_SEARCH_ROUNDS", rounds);
        // As ThesisSimulation.source has it: on a GPU some helpers are compiled otherwise.
        return session.build(
                session.device().kind() == Device.Kind.GPU ? source.define("FEW_WORK_ITEMS", true) : source,
                "-cl-finite-math-only");
    }

    DeviceBuffer noTable() {
        return session.allocate("no table", 0);
    }

    DeviceBuffer lookupTable() {
        LookupTablePairs pairs = new LookupTablePairs();
        pairs.open(session, n);
        return pairs.table();
    }

    DeviceBuffer rows() {
        RowSearchPairs rows = new RowSearchPairs();
        rows.open(session, n);
        return rows.table();
    }

    DeviceBuffer table(int[] content) {
        DeviceBuffer table = session.allocate("table", 4L * content.length);
        table.write(0, IntBuffer.wrap(content));
        return table;
    }

    /** Returns how many slots of this n a mapping gets wrong. */
    long countWrong(String mapping, DeviceBuffer table) {
        DeviceBuffer wrong = table(new int[1]);
        try (Kernel kernel = kernel("count_wrong_", mapping)) {
            kernel.arg(0, wrong)
                    .arg(1, table)
                    .arg(2, slots)
                    .arg(3, n)
                    .run(mapping.equals("rows") ? slots : (slots - 1) / BLOCK + 1);
        }
        IntBuffer result = IntBuffer.allocate(1);
        wrong.read(result);
        return result.get(0);
    }

    /** Returns i and j of every slot of this n. */
    int[] map(String mapping, DeviceBuffer table) {
        int[] result = new int[2 * slots];
        DeviceBuffer pairs = session.allocate("pairs", 8L * slots);
        try (Kernel kernel = kernel("map_", mapping)) {
            kernel.arg(0, pairs).arg(1, table).arg(2, slots).arg(3, n).run(slots);
        }
        pairs.read(IntBuffer.wrap(result));
        pairs.close();
        return result;
    }

    /** Returns i and j of some slots of this n. */
    int[] mapSome(String mapping, DeviceBuffer table, int[] someSlots) {
        int[] result = new int[2 * someSlots.length];
        try (DeviceBuffer list = table(someSlots);
                DeviceBuffer pairs = session.allocate("pairs", 4L * result.length);
                Kernel kernel = kernel("map_some_", mapping)) {
            kernel.arg(0, pairs)
                    .arg(1, table)
                    .arg(2, slots)
                    .arg(3, n)
                    .arg(4, list)
                    .arg(5, someSlots.length)
                    .run(someSlots.length);
            pairs.read(IntBuffer.wrap(result));
        }
        return result;
    }

    @Override
    public void close() {
        session.close();
    }
}
