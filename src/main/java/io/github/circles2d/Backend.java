package io.github.circles2d;

/** What a {@link World} runs on. Every back end gives the same bits. */
public enum Backend {
    /** The fastest one that is there; {@link World#stats()} says which one was taken, and why. */
    AUTO,
    /** Plain Java threads: runs everywhere, needs no driver. */
    JVM,
    /** OpenCL on a CPU. */
    OPENCL_CPU,
    /** OpenCL on a GPU. */
    OPENCL_GPU
}
