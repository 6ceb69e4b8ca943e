package io.github.circles2d;

/** The back ends: a {@link World} runs on one of them. All give the same bits. */
public enum Backend {
    /**
     * The back end that is likely to be the fastest for a world with the {@link World.Builder#capacity} and the {@link
     * World.Builder#radii} given: the JVM or a GPU, never OpenCL on a CPU. If a {@link Calibration} has measured both, AUTO takes the
     * one with the shorter frame (a step and a read of all circles). Without a calibration it takes a GPU, if there is one, from a
     * capacity of 1,250 circles on, else the JVM. It never takes a device that does not round correctly.
     * {@link World#stats()} says which back end was taken, and why. The log says it once if the capacity asks for a GPU and none can be used.
     */
    AUTO,
    /** Plain Java threads, the fast way on processors: runs everywhere, needs no driver. */
    JVM,
    /**
     * OpenCL on a CPU: the kernels that GPUs run, for tests and for people who write kernels. A step takes several times as long as
     * with {@link #JVM}, which is the fast way on processors.
     */
    OPENCL_CPU,
    /** OpenCL on a GPU. {@link World#stats()} gives other accelerators this name, too. */
    OPENCL_GPU
}
