import io.github.circles2d.Circles2D;

public class Game {
    public static void main(String[] args) throws Exception {
        try (Circles2D physics = new Circles2D(true)) { // on the best device: a GPU where there is one
            for (int i = 0; i < 100; i++) {
                physics.addCircle(0.05f + 0.1f * (i % 10), 0.05f + 0.1f * (i / 10), 0.03f, 1); // x, y, radius, mass
            }
            physics.init(1 / 60f, 3, 0.5f, new float[] {0.2f, -1}); // time step, strategy, restitution, gravity
            for (int frame = 0; frame < 300; frame++) {
                float[][] circles = physics.loop(); // a new array each frame: rows x, y, radius, mass
                System.out.printf("frame %d: the first circle is at (%.3f, %.3f)%n", frame, circles[0][0], circles[1][0]);
            }
        }
    }
}
