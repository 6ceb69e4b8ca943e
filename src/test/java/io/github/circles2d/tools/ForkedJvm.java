package io.github.circles2d.tools;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** A main class run in a JVM of its own, for what is decided once in the life of a JVM: drivers, environment, exit. */
final class ForkedJvm {
    final int exitStatus;
    final String output;

    private ForkedJvm(int exitStatus, String output) {
        this.exitStatus = exitStatus;
        this.output = output;
    }

    /** Runs to the end, in the class path of the tests; standard output and error are joined. */
    static ForkedJvm run(Class<?> main, Map<String, String> environment, List<String> jvmOptions, String... args)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        if (Runtime.version().feature() >= 22) {
            command.add("--enable-native-access=ALL-UNNAMED");
        }
        command.addAll(jvmOptions);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), main.getName()));
        command.addAll(Arrays.asList(args));
        Path log = Files.createTempFile("circles2d", ".log");
        try {
            ProcessBuilder builder =
                    new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(log.toFile());
            builder.environment().putAll(environment);
            Process process = builder.start();
            process.getOutputStream().close();
            if (!process.waitFor(2, TimeUnit.MINUTES)) {
                process.destroyForcibly();
                throw new AssertionError(main + " did not end: " + Files.readString(log, StandardCharsets.UTF_8));
            }
            return new ForkedJvm(process.exitValue(), Files.readString(log, StandardCharsets.UTF_8));
        } finally {
            Files.delete(log);
        }
    }
}
