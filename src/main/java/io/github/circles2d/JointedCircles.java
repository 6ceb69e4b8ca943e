package io.github.circles2d;

/**
 * The circles and joints that {@link Ropes} and {@link Blobs} have added to a world. They are the world's, as any others: they are removed, changed
 * and asked by their handles.
 *
 * @param circles the handles of the circles, in the order that the call says
 * @param joints the handles of the joints, likewise
 */
public record JointedCircles(long[] circles, long[] joints) {}
