package io.github.circles2d.scenes;

/** The circles of scenes with joints, which fit in the unit arena; gravity (0, -1) if they fall. */
public final class JointedScenes {
    private JointedScenes() {}

    /** A bridge: a row of planks from wall to wall, a boulder above its middle, and rows of balls above that. */
    public static Scene bridge(int planks, int balls) {
        Scene.Builder b = new Scene.Builder("bridge", planks + 1 + balls).gravity(0, -1);
        float link = 1f / (planks + 1);
        for (int i = 0; i < planks; i++) {
            b.circle(i, (i + 1) * link, 0.4f, 0.45f * link, 1);
        }
        b.circle(planks, 0.52f, 0.5f, 0.07f, 60);
        for (int i = 0; i < balls; i++) {
            b.circle(planks + 1 + i, 0.1f + 0.02f * (i % 40) + 0.001f * (i % 7), 0.6f + 0.02f * (i / 40), 0.007f, 0.2f);
        }
        return b.build();
    }

    /** Blobs: rings of circles, side by side in rows. */
    public static Scene blobs(int blobs, int circles) {
        Scene.Builder b = new Scene.Builder("blobs", blobs * circles).gravity(0, -1);
        for (int i = 0; i < blobs * circles; i++) {
            int blob = i / circles;
            double a = 2 * StrictMath.PI * (i % circles) / circles;
            float x = 0.31f + 0.022f * (blob % 18) + 0.008f * (float) StrictMath.cos(a);
            float y = 0.56f + 0.022f * (blob / 18) + 0.008f * (float) StrictMath.sin(a);
            b.circle(i, x, y, 0.0028f, 1 + blob % 3);
        }
        return b.build();
    }

    /** Ropes that start level, one above the other, to the left and to the right; the last link is heavy. */
    public static Scene ropes(int ropes, int links) {
        Scene.Builder b = new Scene.Builder("ropes", ropes * links).gravity(0, -1);
        for (int i = 0; i < ropes * links; i++) {
            int rope = i / links;
            int link = i % links;
            float way = 0.4f / links * (link + 1);
            float x = 0.5f + (rope % 2 == 0 ? way : -way);
            b.circle(i, x, 0.5f + 0.45f * rope / ropes, 0.006f, link == links - 1 ? 1 + rope : 1);
        }
        return b.build();
    }

    /** A wheel: a hub with circles around it, all of which turn about it. */
    public static Scene wheel(int spokes) {
        Scene.Builder b = new Scene.Builder("wheel", 1 + spokes);
        b.circle(0, 0.5f, 0.5f, 0.05f, 10);
        for (int k = 0; k < spokes; k++) {
            float c = (float) StrictMath.cos(2 * StrictMath.PI * k / spokes);
            float s = (float) StrictMath.sin(2 * StrictMath.PI * k / spokes);
            b.circle(1 + k, 0.5f + 0.35f * c, 0.5f + 0.35f * s, 0.007f, 1);
            b.velocity(1 + k, -0.5f * s, 0.5f * c);
        }
        return b.build();
    }

    /** Carts: two wheels each, and a small load above them. */
    public static Scene carts(int carts) {
        Scene.Builder b = new Scene.Builder("carts", 3 * carts).gravity(0, -1);
        for (int i = 0; i < 3 * carts; i++) {
            int cart = i / 3;
            float x = 0.06f + 0.11f * (cart % 8) + 0.022f * (i % 3);
            float y = 0.3f + 0.12f * (cart / 8) + (i % 3 == 1 ? 0.025f : 0);
            b.circle(i, x, y, i % 3 == 1 ? 0.008f : 0.012f, i % 3 == 1 ? 3 : 1);
        }
        return b.build();
    }
}
