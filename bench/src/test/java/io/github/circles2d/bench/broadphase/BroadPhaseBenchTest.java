package io.github.circles2d.bench.broadphase;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BroadPhaseBenchTest {
    @TempDir
    Path folder;

    @Test
    @Tag("long")
    void figuresArePrintedAndKept() throws IOException {
        String out = run("--sizes", "200", "--scenes", "gas", "--seconds", "0.001", "--out", folder.toString());
        assertThat(out).contains("uniform-grid").contains("world-step");
        List<Map<String, String>> rows =
                ResultsFolder.open(folder).table(Kind.BROADPHASE).rows("scene", "gas", "n", "200");
        assertThat(rows).hasSize(BroadPhases.values().length + 2);
        String pairs = row(rows, "all-pairs").get("pairs");
        for (BroadPhases kind : BroadPhases.values()) {
            assertThat(row(rows, kind.title).get("pairs")).as(kind.title).isEqualTo(pairs);
            assertThat(Double.parseDouble(row(rows, kind.title).get("median_ms")))
                    .isPositive();
        }
        assertThat(row(rows, "all-pairs").get("tests")).isEqualTo("19900");
    }

    /** Counts are of the work, so they are the same whenever they are counted. */
    @Test
    void countsAreRepeatable() throws IOException {
        Track track = new Track(Crowds.MIXED_10.of(300), 5, 12);
        for (BroadPhases kind : BroadPhases.values()) {
            Measurement one = Measurement.of(kind, track, 4, 0);
            Measurement two = Measurement.of(kind, track, 4, 0);
            assertThat(two.work()).usingRecursiveComparison().as(kind.title).isEqualTo(one.work());
            assertThat(two.checksum()).isEqualTo(one.checksum());
            assertThat(one.work().tests).as(kind.title).isGreaterThanOrEqualTo(one.pairs());
        }
    }

    @Test
    void wrongArgumentsAreNamed() {
        for (String[] wrong : new String[][] {
            {"--sizes", "many"},
            {"--sizes", "9"},
            {"--scenes", "pool"},
            {"--only", "octree"},
            {"--seconds", "-1"},
            {"--fast", "--fast"}
        }) {
            assertThatThrownBy(() -> run(wrong))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining(wrong[1]);
        }
        assertThatThrownBy(() -> run("--out"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("--out");
    }

    @Test
    void thePageIsThatOfTheKeptFigures() throws IOException {
        assertThat(Files.readString(Path.of("../docs/broad-phases.md"), StandardCharsets.UTF_8))
                .isEqualTo(BroadPhasePage.of(ResultsFolder.open(Path.of("results/amd-epyc-2"))));
    }

    private static Map<String, String> row(List<Map<String, String>> rows, String name) {
        return rows.stream()
                .filter(row -> row.get("broad_phase").equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static String run(String... arguments) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        BroadPhaseBench.run(List.of(arguments), new PrintStream(out, true, StandardCharsets.UTF_8));
        return out.toString(StandardCharsets.UTF_8);
    }
}
