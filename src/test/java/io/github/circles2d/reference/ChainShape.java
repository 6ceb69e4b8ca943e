package io.github.circles2d.reference;

/**
 * The form of a chain.
 *
 * @param x of the first point
 * @param y of the first point
 * @param ways for each piece, the end of a line: x, y; or the centre of an arc and the angle that it turns around it: x, y, angle
 * @param closed whether the last point is joined to the first
 */
public record ChainShape(float x, float y, float[][] ways, boolean closed) {}
