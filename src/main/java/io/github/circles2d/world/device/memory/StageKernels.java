package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.ReachableNames;
import io.github.circles2d.opencl.Session;
import java.util.BitSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

/**
 * The compiled stages, and the argument list that all their kernels share. The kernels are one program, or come in parts, each a program
 * that is compiled when the first of its kernels is asked for, or before on another thread.
 */
public final class StageKernels {
    /** Lets a kernel choose the size of its work-groups, if it leaves that open. */
    public static final int USUAL_GROUPS = Integer.MAX_VALUE;

    /**
     * Whether the kernels that fix the size of their work-groups take a small one, if they can. Tests ask for it: an interpreter is quicker
     * then, and a small world has several blocks and rounds.
     */
    public static final boolean SMALL_GROUPS = Boolean.getBoolean("circles2d.groups.small");

    /** The part that has all kernels, if there is one program. */
    private static final String ALL = "all";

    private static final int OWN_ARGUMENTS = DeviceArguments.COUNT + DeviceCount.COUNT;

    private final Session session;
    private final int workGroupSize;
    private final KernelSource source;
    private final ReachableNames names;

    /** Null if there is one program. */
    private final UnaryOperator<String> partOf;

    /** By name of a part. Another thread may add one. */
    private final Map<String, Program> programs = new ConcurrentHashMap<>();

    /** By name of a part: held while it is compiled. */
    private final Map<String, Object> locks = new ConcurrentHashMap<>();

    private final Map<String, Kernel> staged = new HashMap<>();

    /** By name of a stage's kernel: the positions of the buffers that it uses. */
    private final Map<String, BitSet> buffers = new HashMap<>();

    private final boolean recording;

    /** The arrays that kernels are bound to; null before the first of {@link #bind}. */
    private DeviceArrays bound;

    private int boundVersion = -1;
    private int boundSlots = -1;
    private int boundCircles = -1;

    /** Kernels of one program, with work-groups as near to this size as each kernel allows, or {@link #USUAL_GROUPS}. */
    public StageKernels(Session session, KernelSource source, int workGroupSize) {
        this(session, source, workGroupSize, false, false, null);
    }

    /**
     * If steps report, kernels decide what; if they record, also what contacts do.
     *
     * @param partOf the name of the part that a kernel belongs to; null for one program of all
     */
    public StageKernels(
            Session session,
            KernelSource source,
            int workGroupSize,
            boolean reporting,
            boolean recording,
            UnaryOperator<String> partOf) {
        KernelSource compiled = reporting ? source.define("REPORTING", 1) : source;
        this.session = session;
        this.source = recording ? compiled.define("RECORDING", 1) : compiled;
        this.workGroupSize = workGroupSize;
        this.recording = recording;
        this.partOf = partOf;
        names = DeviceArguments.names(this.source);
    }

    /** Whether a part has been compiled. */
    public boolean has(String part) {
        return programs.containsKey(partOf == null ? ALL : part);
    }

    /** Compiles a part, unless it has been compiled. Any thread may call this. */
    public void compile(String part) {
        String own = partOf == null ? ALL : part;
        synchronized (locks.computeIfAbsent(own, key -> new Object())) {
            if (!has(own)) {
                programs.put(own, session.build(partOf == null ? source : sourceOf(own), options(session.device())));
            }
        }
    }

    private KernelSource sourceOf(String part) {
        Set<String> kernels = new HashSet<>(names.kernels());
        kernels.removeIf(kernel -> !partOf.apply(kernel).equals(part));
        return names.sourceOf(kernels);
    }

    private Kernel kernel(String name) {
        String part = partOf == null ? ALL : partOf.apply(name);
        compile(part);
        return programs.get(part).kernel(name);
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
        return kernel(name);
    }

    /** A kernel of a stage: its first arguments are WORLD_PARAMETERS. */
    public Kernel staged(String name) {
        Kernel kernel = staged.get(name);
        return kernel != null ? kernel : make(name);
    }

    /** A kernel of a stage that few steps launch: it is made when it is first asked for. */
    public Supplier<Kernel> later(String name) {
        return () -> staged(name);
    }

    private Kernel make(String name) {
        Kernel kernel = kernel(name);
        if (workGroupSize != USUAL_GROUPS) {
            kernel.workGroupSize(Math.min(workGroupSize, kernel.maxWorkGroupSize()));
        }
        buffers.put(name, DeviceArguments.used(names, name));
        staged.put(name, kernel);
        if (bound != null) {
            bound.bind(kernel, buffers.get(name));
            kernel.arg(DeviceCount.SLOTS.position(), boundSlots).arg(DeviceCount.CIRCLES.position(), boundCircles);
        }
        return kernel;
    }

    /** The position of an argument of a stage's kernel behind WORLD_PARAMETERS: 0 for the first. */
    public static int own(int argument) {
        return OWN_ARGUMENTS + argument;
    }

    /** Brings the shared arguments up to date. */
    public void bind(DeviceArrays arrays, int slots, int circles) {
        boolean replaced = boundVersion != arrays.version();
        bound = arrays;
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
