package io.github.circles2d.fuzz;

import io.github.circles2d.Rollback;
import io.github.circles2d.World;
import java.nio.ByteBuffer;

/** A game without a state: the inputs of its players push circles. */
final class Pushes implements Rollback.Game {
    private final Player player;

    Pushes(Player player) {
        this.player = player;
    }

    @Override
    public void beforeStep(int frame, long[] inputs) {
        World world = player.world;
        Object drawn = draw(frame % 3);
        for (long input : inputs) {
            int id = (int) (input >>> 8 & 0xFF);
            long handle = id < world.idLimit() ? world.handle(id) : 0;
            if (handle != 0) {
                world.applyImpulse(handle, (byte) input, drawn.hashCode() % 7);
            }
        }
    }

    private Object draw(int which) {
        try {
            return switch (which) {
                case 0 -> player.api.named(player.rollback, "randomLong");
                case 1 -> player.api.named(player.rollback, "randomInt", 9);
                default -> player.api.named(player.rollback, "randomFloat");
            };
        } catch (Error e) { // memory that ends
            throw e;
        } catch (Throwable e) {
            throw new AssertionError(e);
        }
    }

    @Override
    public void save(ByteBuffer to) {
        // it has no state
    }

    @Override
    public void restore(ByteBuffer from) {
        // it has no state
    }
}
