package io.github.circles2d.scenes;

/**
 * Finds every overlapping pair of circles once. Circles are sorted into levels by radius, a factor of two each, and each
 * level into a hashed grid whose cells are as wide as its greatest diameter. A circle then looks at 3 x 3 cells of its own
 * level and of each coarser one: whatever it overlaps there lies in them.
 */
final class Overlaps {
    /** The last level holds all that is smaller than a millionth of the greatest radius. */
    private static final int LEVELS = 20;

    /** Cell numbers stop here, far beyond any arena: circles flung out there share cells, which is slow but not wrong. */
    private static final double FAR = 1L << 40;

    /** Takes each pair once, with the index of the circle that was looked at first, and the overlap, greater than 0. */
    interface Visitor {
        void pair(int i, int j, double overlap);
    }

    private final float[] x;
    private final float[] y;
    private final float[] radius;
    private final Level[] levels = new Level[LEVELS];
    private final byte[] levelOf;

    Overlaps(float[] x, float[] y, float[] radius, int n) {
        this.x = x;
        this.y = y;
        this.radius = radius;
        float greatest = 0;
        for (int i = 0; i < n; i++) {
            greatest = Math.max(greatest, radius[i]);
        }
        levelOf = new byte[n];
        int[] counts = new int[LEVELS];
        float[] greatestOf = new float[LEVELS];
        for (int i = 0; i < n; i++) {
            int level = 0;
            while (level < LEVELS - 1 && radius[i] * (float) (2 << level) <= greatest) {
                level++;
            }
            levelOf[i] = (byte) level;
            counts[level]++;
            greatestOf[level] = Math.max(greatestOf[level], radius[i]);
        }
        for (int level = 0; level < LEVELS; level++) {
            if (counts[level] > 0) {
                levels[level] = new Level(level, counts[level], 2.0 * greatestOf[level]);
            }
        }
    }

    /** Visits every pair whose circles overlap, in an order that depends on the state alone. */
    void forEach(Visitor visitor) {
        for (int i = 0; i < levelOf.length; i++) {
            for (int level = 0; level <= levelOf[i]; level++) {
                if (levels[level] != null) {
                    levels[level].visit(i, level == levelOf[i], visitor);
                }
            }
        }
    }

    /** The grid of one level: a counting sort of its circles by the hash of their cell. */
    private final class Level {
        private final double edge;
        private final int mask;
        private final int[] starts;
        private final int[] sorted;

        Level(int level, int count, double edge) {
            this.edge = edge;
            int buckets = Integer.highestOneBit(count) * 2;
            mask = buckets - 1;
            starts = new int[buckets + 1];
            sorted = new int[count];
            for (int i = 0; i < levelOf.length; i++) {
                if (levelOf[i] == level) {
                    starts[bucket(cell(x[i]), cell(y[i])) + 1]++;
                }
            }
            for (int b = 0; b < buckets; b++) {
                starts[b + 1] += starts[b];
            }
            int[] cursor = starts.clone();
            for (int i = 0; i < levelOf.length; i++) {
                if (levelOf[i] == level) {
                    sorted[cursor[bucket(cell(x[i]), cell(y[i]))]++] = i;
                }
            }
        }

        private long cell(float p) {
            return (long) Math.floor(Math.max(-FAR, Math.min(FAR, p / edge)));
        }

        private int bucket(long cx, long cy) {
            long mixed = cx * 0x9E3779B97F4A7C15L + cy * 0xC2B2AE3D27D4EB4FL;
            return (int) (mixed ^ mixed >>> 32) & mask;
        }

        void visit(int i, boolean own, Visitor visitor) {
            long cx = cell(x[i]);
            long cy = cell(y[i]);
            for (long v = cy - 1; v <= cy + 1; v++) {
                for (long u = cx - 1; u <= cx + 1; u++) {
                    visitCell(i, own, u, v, visitor);
                }
            }
        }

        private void visitCell(int i, boolean own, long u, long v, Visitor visitor) {
            int bucket = bucket(u, v);
            for (int k = starts[bucket]; k < starts[bucket + 1]; k++) {
                int j = sorted[k];
                // Within its own level a pair is seen from both sides, and cells may share a bucket: count it once.
                if (own && j <= i || cell(x[j]) != u || cell(y[j]) != v) {
                    continue;
                }
                double dx = (double) x[j] - x[i];
                double dy = (double) y[j] - y[i];
                double reach = (double) radius[i] + radius[j];
                double square = dx * dx + dy * dy;
                if (square < reach * reach) {
                    visitor.pair(i, j, reach - Math.sqrt(square));
                }
            }
        }
    }
}
