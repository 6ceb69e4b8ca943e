/**
 * The inside of {@link io.github.circles2d.Circles2D}; not meant for use from outside the library.
 *
 * <p>{@link io.github.circles2d.thesis.ThesisSimulation} holds the buffers and runs a step. How a work-item finds the pair of its
 * slot is a {@link io.github.circles2d.thesis.PairStrategy}, one class each, which knows its table and its two kernels.
 */
package io.github.circles2d.thesis;
