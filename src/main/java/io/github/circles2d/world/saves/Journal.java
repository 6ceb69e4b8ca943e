package io.github.circles2d.world.saves;

import io.github.circles2d.world.log.LogWriter;
import io.github.circles2d.world.shared.WorldParts;
import java.io.IOException;
import java.io.OutputStream;

/** The calls that begin and end a log of calls. */
public final class Journal {
    /** How far a log has come, also when it has ended. */
    public static final class Progress {
        private final LogWriter log;

        Progress(LogWriter log) {
            this.log = log;
        }

        public long steps() {
            return log.steps();
        }

        public long bytes() {
            return log.bytes();
        }

        /** Whether the log could not be written on. */
        public boolean hasFailed() {
            return log.failure() != null;
        }
    }

    private final WorldParts world;

    public Journal(WorldParts world) {
        this.world = world;
    }

    /** Begins a log with a snapshot of now, and a hash every so many steps, until {@link #stop}. Does not close the stream. */
    public Progress start(OutputStream out, int every) throws IOException {
        world.guard.enter();
        try (world.guard) {
            if (world.log.writer() != null) {
                throw new IllegalStateException("this World is being recorded already");
            }
            LogWriter writer = new LogWriter(out, every);
            world.log.write(world.copies.saved(), writer);
            writer.requireWritten("the log cannot begin");
            Progress progress = new Progress(writer);
            world.log.begin(writer, every); // last: a call that finds no room has begun no log
            return progress;
        }
    }

    /** Ends the log, with a last hash if the state is there. Also if the world has been closed. */
    public void stop() throws IOException {
        world.guard.takeTurn();
        try (world.guard) {
            LogWriter last = world.log.writer();
            if (last != null) {
                try {
                    if (world.guard.holds()) {
                        world.pending.apply();
                        world.log.writeHash();
                    }
                } finally {
                    world.log.end();
                    last.close();
                }
            }
        }
    }

    /** Closes the stream that a log has been written to. */
    public static void closeStream(OutputStream out) throws IOException {
        try {
            out.close();
        } catch (IOException | RuntimeException e) {
            throw LogWriter.failed("the stream of the log cannot be closed", e);
        }
    }
}
