package io.github.circles2d.bench.results;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** The texts and tables that are part of the program. */
public final class Resources {
    private Resources() {}

    /** The text of a file beside the main class. */
    public static String text(String name) {
        try (InputStream in = Resources.class.getResourceAsStream("/io/github/circles2d/bench/" + name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
