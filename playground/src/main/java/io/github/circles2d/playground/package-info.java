/**
 * The playground: a window on a {@link io.github.circles2d.World} to play with, and what it is made of.
 *
 * <p>How a frame travels: {@code SessionLoop} has a thread, and on it a {@code Session}, which has a {@code Sandbox} (a world, its loop and
 * its past) and a {@code Hand} (the tools). Sixty times a second the session makes the steps that are due and fills a {@code Frame} by a
 * {@code Readout}. A {@code FrameExchange} hands it to the event thread, where {@code PlaygroundCanvas} has a {@code Painter} draw it.
 * Mouse and keys travel the other way, as commands that wait for the next frame. So the event thread waits for no step, and no world
 * is seen half changed.
 *
 * <p>{@code Film} and {@code Playground} use a session without a thread or a display. Another tool joins by implementing {@code Tool} and
 * taking its place in {@code ToolKind} and {@code Hand}; another start by its place in {@code Stages}.
 */
package io.github.circles2d.playground;
