package io.github.circles2d.playground;

import java.util.Arrays;

/** Filled outlines, one after the other. They keep their arrays. */
final class Polygons {
    private int count;
    private int points;
    private float[] point = new float[0];

    /** By polygon: its first point behind it. */
    private int[] end = new int[0];

    private int[] colour = new int[0];

    /** Takes over what another one has. */
    void copy(Polygons from) {
        count = from.count;
        points = from.points;
        if (end.length < count) {
            end = new int[from.end.length];
            colour = new int[from.end.length];
        }
        if (point.length < 2 * points) {
            point = new float[from.point.length];
        }
        System.arraycopy(from.end, 0, end, 0, count);
        System.arraycopy(from.colour, 0, colour, 0, count);
        System.arraycopy(from.point, 0, point, 0, 2 * points);
    }

    /** Takes all away. */
    void clear() {
        count = 0;
        points = 0;
    }

    /** Begins a polygon; its points follow. */
    void begin(int rgb) {
        if (count == end.length) {
            end = Arrays.copyOf(end, 2 * count + 8);
            colour = Arrays.copyOf(colour, 2 * count + 8);
        }
        colour[count] = rgb;
        end[count++] = points;
    }

    /** Adds a point to the last polygon. */
    void add(float x, float y) {
        if (point.length == 2 * points) {
            point = Arrays.copyOf(point, 4 * points + 16);
        }
        point[2 * points] = x;
        point[2 * points + 1] = y;
        end[count - 1] = ++points;
    }

    int count() {
        return count;
    }

    int colour(int polygon) {
        return colour[polygon];
    }

    /** The first point of a polygon; behind the last polygon, the number of all points. */
    int from(int polygon) {
        return polygon == 0 ? 0 : end[polygon - 1];
    }

    float x(int which) {
        return point[2 * which];
    }

    float y(int which) {
        return point[2 * which + 1];
    }
}
