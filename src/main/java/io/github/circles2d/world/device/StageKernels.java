package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.Tuning;
import java.util.ArrayList;
import java.util.List;

/** The compiled stages, and the one argument list that all their kernels share. */
final class StageKernels {
    private static final String[] FILES = {
        "CircleMath",
        "World",
        "Scan",
        "Commands",
        "Grid",
        "Sweep",
        "Contacts",
        "Solver",
        "TileCircles",
        "Tiles",
        "TileContacts",
        "TileOrder",
        "TileSolver",
        "Readback"
    };

    private static final String[] LANES_FILES = {
        "LaneMath", "Together", "LaneMover", "LaneContacts", "LaneFinding", "LanePasses", "LaneGrid", "Lanes"
    };

    private final Program program;
    private final List<Kernel> staged = new ArrayList<>();
    private int boundVersion = -1;
    private int boundSlots = -1;
    private int boundCircles = -1;

    StageKernels(Session session, Plan plan) {
        KernelSource source = source(plan == Plan.RESIDENT, plan == Plan.LANES)
                .define("PTX", PersistentGpu.fits(session.device()))
                .define("YIELDS", PersistentCpu.yields(session.device()));
        program = session.build(source, options(session.device()));
    }

    /**
     * The source of all stages; the numbers that host and device share are defined from their one place in Java.
     *
     * @param resident whether to make steps in one launch, which not every device can
     * @param lanes whether to make them on a processor
     */
    static KernelSource source(boolean resident, boolean lanes) {
        List<String> files = new ArrayList<>();
        for (String file : FILES) {
            files.add("world/" + file + ".cl");
        }
        if (resident) {
            files.add("world/Resident.cl");
        }
        if (lanes) {
            for (String file : LANES_FILES) {
                files.add("world/" + file + ".cl");
            }
        }
        return KernelSource.of(files.toArray(String[]::new))
                .define("LEVELS", GridLevels.COUNT)
                .define("MARGIN", Tuning.MARGIN)
                .define("CAP", Tuning.CAP)
                .define("TRAVEL", Tuning.TRAVEL)
                .define("SWEEP_RATIO", Tuning.SWEEP_RATIO)
                .define("LEASH", Tuning.LEASH)
                .define("CROWD", Tuning.CROWD)
                .define("COINCIDENT", Tuning.COINCIDENT)
                .define("TILE_CIRCLES", Tiles.CIRCLES)
                .define("TILE_CONTACTS", Tiles.CONTACTS)
                .define("TILE_ROUNDS", Tiles.ROUNDS)
                .define("TILE_PARTS", Tiles.PARTS)
                .define("TILE_GROUP", Tiles.GROUP)
                .define("TILE_COPIES_IN_TWO", DeviceArrays.COPIES_IN_TWO)
                .define("RESIDENT_GROUP", PersistentGpu.GROUP)
                .define("GREATEST_SPEED", Tuning.GREATEST_SPEED);
    }

    /** Without this option a device may round divisions and square roots as it likes, and some do. */
    static String[] options(Device device) {
        return device.correctlyRounded() ? new String[] {"-cl-fp32-correctly-rounded-divide-sqrt"} : new String[0];
    }

    /** A kernel with an argument list of its own. */
    Kernel plain(String name) {
        return program.kernel(name);
    }

    /** A kernel of a stage: its first {@link DeviceArrays#COUNT} arguments are WORLD_PARAMETERS. */
    Kernel staged(String name) {
        Kernel kernel = program.kernel(name);
        staged.add(kernel);
        return kernel;
    }

    /** Sets the size of work-groups, for the kernels of the stages that leave it open; as near to it as each kernel allows. */
    void workGroupSize(int size) {
        for (Kernel kernel : staged) {
            kernel.workGroupSize(Math.min(size, kernel.maxWorkGroupSize()));
        }
    }

    /** Brings the shared arguments up to date. */
    void bind(DeviceArrays buffers, int slots, int circles) {
        boolean replaced = boundVersion != buffers.version();
        for (Kernel kernel : staged) {
            if (replaced) {
                buffers.bind(kernel);
                kernel.arg(DeviceArrays.CONTACT_ROOM, buffers.contactRoom());
            }
            if (replaced || boundSlots != slots) {
                kernel.arg(DeviceArrays.SLOTS, slots);
            }
            if (replaced || boundCircles != circles) {
                kernel.arg(DeviceArrays.CIRCLES, circles);
            }
        }
        boundVersion = buffers.version();
        boundSlots = slots;
        boundCircles = circles;
    }
}
