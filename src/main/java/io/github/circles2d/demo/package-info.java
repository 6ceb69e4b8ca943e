/**
 * The demo {@link io.github.circles2d.demo.CirclesTest}: a window, or a picture file, that shows circles falling in the
 * unit square.
 *
 * <p>How one frame travels: {@code SimulationLoop} owns a thread of its own and, on it, a {@code DemoRun} that asks
 * an {@code Engine} for the next {@code float[4][n]}. The result becomes an immutable {@code DemoFrame}. {@code DemoCanvas},
 * on the event thread, hands the latest frame to {@code DemoPainter}, which fills discs into an int raster and draws the
 * overlay. {@code PictureRun} does the same without threads or a display and writes a file. Keys travel the other way, as
 * commands in the loop's queue: no simulation step ever runs on the event thread.
 */
package io.github.circles2d.demo;
