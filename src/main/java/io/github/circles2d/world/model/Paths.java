package io.github.circles2d.world.model;

/** How far circles look and go in continuous collision. r is a radius, path a length, top the greatest radius of others. */
public final class Paths {
    private Paths() {}

    /** Circles nearer than the sum of theirs become a contact. */
    public static float speculativeDistance(float r, float path) {
        return (r + Tuning.MARGIN * r) + CircleMath.min(path, Tuning.CAP * r);
    }

    /** How far from its centre a circle may touch terrain in a step: with its free path, and as far off it as others may push it. */
    public static float sight(float r, float path) {
        return (r + Tuning.MARGIN * r) + (path + r); // no allowance is greater than the radius
    }

    /** May meet others unseen. */
    public static boolean isFast(float path, float r) {
        return path > Tuning.CAP * r;
    }

    /** A component without what leads into a wall at the circle. */
    public static float besideWalls(float x, float p, float r, float min, float max) {
        float slack = r + Tuning.MARGIN * r;
        return p < 0f && x - min < slack || p > 0f && max - x < slack ? 0f : p;
    }

    public static float travelShare(float path, float r) {
        float most = Tuning.TRAVEL * r;
        return path > most ? most / path : 1f;
    }

    /** An eighth more than needed, for rounding: cells never decide. */
    public static float sightMargin(float r, float path, float top) {
        return 1.125f * ((r + top) + CircleMath.max(path, Tuning.CAP * top));
    }

    /** Of a circle that a static one looks out for. */
    public static float carriedPath(float path, float longest, float top) {
        return CircleMath.min(path, longest) + Tuning.CAP * top;
    }

    /** The least x of a path with y from low to high; else of an end. */
    public static float leastBetween(float x, float px, float y, float py, float low, float high) {
        float from = py == 0f ? 0f : CircleMath.clamp((low - y) / py, 0f, 1f);
        float to = py == 0f ? 1f : CircleMath.clamp((high - y) / py, 0f, 1f);
        return x + CircleMath.min(from * px, to * px);
    }

    public static float greatestBetween(float x, float px, float y, float py, float low, float high) {
        return -leastBetween(-x, -px, y, py, low, high);
    }

    /** Much smaller ones are pushed aside. */
    public static boolean sweeps(float r, float other) {
        return other * Tuning.SWEEP_RATIO >= r;
    }

    /** How deep circles may get that only graze each other: measured by the smaller one, or it would end within a far larger one. */
    public static float deepestGraze(float r, float other) {
        return (2f * Tuning.GRAZE) * CircleMath.min(r, other);
    }

    /** Whether a path in the range differs by more than a length. */
    public static boolean differ(float px, float py, float lowX, float highX, float lowY, float highY, float length) {
        if (lowX > highX) {
            return false;
        }
        float ux = CircleMath.max(px - lowX, highX - px);
        float uy = CircleMath.max(py - lowY, highY - py);
        return ux * ux + uy * uy > length * length;
    }

    /** As far as it flies back, hardly at a static or a smaller circle; in a dull hit, no farther than the other may be flung. */
    public static float holdAllowance(float r, float path, float other, boolean isStatic, boolean isDull) {
        if (isStatic) {
            return Tuning.CLAMP_ALLOWANCE * r;
        }
        float least = Tuning.CLAMP_ALLOWANCE * CircleMath.min(r, other);
        return other < r || isDull ? least : CircleMath.clamp(path, least, r);
    }

    /** The share of a path, from 0 to 1, where a displacement is nearest. */
    public static float nearest(float dx, float dy, float px, float py) {
        return CircleMath.clamp(alongPath(dx, dy, px, py), 0f, 1f);
    }

    /** Not limited to the path. */
    public static float alongPath(float dx, float dy, float px, float py) {
        float square = px * px + py * py;
        return square > 0f ? (dx * px + dy * py) / square : 0f;
    }
}
