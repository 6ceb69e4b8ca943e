package io.github.circles2d.demo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.PairIndexing;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.EnumSet;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("each-jdk")
class Circles2DEngineTest {

    @BeforeAll
    static void aDeviceIsThere() {
        TestDevices.all();
    }

    @Test
    void itStartsWithTheThesisSceneAndLeavesTheStartAlone() throws Exception {
        Scene scene = Scenes.thesis(1250, 1);
        try (Engine engine = open()) {
            float[][] start = engine.circles();
            assertThat(start).isDeepEqualTo(new float[][] {scene.x(), scene.y(), scene.radius(), scene.mass()});

            float[][] next = engine.loop();
            assertThat(next).hasDimensions(4, 1250).isNotSameAs(start);
            assertThat(engine.circles()).isSameAs(next);
            assertThat(start[1]).isEqualTo(scene.y());
        }
    }

    @Test
    void packedRadiiFillTheArenaAsTheThesisSceneDoes() throws Exception {
        try (Engine engine = open("-n", "5000", "--packed")) {
            assertThat(engine.circles()[2]).isEqualTo(Scenes.packed(5000, 1).radius());
        }
    }

    @Test
    void gravityAndTimeStepReachTheEngine() throws Exception {
        try (Engine engine = open("-n", "1", "--gravity", "0.36,-0.72")) {
            float[][] start = engine.circles();
            float[][] next = engine.loop();

            // From rest, half g h^2 with h = 1/60: 0.36 / 7200 and -0.72 / 7200.
            assertThat(next[0][0] - start[0][0]).isCloseTo(0.00005f, within(1e-6f));
            assertThat(next[1][0] - start[1][0]).isCloseTo(-0.0001f, within(1e-6f));
        }
    }

    @Test
    void anotherSeedIsAnotherStart() throws Exception {
        try (Engine engine = open("--seed", "2")) {
            assertThat(engine.circles()[0]).isEqualTo(Scenes.thesis(1250, 2).x());
        }
    }

    @Test
    void strategiesAreNamedByTheirNumbers() throws Exception {
        try (Engine engine = open("-n", "2", "--strategy", "3")) {
            assertThat(engine.strategy()).isEqualTo(3);
            assertThat(engine.strategies()).hasSize(4);
            for (PairIndexing indexing : EnumSet.complementOf(EnumSet.of(PairIndexing.AUTO))) {
                assertThat(engine.strategies().get(indexing.strategy()))
                        .startsWith("strategy " + indexing.strategy() + " (");
            }
        }
    }

    @Test
    void aSwitchNeitherMovesACircleNorChangesItsFlight() throws Exception {
        try (Engine switched = open("-n", "1", "--gravity", "0.3,-0.5");
                Engine steady = open("-n", "1", "--gravity", "0.3,-0.5")) {
            for (int k = 0; k < 12; k++) {
                float[][] before = switched.circles();
                switched.switchTo(k % 4);
                assertThat(switched.circles()).isDeepEqualTo(before);
                assertThat(switched.loop()).isDeepEqualTo(steady.loop());
            }
        }
    }

    @Test
    void aRestartShowsTheStartAgainAndRepeatsTheFlightFromRest() throws Exception {
        try (Engine engine = open("-n", "1", "--gravity", "0,-0.5")) {
            float[][] start = engine.circles();
            float[][] first = engine.loop();
            for (int k = 0; k < 30; k++) {
                engine.loop();
            }
            engine.switchTo(1);
            engine.restart();

            assertThat(engine.circles()).isDeepEqualTo(start);
            assertThat(engine.strategy()).isEqualTo(1);
            assertThat(engine.loop()).isDeepEqualTo(first);
        }
    }

    @Test
    void aRefusedSwitchLeavesTheEngineRunning() throws Exception {
        try (Engine engine = open("-n", "10")) {
            assertThatThrownBy(() -> engine.switchTo(17))
                    .isInstanceOf(EngineException.class)
                    .hasMessageContaining("17");

            assertThat(engine.strategy()).isEqualTo(2);
            assertThat(engine.loop()).hasDimensions(4, 10);
            engine.switchTo(0);
            assertThat(engine.loop()).hasDimensions(4, 10);
        }
    }

    @Test
    void tooManyCirclesAreRefusedWithTheNumberThatWouldFit() {
        assertThatThrownBy(() -> open("-n", "70000"))
                .isInstanceOf(EngineException.class)
                .hasMessageContaining("70000")
                .hasMessageContaining("would fit");
    }

    @Test
    void aDeviceIsFoundByNumberAndByPartOfItsNameInAnyCase() throws Exception {
        String name = OpenCl.bestDevice().name();

        assertThat(DeviceChoice.find("best")).isSameAs(OpenCl.bestDevice());
        assertThat(DeviceChoice.find("0")).isSameAs(OpenCl.devices().get(0));
        assertThat(DeviceChoice.find(name.substring(1).toUpperCase(java.util.Locale.ROOT)))
                .isSameAs(OpenCl.bestDevice());
    }

    @Test
    void aDeviceThatIsNotThereIsAnsweredWithTheListOfThoseThatAre() {
        for (String wanted : new String[] {"99", "no such device"}) {
            assertThatThrownBy(() -> DeviceChoice.find(wanted))
                    .isInstanceOf(EngineException.class)
                    .hasMessageContaining(wanted)
                    .hasMessageContaining("0: " + OpenCl.devices().get(0));
        }
    }

    private static Engine open(String... arguments) throws Exception {
        Options options = Options.parse(arguments);
        return Circles2DEngine.open(options);
    }
}
