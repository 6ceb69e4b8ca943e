package io.github.circles2d.opencl;

import java.io.File;
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
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Runs a main class of the library or its tests in a JVM of its own, for what a test cannot change in this one. */
public final class ForkedJvm {
    /** Minutes. The longest program takes five on a busy machine. */
    private static final int LIMIT = 20;

    private final List<String> options = new ArrayList<>();
    private final Map<String, String> environment = new HashMap<>();
    private List<String> launcher = List.of();
    private Path directory = Path.of("");
    private String classPath = System.getProperty("java.class.path");

    /** What the other JVM left. */
    public static final class Result {
        private final int exitStatus;
        private final String output;

        Result(int exitStatus, String output) {
            this.exitStatus = exitStatus;
            this.output = output;
        }

        /** Returns the exit status of the process. */
        public int exitStatus() {
            return exitStatus;
        }

        /** Returns standard output and standard error together. */
        public String output() {
            return output;
        }
    }

    /** Adds a JVM option. */
    public ForkedJvm option(String option) {
        options.add(option);
        return this;
    }

    /** Sets an environment variable. */
    public ForkedJvm environment(String name, String value) {
        environment.put(name, value);
        return this;
    }

    /** Sets the folder that the JVM runs in. */
    public ForkedJvm directory(Path folder) {
        directory = folder;
        return this;
    }

    /** Has a command start the JVM, whose command line is appended to these words. */
    public ForkedJvm startedBy(String... command) {
        launcher = List.of(command);
        return this;
    }

    /** Leaves the jars out of the class path whose names begin so. */
    public ForkedJvm without(String... jars) {
        classPath = Stream.of(classPath.split(File.pathSeparator))
                .filter(entry -> Stream.of(jars)
                        .noneMatch(
                                jar -> Path.of(entry).getFileName().toString().startsWith(jar)))
                .collect(Collectors.joining(File.pathSeparator));
        return this;
    }

    /** Has a class path of these folders and jars alone. */
    public ForkedJvm only(Path... entries) {
        classPath = Stream.of(entries).map(Path::toString).collect(Collectors.joining(File.pathSeparator));
        return this;
    }

    /** Runs the class with this JVM's class path and waits for its end, which comes by force after {@link #LIMIT} minutes. */
    public Result run(Class<?> mainClass, String... arguments) {
        return run(mainClass.getName(), arguments);
    }

    /** Runs the class of this name. */
    public Result run(String mainClass, String... arguments) {
        try {
            Process process = start(mainClass, arguments);
            CompletableFuture.delayedExecutor(LIMIT, TimeUnit.MINUTES).execute(process::destroyForcibly);
            String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            return new Result(process.waitFor(), output);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Starts the class with this JVM's class path; standard error comes with standard output. */
    public Process start(Class<?> mainClass, String... arguments) throws IOException {
        return start(mainClass.getName(), arguments);
    }

    private Process start(String mainClass, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(launcher);
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        // Not the calibration of the user who runs the tests.
        command.add("-Dcircles2d.calibration=" + System.getProperty("circles2d.calibration", "off"));
        command.addAll(options);
        command.add("-cp");
        command.add(classPath);
        command.add(mainClass);
        command.addAll(List.of(arguments));
        ProcessBuilder builder = new ProcessBuilder(command)
                .directory(directory.toAbsolutePath().toFile())
                .redirectErrorStream(true);
        builder.environment().putAll(environment);
        return builder.start();
    }
}
