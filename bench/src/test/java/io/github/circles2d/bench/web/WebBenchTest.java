package io.github.circles2d.bench.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.bench.engines.Engine;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.engines.Motion;
import io.github.circles2d.bench.measure.Series;
import io.github.circles2d.scenes.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WebBenchTest {
    private static final int N = 100;
    private static final List<String> PLACES =
            List.of("--node", "node", "--chromium", "chromium", "--driver", "driver", "--programs", "programs");

    @TempDir
    Path temporary;

    @Test
    void worldOnTheJvmMakesARunForEachTurnAndEndsInTheStateOfItsSteps() throws IOException {
        Scene scene = WebBench.SERIES.scene(N);
        try (Turns turns = jvm(scene, 2)) {
            assertThat(turns.take()).isTrue();
            assertThat(turns.take()).isTrue();
            assertThat(turns.take()).isFalse();
            assertThat(turns.hash()).isEqualTo(String.format("%016x", end(scene).hash()));
            assertThat(turns.row())
                    .containsEntry("engine", "world")
                    .containsEntry("runs_in", "JVM")
                    .containsEntry("n", "100")
                    .containsEntry("runs", "2")
                    .containsEntry("status", "ok")
                    .containsEntry("state_hash", turns.hash())
                    .containsEntry("remarks", "Java " + System.getProperty("java.version"));
            assertThat(Double.parseDouble(turns.row().get("median_us"))).isPositive();
        }
    }

    @Test
    void aRunThatWasGivenUpIsSaidToBeLeftOut() throws IOException {
        try (Turns turns = saying(
                "echo 'circles2d-bench: ready Some 1.0'; read line; echo noise; echo 'circles2d-bench: about 250'; cat")) {
            assertThat(turns.take()).isTrue();
            assertThat(turns.take()).isFalse();
            Map<String, String> row = turns.row();
            assertThat(row).containsEntry("mean_us", "250").containsEntry("remarks", "Some 1.0");
            assertThat(row.get("status")).startsWith("left out");
            assertThat(row).doesNotContainKey("median_us");
        }
    }

    @Test
    void anEngineThatBreaksEndsTheBenchmark() throws IOException {
        assertThatThrownBy(() -> saying("exit 1"))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("ended");
        try (Turns turns = saying("echo 'circles2d-bench: ready'")) {
            assertThatThrownBy(turns::take).isInstanceOf(IOException.class);
        }
    }

    @Test
    void theOptionsNameSizesAndEngines() {
        List<String> all = List.of("--sizes", "100,200", "--only", "world,planck");
        WebOptions options =
                WebOptions.parse(Stream.concat(all.stream(), PLACES.stream()).toList());
        assertThat(options.sizes()).containsExactly(100, 200);
        assertThat(options.entrants())
                .extracting(Entrant::toString)
                .containsExactly(
                        "world in JVM",
                        "world in Node",
                        "world in Chromium",
                        "world in Node without checks",
                        "planck in Node");
        assertThatThrownBy(() -> WebOptions.parse(List.of("--only", "phaser"))).hasMessageContaining("box2d-wasm");
        assertThatThrownBy(() -> WebOptions.parse(List.of())).hasMessageContaining("./circles2d bench web");
        assertThat(WebOptions.parse(List.of("--help")).help()).isTrue();
    }

    private Turns jvm(Scene scene, int runs) throws IOException {
        Entrant entrant = Entrant.ALL.get(0);
        Path state = temporary.resolve("state");
        WebOptions options = WebOptions.parse(PLACES);
        return new Turns(
                entrant, scene, options.command(entrant, N, temporary.resolve("scene"), "{}", state), state, runs);
    }

    private Turns saying(String script) throws IOException {
        List<String> command = List.of("sh", "-c", script);
        return new Turns(Entrant.ALL.get(3), WebBench.SERIES.scene(N), command, temporary.resolve("state"), 5);
    }

    private static Motion end(Scene scene) {
        Motion end = new Motion(scene.size());
        try (Engine world = Engines.worldJvm(1)) {
            world.load(scene);
            for (int step = 0; step < WebBench.SERIES.skipped + Series.STEPS; step++) {
                world.step();
            }
            world.finish();
            world.read(end);
        }
        return end;
    }
}
