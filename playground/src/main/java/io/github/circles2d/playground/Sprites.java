package io.github.circles2d.playground;

/**
 * Sprites by radius and place in a pixel, both in quarters of a pixel, so that slow circles glide. Each is made when it is first
 * needed; those of large discs, which are few, are made each time.
 */
final class Sprites {
    static final int QUARTERS = 4;

    private static final int GREATEST_KEPT = 40;

    private final Sprite[] kept = new Sprite[(GREATEST_KEPT * QUARTERS + 1) * QUARTERS * QUARTERS];

    /**
     * The sprite of a disc.
     *
     * @param radius in pixels
     * @param shiftX where the centre is in its pixel, in quarters, 0 to 3
     * @param shiftY the same, downwards
     */
    Sprite get(double radius, int shiftX, int shiftY) {
        int quarters = (int) Math.round(radius * QUARTERS);
        if (quarters > GREATEST_KEPT * QUARTERS) {
            return make(quarters, shiftX, shiftY);
        }
        int key = (quarters * QUARTERS + shiftX) * QUARTERS + shiftY;
        if (kept[key] == null) {
            kept[key] = make(Math.max(quarters, 1), shiftX, shiftY);
        }
        return kept[key];
    }

    private static Sprite make(int quarters, int shiftX, int shiftY) {
        return new Sprite((double) quarters / QUARTERS, (shiftX + 0.5) / QUARTERS, (shiftY + 0.5) / QUARTERS);
    }
}
