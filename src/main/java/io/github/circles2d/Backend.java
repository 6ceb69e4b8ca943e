package io.github.circles2d;

/** The back ends: a {@link World} runs on one of them. All give the same bits. */
public enum Backend {
    /**
     * Where frames are shortest, the JVM or a GPU; never OpenCL on a CPU, nor a device that does not round correctly. A world starts on the JVM
     * at once. From 1,250 circles on, or with a {@link World.Builder#capacity} of so many, a thread beside it opens a GPU and compiles kernels.
     * The world then moves between two steps, by the times of its own steps and reads: to where a frame takes at least a fifth less, and back
     * if that has changed. {@link World#stats()} says where it is, and why. If the GPU fails for good, its state is lost: the call throws,
     * and {@link World#restore} or {@link Rewind#restore} lets the world go on, on the JVM, from what the game has saved.
     *
     * <p>With {@link World.Builder#moving moving(false)} a world stays where it is built: on a GPU from a capacity of 1,250 on, if there is one.
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
