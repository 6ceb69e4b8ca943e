package io.github.circles2d.demo;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scenes;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class WorldEngineTest {

    @BeforeAll
    static void aDeviceIsThere() {
        TestDevices.all();
    }

    @Test
    void itStartsWithTheThesisSceneAndFramesAreNeverWrittenAgain() throws Exception {
        try (Engine engine = open("--device", "jvm")) {
            assertThat(engine.circles()[1]).isEqualTo(Scenes.thesis(1250, 1).y());
            float[][] first = engine.loop();
            float y = first[1][0];
            float[][] second = engine.loop();
            assertThat(second).hasDimensions(4, 1250).isNotSameAs(first);
            assertThat(engine.circles()).isSameAs(second);
            assertThat(first[1][0]).isEqualTo(y);
        }
    }

    @Test
    void aSwitchOfTheBackEndInFlightChangesNothingThatFollows() throws Exception {
        try (Engine alone = open("--device", "jvm");
                Engine switched = open("--device", "jvm")) {
            for (int frame = 0; frame < 40; frame++) {
                switched.switchTo(frame % switched.strategies().size());
                assertThat(switched.loop()).as("frame %d", frame).isDeepEqualTo(alone.loop());
            }
        }
    }

    @Test
    void restartGoesBackToTheStart() throws Exception {
        try (Engine engine = open("-n", "300", "--gravity", "0,-1")) {
            float[][] start = engine.circles();
            float[][] first = engine.loop();
            for (int frame = 0; frame < 20; frame++) {
                engine.loop();
            }
            engine.restart();
            assertThat(engine.circles()).isDeepEqualTo(start);
            assertThat(engine.loop()).isDeepEqualTo(first);
        }
    }

    @Test
    void theOverlaySaysWhichEngineAndBackEndRun() throws Exception {
        try (Engine engine = open("--device", "jvm")) {
            DemoRun simulation = new DemoRun(engine, System::nanoTime, millis -> {});
            assertThat(Overlay.lines(simulation.frame()).get(0)).isEqualTo("World, back end JVM, n = 1,250");
        }
    }

    private static Engine open(String... arguments) throws Exception {
        String[] all = new String[arguments.length + 2];
        System.arraycopy(arguments, 0, all, 2, arguments.length);
        all[0] = "--engine";
        all[1] = "world";
        return Options.parse(all).engine().open(Options.parse(all));
    }
}
