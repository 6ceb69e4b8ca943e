/**
 * The ground under both engines: devices, sessions, buffers, kernels. The only room that imports JavaCL and BridJ.
 *
 * <p>{@link io.github.circles2d.opencl.OpenCl} finds devices. A {@link io.github.circles2d.opencl.Session} opens one of
 * them and hands out {@link io.github.circles2d.opencl.DeviceBuffer buffers}, {@link
 * io.github.circles2d.opencl.HostBuffer transfer memory} and {@link io.github.circles2d.opencl.Program programs};
 * closing it closes them all, in the right order. Everything that goes wrong surfaces as an {@link
 * io.github.circles2d.opencl.OpenClException} or one of its subtypes, never as a linkage error or a bare error code.
 *
 * <p>Nothing here knows of circles, and nothing here imports the rooms above it.
 */
package io.github.circles2d.opencl;
