package io.github.circles2d.check;

import io.github.circles2d.Backend;
import io.github.circles2d.Edge;
import io.github.circles2d.Recording;
import io.github.circles2d.Replay;
import io.github.circles2d.World;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;

/** Logs that one platform writes and another replays. */
final class Logs {
    private static final int HASH_EVERY = 10;

    private Logs() {}

    /** The log of a game in which circles come, are pushed and fall another way. */
    static byte[] record() {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        try (World world = Check.world(Edge.WRAP, Edge.OPEN, 300, 9, 30)) {
            Recording recording = new Recording(world, log, HASH_EVERY);
            for (int step = 0; step < 120; step++) {
                if (step % 30 == 3) {
                    world.explode(0, 0, 20, 10, 1);
                    world.add(0, 0, 1, 2);
                    world.setGravity(0, step);
                }
                world.step(1 / 60f);
            }
            recording.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return log.toByteArray();
    }

    /** Replays a log, and says how many steps it has, whether one differs and what the hash is at the end. */
    static String replay(byte[] log) {
        try (World world = World.builder().backend(Backend.JVM).build()) {
            Replay replay = new Replay(new ByteArrayInputStream(log), world).run();
            String differs = replay.differs() ? "differs" : "same";
            return replay.steps() + " " + differs + " " + Long.toHexString(world.hash());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
