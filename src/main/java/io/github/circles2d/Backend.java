package io.github.circles2d;

/** What a {@link World} runs on. Every back end gives the same bits. */
public enum Backend {
    /**
     * The one that is likely to be the fastest: a GPU for worlds with a {@link World.Builder#capacity} of 2,048 circles or more,
     * where there is one that rounds correctly, else the JVM. Never OpenCL on a CPU, which takes longer than the JVM does.
     * {@link World#stats()} says which one was taken, and why.
     */
    AUTO,
    /** Plain Java threads: runs everywhere, needs no driver. */
    JVM,
    /** OpenCL on a CPU. */
    OPENCL_CPU,
    /** OpenCL on a GPU; {@link World#stats()} calls other accelerators so, too. */
    OPENCL_GPU
}
