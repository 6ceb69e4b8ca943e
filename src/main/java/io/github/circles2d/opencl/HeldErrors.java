package io.github.circles2d.opencl;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;

/**
 * Holds back what the current thread prints to standard error until it is closed. Other threads print as before. Some
 * libraries print a stack trace where they should throw an exception.
 */
final class HeldErrors implements AutoCloseable {
    private final Thread thread = Thread.currentThread();
    private final PrintStream standardError = System.err;
    private final ByteArrayOutputStream held = new ByteArrayOutputStream();
    private final PrintStream filter = new PrintStream(new Filter(), true);
    private volatile boolean open = true;

    private HeldErrors() {}

    static HeldErrors ofThisThread() {
        HeldErrors errors = new HeldErrors();
        System.setErr(errors.filter);
        return errors;
    }

    /** Returns what was held back. */
    String text() {
        return held.toString(Charset.defaultCharset());
    }

    /** Prints what was held back. */
    void print() {
        standardError.print(text());
    }

    @Override
    public void close() {
        open = false;
        if (System.err == filter) {
            System.setErr(standardError);
        }
    }

    /** Who took {@code System.err} while it was replaced, a log handler for example, may print through this for ever. */
    private final class Filter extends OutputStream {
        private OutputStream target() {
            return open && Thread.currentThread() == thread ? held : standardError;
        }

        @Override
        public void write(int b) throws IOException {
            target().write(b);
        }

        @Override
        public void write(byte[] bytes, int offset, int length) throws IOException {
            target().write(bytes, offset, length);
        }

        @Override
        public void flush() throws IOException {
            target().flush();
        }
    }
}
