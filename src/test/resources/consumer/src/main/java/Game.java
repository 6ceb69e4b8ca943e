import io.github.circles2d.World;

public class Game {
    public static void main(String[] args) {
        try (World world = World.builder().bounds(0, 0, 80, 100).gravity(0, -10).restitution(0.5f).build()) {
            long ball = world.add(40, 90, 1, 2); // x, y, radius, mass; the handle stays valid until the ball is removed
            for (int i = 0; i < 100; i++) {
                world.add(31 + 2 * (i % 10), 1 + 2 * (i / 10), 0.9f, 1);
            }
            world.setVelocity(ball, 1, 0);
            float[] circles = {};
            int k = 4 * World.id(ball); // where the ball is in the array, whichever other circles are removed
            for (int frame = 0; frame < 300; frame++) {
                if (frame % 60 == 59) {
                    world.add(40, 90, 0.9f, 1);
                }
                world.step(1 / 60f);
                if (circles.length < 4 * world.idLimit()) { // at first, and when circles have been added
                    circles = new float[8 * world.idLimit()];
                }
                world.readById(circles, null); // x, y, radius, mass of every circle, one bulk copy
                System.out.printf("frame %d: the ball is at (%.2f, %.2f)%n", frame, circles[k], circles[k + 1]);
            }
        }
    }
}
