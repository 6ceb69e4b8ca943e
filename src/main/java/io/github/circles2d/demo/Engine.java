package io.github.circles2d.demo;

import java.util.List;

/**
 * What the demo needs of a physics engine: the circles of the next frame, a start to go back to, and the ways of
 * working between which a person may switch.
 *
 * <p>The arena is the unit square, y up. An engine is opened, used and closed by one thread.
 *
 * <p>{@code Circles2DEngine} is the engine of the demo. Tests put another in its place, which needs no device.
 */
interface Engine extends AutoCloseable {

    /**
     * Advances by one frame and returns a new {@code float[4][n]}: x, y, radius, mass. The caller may keep it: it is
     * never written again.
     *
     * @throws EngineException if the device fails
     */
    float[][] loop() throws EngineException;

    /** The circles as they are now, in the shape that {@link #loop} returns, without advancing. */
    float[][] circles();

    /**
     * Puts every circle back to where it was when the engine was opened. The strategy stays.
     *
     * @throws EngineException if the device fails
     */
    void restart() throws EngineException;

    /** The engine's name, for people. */
    String name();

    /** The device that it runs on, for people. */
    String device();

    /** The ways of working, named for people, in the order of their numbers 0, 1, 2, ... */
    List<String> strategies();

    /** The number of the strategy in use. */
    int strategy();

    /**
     * Goes on with another strategy; the circles keep their places and velocities.
     *
     * @throws EngineException if that strategy cannot run here; the present one then stays in use
     */
    void switchTo(int strategy) throws EngineException;

    /** A remark on the present strategy that a person should read, or the empty string. */
    String remark();

    @Override
    void close();
}
