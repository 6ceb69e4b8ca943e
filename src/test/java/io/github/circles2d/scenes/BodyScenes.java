package io.github.circles2d.scenes;

/** The circles of scenes with bodies that are pushed, which fit in the unit arena; gravity (0, -1). */
public final class BodyScenes {
    private BodyScenes() {}

    /** A ball that comes from the left. */
    public static Scene ball() {
        Scene.Builder b = new Scene.Builder("ball", 1).gravity(0, -1);
        b.circle(0, 0.06f, 0.1f, 0.04f, 0.004f);
        b.velocity(0, 0.8f, 0f);
        return b.build();
    }

    /** Balls of two sizes in the lower part of the arena. */
    public static Scene pit() {
        int balls = 160;
        Scene.Builder b = new Scene.Builder("pit", balls).gravity(0, -1);
        for (int i = 0; i < balls; i++) {
            float r = i % 9 == 4 ? 0.026f : 0.012f;
            b.circle(i, 0.05f + 0.058f * (i % 16) + 0.001f * (i % 5), 0.03f + 0.056f * (i / 16), r, 700 * r * r);
        }
        return b.build();
    }

    /** A few circles from small to large, one of which is static, and restitutions of all kinds. */
    public static Scene mixed() {
        int circles = 40;
        Scene.Builder b = new Scene.Builder("mixed", circles).gravity(0, -1);
        float[] restitutions = new float[circles];
        for (int i = 0; i < circles; i++) {
            float r = i % 10 == 0 ? 0.04f : 0.004f + 0.001f * (i % 7);
            float mass = i == 20 ? Float.POSITIVE_INFINITY : 900 * r * r;
            b.circle(i, 0.06f + 0.095f * (i % 10), 0.06f + 0.24f * (i / 10), r, mass);
            b.velocity(i, 0.3f - 0.02f * i, 0.1f * (i % 3));
            restitutions[i] = 0.25f * (i % 5);
        }
        b.velocity(20, 0.1f, 0f);
        return b.restitutions(restitutions).build();
    }

    /** A boulder above a few balls. */
    public static Scene boulder() {
        int balls = 12;
        Scene.Builder b = new Scene.Builder("boulder", balls + 1).gravity(0, -1);
        b.circle(0, 0.45f, 0.88f, 0.08f, 10);
        for (int i = 1; i <= balls; i++) {
            b.circle(i, 0.04f + 0.075f * i, 0.06f, 0.012f, 0.2f);
        }
        return b.build();
    }
}
