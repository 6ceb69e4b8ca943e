/** The pipeline on an OpenCL device: its arrays, the stages as kernels in {@code kernels/world}, and the plans of steps. Not part of the public API. */
package io.github.circles2d.world.device;
