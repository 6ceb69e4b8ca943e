package io.github.circles2d;

/** What a {@link World} runs on. Every back end gives the same bits. */
public enum Backend {
    /**
     * The one that is likely to be the fastest for a world with the {@link World.Builder#capacity} and the {@link
     * World.Builder#radii} given. Where a {@link Calibration} has measured the JVM and the devices, it is the one with the shortest
     * frame, a step and a read of all circles. Elsewhere, by rule, it is a GPU from a capacity of 1,250 circles on, where there is one, else the JVM; never
     * OpenCL on a CPU, which compiles for seconds at its first start. Devices that do not round correctly are never taken.
     * {@link World#stats()} says which one was taken, and why; the log says it the first time.
     */
    AUTO,
    /** Plain Java threads: runs everywhere, needs no driver. */
    JVM,
    /** OpenCL on a CPU. */
    OPENCL_CPU,
    /** OpenCL on a GPU; {@link World#stats()} calls other accelerators so, too. */
    OPENCL_GPU
}
