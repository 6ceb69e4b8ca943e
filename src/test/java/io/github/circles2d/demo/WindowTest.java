package io.github.circles2d.demo;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.TestDevices;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The real window, in a JVM of its own so that its end can be seen; on an Xvfb where there is no display. */
@Timeout(120)
@Tag("each-jdk")
class WindowTest {
    private static VirtualDisplay display;

    @BeforeAll
    static void open() throws Exception {
        display = VirtualDisplay.open();
    }

    @AfterAll
    static void close() throws InterruptedException {
        if (display != null) {
            display.close();
        }
    }

    @Test
    void theWindowShowsTheCirclesFollowsItsSizeAndLeavesNothingBehindWhenItIsClosed() {
        ForkedJvm.Result result = jvm().run(WindowProgram.class);

        assertThat(result.output())
                .contains(
                        "content 500 x 520", "resized 800 x 620", "closes 1, on the event thread: false", "main ends");
        assertThat(result.output().split("disc is lit: true", -1))
                .as(result.output())
                .hasSize(3);
        assertThat(result.exitStatus()).isZero();
    }

    @Test
    @Tag("long")
    void afterTheFramesThatWereAskedForTheProgramEndsByItself() {
        TestDevices.all();
        ForkedJvm.Result result = jvm().run(CirclesTest.class, "-n", "20", "--frames", "15");

        assertThat(result.exitStatus()).as(result.output()).isZero();
        assertThat(result.output().lines().filter(line -> line.matches("\\d+\\.\\d{3} ms")))
                .hasSize(15);
    }

    private static ForkedJvm jvm() {
        ForkedJvm jvm = new ForkedJvm();
        return display.name().isEmpty() ? jvm : jvm.environment("DISPLAY", display.name());
    }
}
