package io.github.circles2d.playground;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import org.opentest4j.TestAbortedException;

/**
 * An X server without a screen, so that windows can be tested where nobody looks; the desktop's own display on other
 * systems than Linux.
 */
final class VirtualDisplay {
    private final Process server;
    private final String name;

    private VirtualDisplay(Process server, String name) {
        this.server = server;
        this.name = name;
    }

    /** Starts an Xvfb under a free number; where there is none to start, the tests that need it are skipped. */
    static VirtualDisplay open() throws IOException {
        if (!System.getProperty("os.name").equals("Linux")) {
            if (java.awt.GraphicsEnvironment.isHeadless()) {
                throw new TestAbortedException("there is no screen to show a window on");
            }
            return new VirtualDisplay(null, "");
        }
        Process server;
        try {
            server = new ProcessBuilder("Xvfb", "-displayfd", "1", "-screen", "0", "1700x1100x24", "-nolisten", "tcp")
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
        } catch (IOException e) {
            throw new TestAbortedException("Xvfb is not installed, so no window can be tested", e);
        }
        BufferedReader reader =
                new BufferedReader(new InputStreamReader(server.getInputStream(), StandardCharsets.US_ASCII));
        String number = reader.readLine();
        if (number == null) {
            throw new IOException("Xvfb ended before it was ready");
        }
        return new VirtualDisplay(server, ":" + number.strip());
    }

    /** The value of the environment variable DISPLAY; empty where none is needed. */
    String name() {
        return name;
    }

    void close() throws InterruptedException {
        if (server != null) {
            server.destroy();
            server.waitFor(10, TimeUnit.SECONDS);
        }
    }
}
