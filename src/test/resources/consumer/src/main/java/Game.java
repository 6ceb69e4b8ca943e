import io.github.circles2d.World;

public class Game {
    public static void main(String[] args) {
        try (World world = World.builder().bounds(0, 0, 80, 100).gravity(0, -10).restitution(0.5f).build()) {
            long ball = world.add(40, 90, 1, 2); // x, y, radius, mass; the handle stays valid until the ball is removed
            for (int i = 0; i < 100; i++) {
                world.add(31 + 2 * (i % 10), 1 + 2 * (i / 10), 0.9f, 1);
            }
            world.setVelocity(ball, 1, 0);
            for (int frame = 0; frame < 300; frame++) {
                world.step(1 / 60f);
                System.out.printf("frame %d: the ball is at (%.2f, %.2f)%n", frame, world.x(ball), world.y(ball));
            }
        }
    }
}
