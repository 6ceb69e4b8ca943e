package io.github.circles2d.playground;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/** Runs a main class of the playground or its tests in a separate JVM, so that its end can be seen. */
final class ForkedJvm {
    /** Minutes. The longest program takes one on a busy machine. */
    private static final int LIMIT = 10;

    private final Map<String, String> environment = new HashMap<>();

    /**
     * The end of the other JVM.
     *
     * @param exitStatus of the process
     * @param output     standard output and standard error together
     */
    record Result(int exitStatus, String output) {}

    ForkedJvm environment(String name, String value) {
        environment.put(name, value);
        return this;
    }

    /** Runs the class with this JVM's class path and waits for its end, which comes by force after {@link #LIMIT} minutes. */
    Result run(Class<?> mainClass, String... arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                // Not the calibration of the user who runs the tests.
                "-Dcircles2d.calibration=off",
                "-cp",
                System.getProperty("java.class.path"),
                mainClass.getName()));
        command.addAll(List.of(arguments));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().putAll(environment);
        try {
            Process process = builder.start();
            CompletableFuture.delayedExecutor(LIMIT, TimeUnit.MINUTES).execute(process::destroyForcibly);
            String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            return new Result(process.waitFor(), output);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
