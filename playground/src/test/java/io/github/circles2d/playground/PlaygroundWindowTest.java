package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The real window with mouse and keys, in a JVM of its own so that its end can be seen; on an Xvfb if there is no display. */
@Timeout(300)
class PlaygroundWindowTest {
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

    /** {@code -Dcircles2d.screenshots=FOLDER} has it save the screen at each turn. */
    @Test
    @Tag("long")
    void whatAPersonDoesHasItsEffectAndNothingIsLeftWhenTheWindowIsClosed() {
        String folder = System.getProperty("circles2d.screenshots", "");
        ForkedJvm jvm = new ForkedJvm();
        if (!display.name().isEmpty()) {
            jvm.environment("DISPLAY", display.name());
        }

        ForkedJvm.Result result =
                folder.isEmpty() ? jvm.run(WindowProgram.class) : jvm.run(WindowProgram.class, folder);

        assertThat(result.output())
                .contains(
                        "circles are lit: true",
                        "time runs: true",
                        "a pause stops it: true",
                        "a step is one step: true",
                        "a step back is the state of before: true",
                        "time runs backwards: true",
                        "a rewound world comes to the same state: true",
                        "a circle comes along: true",
                        "and falls when it is let go: true",
                        "a key pours circles: true",
                        "and no more when it is up: true",
                        "an explosion gives energy: true",
                        "another back end comes: true",
                        "with the same hash: true",
                        "and goes on: true",
                        "a wall is drawn: true",
                        "and erased: true",
                        "nothing turns at first: true",
                        "a slider sets friction: true",
                        "and circles show how they have turned: true",
                        "the wheel zooms in: true",
                        "the right button moves the picture: true",
                        "home shows all: true",
                        "a picture is in the clipboard: true",
                        "a link is in the clipboard: true",
                        "main ends")
                .doesNotContain("Exception");
        assertThat(result.exitStatus()).as(result.output()).isZero();
    }
}
