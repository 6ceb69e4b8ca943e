package io.github.circles2d.opencl;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Drivers leave the signal handlers of Java alone. Each test has a JVM of its own with cold caches: a driver compiles. */
@EnabledOnOs(OS.LINUX)
@Timeout(value = 20, unit = TimeUnit.MINUTES)
@Tag("each-jdk")
class SignalsTest {
    @TempDir
    Path cache;

    @BeforeEach
    void needsADevice() {
        TestDevices.all();
    }

    private ForkedJvm cold() {
        return new ForkedJvm().option("-Djavacl.cacheBinaries=false").environment("POCL_CACHE_DIR", cache.toString());
    }

    @Test
    @Tag("long")
    void discoveryBuildAndFirstEnqueueOfEveryEngineLeaveTheHandlersByteForByteAsTheyWere() {
        ForkedJvm.Result result = cold().run(SignalsProgram.class);
        assertThat(result.output())
                .contains("compared: discovery", "compared: enqueue", "compared: World stepped", "end")
                .contains("handler of the program kept: true")
                .doesNotContain("changed at stage");
        assertThat(result.exitStatus()).isZero();
    }

    @Test
    void threadsThatStopAtOnceWhileKernelsCompileDoNotEndTheProcess() {
        int kernels = TestScale.of(5, 300);
        ForkedJvm.Result result = cold().run(SafepointProgram.class, Integer.toString(kernels));
        assertThat(result.exitStatus()).as(result.output()).isZero();
        assertThat(result.output()).contains("survived");
    }

    @ParameterizedTest
    @ValueSource(strings = {"forever", "once"})
    @Tag("long")
    void aThreadDumpAndShutdownHooksComeDuringAndAfterCompilation(String mode) throws Exception {
        // A shell that starts the tests in the background makes them, and all that they start, ignore Ctrl-C.
        Process process = cold().startedBy("env", "--default-signal=INT").start(CompileForever.class, mode);
        try (BufferedReader output =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            readUntil(output, "compiled 0");
            kill("-QUIT", process);
            readUntil(output, "Full thread dump");
            askForThreads(process);
            kill("-INT", process);
            assertThat(output.lines().collect(Collectors.joining("\n"))).contains("shutdown hook ran");
            assertThat(process.waitFor()).isEqualTo(128 + 2);
        } finally {
            process.destroyForcibly();
        }
    }

    /** By the tool of a JDK; a Java runtime without one has a thread dump by signal alone. */
    private static void askForThreads(Process process) throws IOException {
        Path jcmd = Path.of(System.getProperty("java.home"), "bin", "jcmd");
        if (Files.isExecutable(jcmd)) {
            Process asked = new ProcessBuilder(jcmd.toString(), Long.toString(process.pid()), "Thread.print")
                    .redirectErrorStream(true)
                    .start();
            assertThat(new String(asked.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
                    .contains("\"main\"");
        }
    }

    private static void kill(String signal, Process process) throws IOException, InterruptedException {
        int status = new ProcessBuilder("kill", signal, Long.toString(process.pid()))
                .start()
                .waitFor();
        assertThat(status).isZero();
    }

    private static void readUntil(BufferedReader output, String text) throws IOException {
        StringBuilder seen = new StringBuilder();
        for (String line = output.readLine(); line != null; line = output.readLine()) {
            seen.append(line).append('\n');
            if (line.contains(text)) {
                return;
            }
        }
        throw new AssertionError("'" + text + "' never came; there was:\n" + seen);
    }
}
