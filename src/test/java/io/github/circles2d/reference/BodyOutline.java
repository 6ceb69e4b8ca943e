package io.github.circles2d.reference;

/**
 * The outline of a body that is pushed, as callers draw it.
 *
 * @param chain a closed chain
 * @param rounding of the corners between lines; NaN for the usual one
 */
public record BodyOutline(ChainShape chain, float rounding) {
    public static BodyOutline box(float width, float height) {
        float x = width / 2;
        float y = height / 2;
        return polygon(-x, -y, x, -y, x, y, -x, y);
    }

    public static BodyOutline polygon(float... points) {
        float[][] ways = new float[points.length / 2 - 1][];
        for (int k = 0; k < ways.length; k++) {
            ways[k] = new float[] {points[2 * k + 2], points[2 * k + 3]};
        }
        return closed(points[0], points[1], ways);
    }

    public static BodyOutline capsule(float length, float radius) {
        float x = length / 2;
        float half = (float) Math.PI;
        return closed(-x, -radius, new float[][] {{x, -radius}, {x, 0f, half}, {-x, radius}, {-x, 0f, half}});
    }

    /** Two arcs of a quarter of a turn. */
    public static BodyOutline lens(float length) {
        float half = 0.5f * length;
        float quarter = 0.5f * (float) Math.PI;
        return closed(-half, 0f, new float[] {0f, half, quarter}, new float[] {0f, -half, quarter});
    }

    /** By the ways of a {@link ChainShape}. */
    public static BodyOutline closed(float x, float y, float[]... ways) {
        return new BodyOutline(new ChainShape(x, y, ways, true), Float.NaN);
    }

    public BodyOutline round(float radius) {
        return new BodyOutline(chain, radius);
    }
}
