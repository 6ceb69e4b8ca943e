package io.github.circles2d.world.model;

/** How far circles look and go in continuous collision. r is a radius, path a length, top the greatest radius of others. */
public final class Paths {
    private Paths() {}

    /** Two circles become a contact if their centres are nearer than the sum of these. */
    public static float speculativeDistance(float r, float path) {
        return (r + Tuning.MARGIN * r) + CircleMath.min(path, Tuning.CAP * r);
    }

    /** It moves farther than its speculative distance covers, so it might come upon another unseen. */
    public static boolean isFast(float path, float r) {
        return path > Tuning.CAP * r;
    }

    /** The component p of a path, without what leads into a wall that the circle is at. */
    public static float besideWalls(float x, float p, float r, float min, float max) {
        float slack = r + Tuning.MARGIN * r;
        return p < 0f && x - min < slack || p > 0f && max - x < slack ? 0f : p;
    }

    /** Less than 1 for a path of very many radii. */
    public static float travelShare(float path, float r) {
        float most = Tuning.TRAVEL * r;
        return path > most ? most / path : 1f;
    }

    /** An eighth more than circles are away that it comes near to, for rounding: cells never decide. */
    public static float sightMargin(float r, float path, float top) {
        return 1.125f * ((r + top) + CircleMath.max(path, Tuning.CAP * top));
    }

    /** Of a circle that a static one looks out for; longest bounds all paths. */
    public static float carriedPath(float path, float longest, float top) {
        return CircleMath.min(path, longest) + Tuning.CAP * top;
    }

    /** The least x of a straight path with y from low to high; else of one of its ends. */
    public static float leastBetween(float x, float px, float y, float py, float low, float high) {
        float from = py == 0f ? 0f : CircleMath.clamp((low - y) / py, 0f, 1f);
        float to = py == 0f ? 1f : CircleMath.clamp((high - y) / py, 0f, 1f);
        return x + CircleMath.min(from * px, to * px);
    }

    public static float greatestBetween(float x, float px, float y, float py, float low, float high) {
        return -leastBetween(-x, -px, y, py, low, high);
    }

    /** Not for one so much smaller that a fast circle would push it aside. */
    public static boolean sweeps(float r, float other) {
        return other * Tuning.SWEEP_RATIO >= r;
    }

    /** Whether some path in a range differs by more than a length; not for an empty range. */
    public static boolean differ(float px, float py, float lowX, float highX, float lowY, float highY, float length) {
        if (lowX > highX) {
            return false;
        }
        float ux = CircleMath.max(px - lowX, highX - px);
        float uy = CircleMath.max(py - lowY, highY - py);
        return ux * ux + uy * uy > length * length;
    }

    /** How far it may leave its path: as far as it flies back, hardly at a static or a smaller circle. */
    public static float holdAllowance(float r, float path, float other, boolean isStatic) {
        if (isStatic) {
            return Tuning.CLAMP_ALLOWANCE * r;
        }
        return other < r ? Tuning.CLAMP_ALLOWANCE * other : CircleMath.clamp(path, Tuning.CLAMP_ALLOWANCE * r, r);
    }

    /** Where on a path a displacement is nearest, as a share from 0 to 1. */
    public static float nearest(float dx, float dy, float px, float py) {
        float square = px * px + py * py;
        return square > 0f ? CircleMath.clamp((dx * px + dy * py) / square, 0f, 1f) : 0f;
    }

    /** The same, not limited. */
    public static float alongPath(float dx, float dy, float px, float py) {
        float square = px * px + py * py;
        return square > 0f ? (dx * px + dy * py) / square : 0f;
    }
}
