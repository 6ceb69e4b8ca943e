package io.github.circles2d;

/** What a {@link World} runs on. Every back end gives the same bits. */
public enum Backend {
    /**
     * The one that is likely to be the fastest for a world with the {@link World.Builder#capacity} and the {@link
     * World.Builder#radii} given: the JVM or a GPU, never OpenCL on a CPU. If a {@link Calibration} has measured both, it is the one
     * with the shortest frame, a step and a read of all circles. Without one it is a GPU, if there is one, from a capacity of 1,250
     * circles on, else the JVM. Devices that do not round correctly are never taken.
     * {@link World#stats()} says which one was taken, and why; the log says it the first time.
     */
    AUTO,
    /** Plain Java threads, the fast way on processors: runs everywhere, needs no driver. */
    JVM,
    /**
     * OpenCL on a CPU: the kernels that GPUs run, for tests and for people who write kernels. A step takes several times as long as
     * with {@link #JVM}, which is the fast way on processors.
     */
    OPENCL_CPU,
    /** OpenCL on a GPU; {@link World#stats()} calls other accelerators so, too. */
    OPENCL_GPU
}
