import io.github.circles2d.Circles2D;
import io.github.circles2d.PairIndexing;

/** Fails unless the installed library computes a free fall as the closed form does, by every pair indexing. */
public class FreeFall {
    public static void main(String[] args) throws Exception {
        for (PairIndexing indexing : PairIndexing.values()) {
            try (Circles2D physics = new Circles2D(false)) {
                physics.addCircle(0.25f, 0.9f, 0.05f, 1);
                physics.addCircle(0.75f, 0.8f, 0.05f, 2);
                physics.init(1 / 60f, indexing, 0.5f, new float[] {0, -0.1f});
                float[][] circles = null;
                for (int step = 0; step < 60; step++) {
                    circles = physics.loop();
                }
                // After one second: half the acceleration lower.
                expect(circles[0][0], 0.25f);
                expect(circles[1][0], 0.85f);
                expect(circles[0][1], 0.75f);
                expect(circles[1][1], 0.75f);
                System.out.println(indexing + " on " + physics.device());
            }
        }
    }

    private static void expect(float actual, float expected) {
        if (!(Math.abs(actual - expected) <= 1e-4f)) {
            throw new AssertionError(actual + " where the closed form has " + expected);
        }
    }
}
