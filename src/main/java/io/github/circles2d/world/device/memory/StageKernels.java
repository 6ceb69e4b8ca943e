package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;

/** The compiled stages, and the argument list that all their kernels share. */
public final class StageKernels {
    /** Lets a kernel choose the size of its work-groups, if it leaves that open. */
    public static final int USUAL_GROUPS = Integer.MAX_VALUE;

    /**
     * Whether the kernels that fix the size of their work-groups take a small one, if they can. Tests ask for it: an interpreter is quicker
     * then, and a small world has several blocks and rounds.
     */
    public static final boolean SMALL_GROUPS = Boolean.getBoolean("circles2d.groups.small");

    private static final int OWN_ARGUMENTS = DeviceArguments.COUNT + DeviceCount.COUNT;

    private final Program program;
    private final int workGroupSize;
    private final KernelSource source;
    private final Map<String, Kernel> staged = new HashMap<>();

    /** By name of a stage's kernel: the positions of the buffers that it uses. */
    private final Map<String, BitSet> buffers = new HashMap<>();

    /** Null before the first kernel of a stage. */
    private UsedArguments used;

    private final boolean recording;
    private int boundVersion = -1;
    private int boundSlots = -1;
    private int boundCircles = -1;

    /** With work-groups as near to this size as each kernel allows, or {@link #USUAL_GROUPS}. */
    public StageKernels(Session session, KernelSource source, int workGroupSize) {
        this(session, source, workGroupSize, false, false);
    }

    /** If steps report, kernels decide what; if they record, also what contacts do. */
    public StageKernels(Session session, KernelSource source, int workGroupSize, boolean reporting, boolean recording) {
        KernelSource compiled = reporting ? source.define("REPORTING", 1) : source;
        compiled = recording ? compiled.define("RECORDING", 1) : compiled;
        this.source = compiled;
        program = session.build(compiled, options(session.device()));
        this.workGroupSize = workGroupSize;
        this.recording = recording;
    }

    public boolean recording() {
        return recording;
    }

    /** Without this option a device may round divisions and square roots as it likes, and some do. */
    public static String[] options(Device device) {
        return device.correctlyRounded() ? new String[] {"-cl-fp32-correctly-rounded-divide-sqrt"} : new String[0];
    }

    /** A kernel with an argument list of its own. */
    public Kernel plain(String name) {
        return program.kernel(name);
    }

    /** A kernel of a stage: its first arguments are WORLD_PARAMETERS. */
    public Kernel staged(String name) {
        return staged.computeIfAbsent(name, this::make);
    }

    private Kernel make(String name) {
        Kernel kernel = program.kernel(name);
        if (workGroupSize != USUAL_GROUPS) {
            kernel.workGroupSize(Math.min(workGroupSize, kernel.maxWorkGroupSize()));
        }
        boundVersion = -1;
        if (used == null) {
            used = new UsedArguments(source);
        }
        buffers.put(name, used.of(name));
        return kernel;
    }

    /** The position of an argument of a stage's kernel behind WORLD_PARAMETERS: 0 for the first. */
    public static int own(int argument) {
        return OWN_ARGUMENTS + argument;
    }

    /** Brings the shared arguments up to date. */
    public void bind(DeviceArrays arrays, int slots, int circles) {
        boolean replaced = boundVersion != arrays.version();
        for (Kernel kernel : staged.values()) {
            if (replaced) {
                arrays.bind(kernel, buffers.get(kernel.name()));
            }
            if (replaced || boundSlots != slots) {
                kernel.arg(DeviceCount.SLOTS.position(), slots);
            }
            if (replaced || boundCircles != circles) {
                kernel.arg(DeviceCount.CIRCLES.position(), circles);
            }
        }
        boundVersion = arrays.version();
        boundSlots = slots;
        boundCircles = circles;
    }
}
