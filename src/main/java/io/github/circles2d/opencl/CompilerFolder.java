package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.JavaCL;
import java.io.File;
import java.io.IOException;
import java.lang.reflect.Field;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The folder through which JavaCL compiles: it makes a folder for included files there for each program, and keeps compiled
 * programs there. JavaCL takes {@code .javacl} in the home folder. If nothing can be written there, a temporary folder replaces
 * it.
 */
final class CompilerFolder {
    private static final String INCLUDES = "includes";
    private static final String CACHE = "cache";

    /** Replaces JavaCL's own folder; empty if that one is good. */
    private final Optional<Path> replacement;

    private CompilerFolder(Optional<Path> replacement) {
        this.replacement = replacement;
    }

    /** Finds the folder without touching JavaCL; throws if there is none, so that no program could be compiled. */
    static CompilerFolder find() {
        String temporary = System.getProperty("java.io.tmpdir");
        return find(System.getProperty("user.home"), Arrays.asList(temporary, "/tmp", "/var/tmp"));
    }

    /** Finds the folder in this home folder, or else in the first of these temporary folders that will do. */
    static CompilerFolder find(String home, List<String> temporaryFolders) {
        boolean own = path(home)
                .filter(Files::isDirectory)
                .map(folder -> folder.resolve(".javacl"))
                .filter(folder -> canWrite(folder.resolve(INCLUDES)) && canWrite(folder.resolve(CACHE)))
                .isPresent();
        if (own) {
            return new CompilerFolder(Optional.empty());
        }
        for (String folder : temporaryFolders) {
            Optional<Path> made = path(folder).flatMap(CompilerFolder::makeIn);
            if (made.isPresent()) {
                return new CompilerFolder(made);
            }
        }
        throw new OpenClUnavailableException(
                "kernels are compiled through a folder that can be written. Neither the home folder '"
                        + home + "' nor the temporary folder '" + temporaryFolders.get(0)
                        + "' is one. Start Java with -Djava.io.tmpdir=FOLDER that names one.");
    }

    Optional<Path> replacement() {
        return replacement;
    }

    /** Tells JavaCL; this loads OpenCL. JavaCL has no setting for its folders, so its fields are set. */
    void useInJavaCl() {
        if (replacement.isEmpty()) {
            return;
        }
        try {
            set("userJavaCLDir", replacement.get());
            set("userCacheDir", replacement.get().resolve(CACHE));
        } catch (ReflectiveOperationException | RuntimeException e) {
            throw new OpenClUnavailableException(
                    "kernels cannot be compiled through the home folder '" + System.getProperty("user.home")
                            + "', and JavaCL takes no other (" + e
                            + "). Start Java with -Duser.home=FOLDER, a folder that can be written.",
                    e);
        }
    }

    private static void set(String name, Path folder) throws ReflectiveOperationException {
        Field field = JavaCL.class.getDeclaredField(name);
        field.setAccessible(true);
        field.set(null, folder.toFile());
    }

    private static Optional<Path> makeIn(Path parent) {
        try {
            Path made = Files.createTempDirectory(parent, "circles2d");
            Runtime.getRuntime().addShutdownHook(new Thread(() -> deleteAtExit(made)));
            return Optional.of(made);
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /**
     * Returns the absolute path that a text names, if it does. A relative one would be a folder in whatever folder the
     * program runs in; a user without an account has the home folder {@code ?}.
     */
    private static Optional<Path> path(String text) {
        try {
            return Optional.ofNullable(text).map(Path::of).filter(Path::isAbsolute);
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }

    private static boolean canWrite(Path folder) {
        try {
            Files.createDirectories(folder);
            Files.delete(Files.createTempFile(folder, "probe", null));
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    private static void deleteAtExit(Path folder) {
        RunningBuilds.awaitAll();
        delete(folder);
    }

    private static void delete(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            files.sorted(Comparator.reverseOrder()).map(Path::toFile).forEach(File::delete);
        } catch (IOException e) {
            // Whoever clears temporary folders deletes it.
        }
    }
}
