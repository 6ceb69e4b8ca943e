package io.github.circles2d.demo;

/**
 * One finished frame: what there is to draw and what the overlay says about it. It is handed from the simulation's
 * thread to the event thread, so nothing in it changes any more.
 *
 * @param circles         {@code float[4][n]}: x, y, radius, mass
 * @param number          frames since the start
 * @param engine          name of the engine
 * @param device          name of its device
 * @param strategy        name of the strategy in use
 * @param loopMillis      milliseconds that a call of the engine takes, a running mean; 0 before the first
 * @param framesPerSecond frames a second, over the last second or so; 0 where there is nothing to measure yet
 * @param paused          whether the simulation waits
 * @param message         a remark for the person at the screen, or the empty string
 */
record DemoFrame(
        float[][] circles,
        long number,
        String engine,
        String device,
        String strategy,
        double loopMillis,
        double framesPerSecond,
        boolean paused,
        String message) {

    int size() {
        return circles[0].length;
    }
}
