package io.github.circles2d.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.bench.engines.Engine;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.engines.Motion;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SeriesTest {
    private static final String HEADER = "engine,series,n,threads,run,median_ms,mean_ms,state,date,made_with\n";

    @TempDir
    Path temporary;

    /** What is measured here need not be exact, so it may run beside another measurement. */
    @BeforeEach
    void ignoreOtherMeasurements() {
        System.setProperty("jmh.ignoreLock", "true");
    }

    @AfterEach
    void heedThemAgain() {
        System.clearProperty("jmh.ignoreLock");
    }

    /** An engine that does nothing for a time. */
    private static final class Sleeper implements Engine {
        private final long millis;
        private final boolean drifts;
        private final long firstMillis;
        private int loads;
        private int steps;

        Sleeper(long millis, boolean drifts) {
            this(millis, drifts, millis);
        }

        /** Its first four steps take another time. */
        Sleeper(long millis, boolean drifts, long firstMillis) {
            this.millis = millis;
            this.drifts = drifts;
            this.firstMillis = firstMillis;
        }

        @Override
        public void load(Scene scene) {
            loads++;
        }

        @Override
        public void step() {
            steps++;
            try {
                Thread.sleep(steps <= 4 ? firstMillis : millis);
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        }

        @Override
        public void read(Motion motion) {
            Arrays.fill(motion.x, drifts ? 0.5f + loads : 0.5f);
            Arrays.fill(motion.y, 0.5f);
        }

        @Override
        public boolean repeatable() {
            return true;
        }

        @Override
        public void close() {}
    }

    @Test
    @Tag("long")
    void everyEngineOfMavenRunsInAJvmOfItsOwnAndItsRowsAreKept() throws IOException {
        String said = run("--sizes", "40", "--patience", "60s", "--series", "mixed-100", folder().toString());
        ResultsFolder results = ResultsFolder.open(folder());
        assertThat(results.machine("cores")).isNotEmpty();
        List<Map<String, String>> rows = results.table(Kind.SERIES).rows("status", "ok");
        assertThat(rows)
                .as(said)
                .extracting(row -> row.get("engine"))
                .contains(Engines.WORLD_JVM, "gdx-box2d", "dyn4j", "jbox2d");
        assertThat(rows).allSatisfy(row -> {
            assertThat(Double.parseDouble(row.get("median_ms"))).isPositive();
            assertThat(Integer.parseInt(row.get("runs"))).isGreaterThanOrEqualTo(5);
            assertThat(row.get("skipped")).isEqualTo("100");
            assertThat(row.get("outside")).isEqualTo("0");
        });
        assertThat(results.table(Kind.SERIES).rows())
                .filteredOn(row -> row.get("engine").startsWith("world"))
                .extracting(row -> row.get("state_hash"))
                .doesNotContain("")
                .containsOnly(rows.get(0).get("state_hash"));
    }

    @Test
    void whatIsThereStaysIfOnlyMissingFiguresAreAskedFor() throws IOException {
        Map<String, String> cell = new Contender("gdx-box2d", "1").key(Series.MIXED_10, 30);
        ResultsFolder.open(folder()).put(Kind.SERIES, row(cell, "ok"));
        String said =
                run("--sizes", "30", "--series", "mixed-10", "--engine", "gdx-box2d", "--missing", folder().toString());
        assertThat(said).contains("0 runs");
        assertThat(ResultsFolder.open(folder()).table(Kind.SERIES).rows())
                .singleElement()
                .satisfies(row -> assertThat(row.get("median_ms")).isEqualTo("7"));
    }

    @Test
    void aFigureThatCannotBeMeasuredAgainStays() throws IOException {
        Map<String, String> cell = new Contender("gdx-box2d", "1").key(Series.MIXED_10, 30);
        ResultsFolder.open(folder()).put(Kind.SERIES, row(cell, "ok"));
        String[] tooShort = {"--sizes", "30", "--series", "mixed-10", "--engine", "gdx-box2d", "--time-budget", "1s"};
        String[] all = Arrays.copyOf(tooShort, tooShort.length + 1);
        all[tooShort.length] = folder().toString();
        assertThat(run(all)).contains("the time was up; the earlier figure stays");
        assertThat(ResultsFolder.open(folder()).hasFigure(Kind.SERIES, cell)).isTrue();
    }

    @Test
    void onlyTheStepsThatCountAreTimedAndEveryRunBeginsAnew() {
        Sleeper engine = new Sleeper(0, false);
        Map<String, String> row = Stopwatch.measure(Series.OVER_FULL, 10, engine, 60);
        int runs = Integer.parseInt(row.get("runs"));
        assertThat(row).containsEntry("status", "ok");
        assertThat(runs).isBetween(5, 40);
        assertThat(engine.loads).isEqualTo(runs);
        assertThat(engine.steps).isEqualTo(400 * runs);
        assertThat(Double.parseDouble(row.get("median_ms"))).isLessThan(50);
        assertThat(Double.parseDouble(row.get("median_ms")))
                .isLessThanOrEqualTo(Double.parseDouble(row.get("middle_median_ms")));
    }

    @Test
    @Tag("long")
    void aRunThatWouldTakeTooLongIsGivenUpSoonAndSaysWhatAStepTakes() {
        Sleeper engine = new Sleeper(500, false);
        Map<String, String> row = Stopwatch.measure(Series.PACKED_SIMILAR, 10, engine, 4);
        assertThat(row.get("status"))
                .startsWith("left out: 200 steps of about 5")
                .contains("longer than the 4 s");
        assertThat(Double.parseDouble(row.get("mean_ms"))).isBetween(500.0, 900.0);
        assertThat(engine.steps).isBetween(3, 8);
    }

    @Test
    @Tag("long")
    void slowFirstStepsDoNotMakeARunHopeless() {
        assertThat(Stopwatch.measure(Series.PACKED_SIMILAR, 10, new Sleeper(5, false, 850), 10))
                .containsEntry("status", "ok");
    }

    @Test
    void anEngineThatEndsTheSameRunInAnotherStateIsRefused() {
        assertThatThrownBy(() -> Stopwatch.measure(Series.PACKED_SIMILAR, 10, new Sleeper(0, true), 60))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("another state");
    }

    @Test
    void aJvmThatDiesLeavesAReasonInPlaceOfAFigure() {
        assertThat(SeriesWork.row("some driver's line\n", 134))
                .containsEntry("status", "failed: the JVM ended with exit code 134");
        assertThat(SeriesWork.row("noise\ncircles2d-series: status failed: X: a b\n", 0))
                .containsOnly(Map.entry("status", "failed: X: a b"));
    }

    @Test
    void aMillionCirclesAreWorldsUnlessASizeIsAskedFor() throws IOException {
        assertThat(labels("--series", "packed-similar"))
                .contains("world-jvm packed-similar 1000000 1", "gdx-box2d packed-similar 100000 1")
                .doesNotContain("gdx-box2d packed-similar 1000000 1");
        assertThat(labels("--sizes", "1000000", "--engine", "gdx-box2d,dyn4j")).hasSize(10);
    }

    private List<String> labels(String... arguments) throws IOException {
        return Plan.of(Options.parse(series(arguments)), Map.of(), ResultsFolder.open(folder())).stream()
                .map(Work::label)
                .toList();
    }

    private static List<String> series(String... arguments) {
        return Stream.concat(Stream.of("series"), Stream.of(arguments)).toList();
    }

    @Test
    void whatIsAskedWronglyIsRefusedWithWhatIsAllowed() {
        refused("there is no series packt; there are packed-similar,mixed-10", "--series", "packt");
        refused("--time-budget takes a number and s, m or h, such as 9m, not 9", "--time-budget", "9");
        refused("--patience needs a value", "--patience");
        refused("--sizes takes numbers of circles, such as 1250,10000, not 1e6", "--sizes", "1e6");
        refused("there is no option --fast; --help names them", "--fast");
        refused("one folder of results is enough: a or b?", "a", "b");
    }

    private static void refused(String message, String... arguments) {
        assertThatThrownBy(() -> Options.parse(series(arguments)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }

    @Test
    void scenesAreWrittenAsTheyAreAndListedWithWhatAnEngineNeedsToKnow() throws IOException {
        run("--write", temporary.toString(), "--series", "mixed-10,over-full", "--sizes", "20");
        Scene scene = Scenes.mixed(20, 10, Scenes.SEED);
        ByteBuffer file = ByteBuffer.wrap(Files.readAllBytes(temporary.resolve("mixed-10-20.scene")))
                .order(ByteOrder.LITTLE_ENDIAN);
        assertThat(file.getInt()).isEqualTo(20);
        for (int i = 0; i < 20; i++) {
            assertThat(new float[] {file.getFloat(), file.getFloat(), file.getFloat(), file.getFloat()})
                    .containsExactly(scene.x(i), scene.y(i), scene.radius(i), scene.mass(i));
        }
        assertThat(file.hasRemaining()).isFalse();
        assertThat(Files.readAllLines(temporary.resolve("scenes.csv")))
                .hasSize(3)
                .first()
                .isEqualTo("file,series,n,arena_metres,gravity,restitution,skipped,steps");
        assertThat(Files.readAllLines(temporary.resolve("scenes.csv")).get(2))
                .matches("over-full-20\\.scene,over-full,20,[0-9.]+,0\\.01,0\\.5,300,100");
    }

    @Test
    void figuresFromOutsideMavenAreTakenWithTheLeastMedianAndMarkedAsSuch() throws IOException {
        state(30, 0.25f);
        Path list = temporary.resolve("figures.csv");
        Files.writeString(
                list,
                HEADER + "box2d-v3,mixed-10,30,2,1,0.5,0.7,end,2026-01-02,\"Box2D, commit abc\"\n"
                        + "box2d-v3,mixed-10,30,2,2,0.4,0.8,end,2026-01-02,\"Box2D, commit abc\"\n"
                        + "box2d-v3,mixed-10,30,2,3,0.6,0.9,end,2026-01-02,\"Box2D, commit abc\"\n");
        run("--take", list.toString(), folder().toString());
        assertThat(ResultsFolder.open(folder()).table(Kind.SERIES).rows())
                .singleElement()
                .satisfies(row -> assertThat(row)
                        .containsEntry("median_ms", "0.4")
                        .containsEntry("middle_median_ms", "0.5")
                        .containsEntry("mean_ms", "0.7")
                        .containsEntry("runs", "3")
                        .containsEntry("outside", "1")
                        .containsEntry("date", "2026-01-02")
                        .containsEntry("remarks", "outside Maven: Box2D, commit abc"));
    }

    @Test
    void figuresWithoutTheRightColumnsOrStateAreRefused() throws IOException {
        Path list = temporary.resolve("figures.csv");
        Files.writeString(list, "engine,n\nbox2d-v3,30\n");
        assertThatThrownBy(() -> run("--take", list.toString(), folder().toString()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("must begin with the line engine,series,n");
        state(29, 0.5f);
        Files.writeString(list, HEADER + "box2d-v3,mixed-10,30,2,1,0.5,0.7,end,2026-01-02,x\n");
        assertThatThrownBy(() -> run("--take", list.toString(), folder().toString()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("464 bytes; the end state of 30 circles has 480");
        state(30, Float.NaN);
        assertThatThrownBy(() -> run("--take", list.toString(), folder().toString()))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("circle 0 of mixed-10 (30 circles) ended at (");
    }

    /** An end state whose first circle is outside. */
    private void state(int n, float y) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(16 * n).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < n; i++) {
            bytes.putFloat(i == 0 ? -0.1f : (float) i / n)
                    .putFloat(y)
                    .putFloat(0)
                    .putFloat(0);
        }
        Files.write(temporary.resolve("end"), bytes.array());
    }

    private Path folder() {
        return temporary.resolve("box");
    }

    private static String run(String... arguments) throws IOException {
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        Measurements.run(series(arguments), new PrintStream(said, true, StandardCharsets.UTF_8));
        return said.toString(StandardCharsets.UTF_8);
    }

    private static Map<String, String> row(Map<String, String> cell, String status) {
        Map<String, String> row = new LinkedHashMap<>(cell);
        row.put("median_ms", "7");
        row.put("status", status);
        return row;
    }
}
