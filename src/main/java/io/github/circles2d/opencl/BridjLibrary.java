package io.github.circles2d.opencl;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import org.bridj.BridJ;
import org.bridj.Platform;
import org.bridj.PointerIO;

/**
 * Loads BridJ's native library before anything else of BridJ is used. BridJ itself prints a stack trace if it cannot,
 * and later fails with errors that look like those of a missing driver.
 */
final class BridjLibrary {
    private static final String TEMPORARY = "java.io.tmpdir";

    private BridjLibrary() {}

    /** Loads the library; the exception names the cause and the cure. */
    static void load() {
        try (HeldErrors errors = HeldErrors.ofThisThread()) {
            try {
                Platform.initLibrary();
                // First of the classes for pointers: they need each other, and BridJ fails if the first is another.
                PointerIO.getByteInstance();
            } catch (LinkageError | RuntimeException e) {
                String cause = causeIn(errors.text()).orElse(e.toString());
                throw new OpenClUnavailableException(
                        "BridJ, through which Java reaches OpenCL, cannot load its native library (" + cause + "). "
                                + cure(cause),
                        e);
            }
            errors.print(); // Java's own warnings of native access
        }
    }

    /** Returns the first line of the innermost exception of a printed stack trace. */
    private static Optional<String> causeIn(String stackTrace) {
        return stackTrace
                .lines()
                .filter(line -> !line.isBlank() && !Character.isWhitespace(line.charAt(0)))
                .reduce((outer, inner) -> inner)
                .map(line -> line.replace("Caused by: ", ""));
    }

    private static String cure(String cause) {
        if (cause.contains("IllegalCallerException")) {
            Module bridj = BridJ.class.getModule();
            String module = bridj.isNamed() ? bridj.getName() : "ALL-UNNAMED";
            return "Start Java with --enable-native-access=" + module + ".";
        }
        String folder = System.getProperty(TEMPORARY, "");
        String lack = lackOf(folder);
        if (lack.isEmpty()) {
            return "The library is not made for this system: build one and name it with -Dbridj.library=FILE.";
        }
        return "BridJ extracts it into the temporary folder '" + folder + "', which " + lack + ". Start Java with -D"
                + TEMPORARY + "=FOLDER, a folder that exists, can be written and allows execution.";
    }

    /** Returns why no library can be loaded from a folder; empty if there is no reason. */
    private static String lackOf(String folder) {
        try {
            Path path = Path.of(folder);
            if (!Files.isDirectory(path)) {
                return "does not exist";
            }
            Path file = Files.createTempFile(path, "circles2d", null);
            try {
                // On Linux no file can be executed where the file system is mounted so that it allows no execution.
                boolean executable = file.toFile().setExecutable(true) && Files.isExecutable(file);
                return executable ? "" : "does not allow execution";
            } finally {
                Files.delete(file);
            }
        } catch (InvalidPathException e) {
            return "has no valid name in the encoding of this locale";
        } catch (IOException e) {
            return "cannot be written";
        }
    }

    /**
     * Holds back what the current thread prints to standard error until it is closed. Other threads print as before. Some
     * libraries print a stack trace where they should throw an exception.
     */
    private static final class HeldErrors implements AutoCloseable {
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
}
