package io.github.circles2d.reference;

/**
 * How an anchor moves in a step.
 *
 * @param ways of each boundary of sub-steps, from the first to the last one, how far it has come
 * @param velocities the velocity at each boundary
 */
record AnchorMotion(float[][] ways, float[][] velocities) {}
