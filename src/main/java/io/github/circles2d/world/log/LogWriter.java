package io.github.circles2d.world.log;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Writes a log to a stream, block by block, without garbage. It throws nothing if the stream fails: it remembers the failure and writes
 * no more, so the game goes on.
 */
public final class LogWriter {
    private final OutputStream out;
    private final ByteBuffer calls = ByteBuffer.allocate(LogFormat.CALLS_BYTES).order(ByteOrder.LITTLE_ENDIAN);
    private final ByteBuffer head = ByteBuffer.allocate(LogFormat.BLOCK_HEAD).order(ByteOrder.LITTLE_ENDIAN);
    private long bytes;

    /** Steps whose calls are in blocks that the stream has taken. */
    private long steps;

    /** Steps whose calls wait for the next block. */
    private long waitingSteps;

    private Throwable failure;

    /** Whether a call is being written. If it stays true, writing has ended half-way, and the log is not to be trusted. */
    private boolean writing;

    /** Writes the header; does not close the stream. */
    public LogWriter(OutputStream out, int hashEvery) {
        this.out = out;
        ByteBuffer header = ByteBuffer.allocate(LogFormat.HEADER).order(ByteOrder.LITTLE_ENDIAN);
        header.putInt(LogFormat.MAGIC).putInt(LogFormat.VERSION).putInt(hashEvery);
        try {
            out.write(header.array());
            bytes = LogFormat.HEADER;
        } catch (IOException | RuntimeException | Error e) {
            fail(e);
        }
    }

    /** Why no more is written; null if nothing has failed. */
    public Throwable failure() {
        return failure;
    }

    /** Throws if writing has failed, with a message that begins so. */
    public void requireWritten(String what) throws IOException {
        if (failure != null) {
            throw failed(what, failure);
        }
    }

    /** The exception that tells of a failure: by its message, or by its class if it has none. */
    public static IOException failed(String what, Throwable failure) {
        String message = failure.getMessage();
        boolean silent = message == null || message.isBlank();
        return new IOException(what + ": " + (silent ? failure.getClass().getName() : message), failure);
    }

    /** Takes note of a failure, after which no more is written. */
    public void fail(Throwable cause) {
        if (failure == null) {
            failure = cause;
        }
    }

    /** Bytes written, those that wait included unless writing has failed. */
    public long bytes() {
        return failure == null ? bytes + calls.position() : bytes;
    }

    /** Steps written, those that wait included unless writing has failed. */
    public long steps() {
        return failure == null ? steps + waitingSteps : steps;
    }

    /** Counts steps, of which the last call was. */
    public void countSteps(int count) {
        waitingSteps += count;
    }

    /** Begins a call. As many {@link #word} follow as it has words, and then {@link #end}. */
    public void begin(int number, int words) {
        if (writing) {
            fail(new IllegalStateException("a call could not be written to its end"));
        }
        writing = true;
        if (calls.remaining() < 1 + Integer.BYTES * words) {
            flushCalls();
        }
        if (failure == null) {
            calls.put((byte) number);
        }
    }

    /** An int of a call. */
    public void word(int value) {
        if (failure == null) {
            calls.putInt(value);
        }
    }

    public void end() {
        writing = false;
    }

    /** Writes a snapshot, which takes the place of the state. */
    public void snapshot(byte[] snapshot, int length) {
        flushCalls();
        block(LogFormat.SNAPSHOT, snapshot, length);
    }

    private void flushCalls() {
        if (calls.position() > 0) {
            block(LogFormat.CALLS, calls.array(), calls.position());
            if (failure == null) {
                steps += waitingSteps;
            }
            waitingSteps = 0;
            ((Buffer) calls).clear();
        }
    }

    private void block(int type, byte[] content, int length) {
        if (failure != null) {
            return;
        }
        ((Buffer) head).clear();
        head.put((byte) type).putInt(length).putInt(Crc32c.of(content, length));
        try {
            out.write(head.array());
            out.write(content, 0, length);
            bytes += LogFormat.BLOCK_HEAD + (long) length;
        } catch (IOException | RuntimeException | Error e) {
            fail(e);
        }
    }

    /** Writes what waits, and the end of the log. */
    public void close() throws IOException {
        flushCalls();
        block(LogFormat.END, new byte[0], 0);
        if (failure == null) {
            try {
                out.flush();
            } catch (IOException | RuntimeException | Error e) {
                fail(e);
            }
        }
        requireWritten("the log ends early");
    }
}
