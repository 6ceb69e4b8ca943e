package io.github.circles2d.calibration;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;

/** Where the file lies: among what the user's programs may keep and the user may delete. */
public final class CachePlace {
    /** System property that names another file, or is {@code off}. */
    public static final String PROPERTY = "circles2d.calibration";

    private static final String FOLDER = "circles2d";
    private static final String FILE = "calibration.txt";

    private CachePlace() {}

    /**
     * Where the file lies in this process, whether it is there or not; empty if it is turned off, or this user has no
     * folder for such files. Throws IllegalArgumentException if the property names what cannot be a file.
     */
    public static Optional<Path> find() {
        return find(System::getProperty, System::getenv);
    }

    /**
     * The same, and makes its folder if the property names it. Throws IllegalArgumentException also if that file cannot
     * be written.
     */
    public static Optional<Path> findToWrite() {
        Optional<Path> place = find();
        String wanted = wanted(System::getProperty);
        if (place.isPresent() && wanted != null) {
            try {
                TimingsFile.requireWritable(place.get());
            } catch (IOException e) {
                throw refusal(wanted, e.toString(), e);
            }
        }
        return place;
    }

    static Optional<Path> find(UnaryOperator<String> property, UnaryOperator<String> environment) {
        String wanted = wanted(property);
        if (wanted != null) {
            return wanted.equalsIgnoreCase("off") ? Optional.empty() : Optional.of(file(wanted));
        }
        return folder(property, environment)
                .map(caches -> caches.resolve(FOLDER).resolve(FILE));
    }

    /** What the property says; null if it says nothing. */
    private static String wanted(UnaryOperator<String> property) {
        String wanted = property.apply(PROPERTY);
        return wanted == null || wanted.isBlank() ? null : wanted;
    }

    private static Path file(String wanted) {
        try {
            Path file = Path.of(wanted);
            if (Files.isDirectory(file)) {
                throw refusal(wanted, "it is a folder", null);
            }
            return file;
        } catch (InvalidPathException e) {
            throw refusal(wanted, "it is no path (" + e.getReason() + ")", e);
        }
    }

    private static IllegalArgumentException refusal(String wanted, String reason, Exception cause) {
        return new IllegalArgumentException(
                "the system property " + PROPERTY + " is '" + wanted
                        + "', but must name a file that can be written, or be 'off': " + reason,
                cause);
    }

    /** The folder that the system has for caches. By the XDG specification a relative path in a variable is ignored. */
    private static Optional<Path> folder(UnaryOperator<String> property, UnaryOperator<String> environment) {
        String system = property.apply("os.name").toLowerCase(Locale.ROOT);
        Optional<Path> home = path(property.apply("user.home")).filter(Path::isAbsolute);
        if (system.startsWith("windows")) {
            return path(environment.apply("LOCALAPPDATA")).filter(Path::isAbsolute);
        }
        if (system.startsWith("mac")) {
            return home.map(folder -> folder.resolve("Library").resolve("Caches"));
        }
        return path(environment.apply("XDG_CACHE_HOME"))
                .filter(Path::isAbsolute)
                .or(() -> home.map(folder -> folder.resolve(".cache")));
    }

    private static Optional<Path> path(String text) {
        try {
            return text == null || text.isBlank() ? Optional.empty() : Optional.of(Path.of(text));
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }
}
