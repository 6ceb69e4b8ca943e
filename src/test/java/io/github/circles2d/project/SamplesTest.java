package io.github.circles2d.project;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.circles2d.opencl.ForkedJvm;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The command lines of the sample games, which are those of the playground: their messages and exit codes. */
class SamplesTest {
    @TempDir
    Path classes;

    @ParameterizedTest
    @ValueSource(strings = {"swarm", "hook"})
    void gamesWithSwingRefuseAWrongCommandLineInTwoLinesWithExitStatus2(String game) throws IOException {
        compile(game, List.of());
        requireRefusals(game, List.of());
    }

    @ParameterizedTest
    @ValueSource(strings = {"swarm", "hook"})
    void gamesWithSwingSayInTwoLinesThatThereIsNoDisplayWithExitStatus1(String game) throws IOException {
        compile(game, List.of());
        for (String display : List.of("", ":4242")) {
            ForkedJvm.Result result = jvm(List.of())
                    .environment("DISPLAY", display)
                    .run("com.example." + game + ".Main", "--backend", "jvm");
            assertThat(result.output())
                    .isEqualToNormalizingNewlines(game + ": no window can be shown here\n" + game
                            + ": without a display, it plays by itself: --frames 300\n");
            assertThat(result.exitStatus()).isEqualTo(1);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"swarm", "hook"})
    @Tag("long")
    void gamesWithSwingPlayAndSayWhyAPictureCannotBeWritten(String game) throws IOException {
        compile(game, List.of());
        String main = "com.example." + game + ".Main";
        Path picture = classes.resolve("no such folder/" + game + ".png");
        ForkedJvm.Result result =
                jvm(List.of()).run(main, "--backend", "jvm", "--frames", "2", "--picture", picture.toString());
        assertThat(result.output())
                .startsWith(game + ": cannot write " + picture)
                .hasLineCount(1);
        assertThat(result.exitStatus()).isEqualTo(1);
        ForkedJvm.Result played = jvm(List.of()).run(main, "--frames", "2", "--backend", "JVM");
        assertThat(played.output()).startsWith(game + ": 2 frames, ");
        assertThat(played.exitStatus()).isZero();
    }

    @ParameterizedTest
    @CsvSource({"billiards, 1 shots", "golf, 0 strokes"})
    @Tag("long")
    void shortGamesPlayPaintAPictureAndRefuseAWrongCommandLine(String game, String first) throws IOException {
        compile(game, List.of());
        String main = "com.example." + game + ".Main";
        Path picture = classes.resolve(game + ".png");
        ForkedJvm.Result played =
                jvm(List.of()).run(main, "--frames", "2", "--backend", "JVM", "--picture", picture.toString());
        assertThat(played.output()).startsWith(game + ": 2 frames, " + first).hasLineCount(1);
        assertThat(played.exitStatus()).isZero();
        assertThat(picture).isNotEmptyFile();
        for (String wrong : List.of("--frames", "--frames abc", "--speed 2", "--backend tpu")) {
            ForkedJvm.Result refused = jvm(List.of()).run(main, wrong.split(" "));
            assertThat(refused.output())
                    .startsWith("usage: " + game + " [--frames N")
                    .hasLineCount(1);
            assertThat(refused.exitStatus()).isEqualTo(2);
        }
        ForkedJvm.Result withoutDisplay =
                jvm(List.of()).environment("DISPLAY", "").run(main, "--backend", "JVM");
        assertThat(withoutDisplay.output())
                .contains("without a display: --frames 300")
                .hasLineCount(1);
        assertThat(withoutDisplay.exitStatus()).isEqualTo(1);
    }

    /** Where the launcher has built the game, so that libGDX is there. */
    @ParameterizedTest
    @ValueSource(strings = {"merge", "pinball", "platformer"})
    @Tag("long")
    void gamesWithLibgdxDoTheSame(String game) throws IOException {
        Path libgdx = Path.of("samples", game, "target/lib");
        assumeTrue(
                Files.isDirectory(libgdx),
                "libGDX is not there: ./circles2d play " + game + " --frames 1 would download it");
        List<Path> jars;
        try (Stream<Path> all = Files.list(libgdx)) {
            jars = all.filter(jar -> jar.getFileName().toString().matches("(gdx|lwjgl).*\\.jar"))
                    .toList();
        }
        compile(game, jars);
        requireRefusals(game, jars);
        ForkedJvm.Result result = jvm(jars)
                .environment("DISPLAY", "")
                .environment("WAYLAND_DISPLAY", "")
                .run("com.example." + game + ".Main", "--backend", "jvm");
        assertThat(result.output())
                .contains(game + ": no window can be shown here: ")
                .contains(game + ": without a display, it plays by itself: --frames 300")
                .doesNotContain("Exception");
        assertThat(result.exitStatus()).isEqualTo(1);
    }

    @Test
    void allReadTheirCommandLinesAlike() throws IOException {
        String swarm = Files.readString(source("swarm").resolve("Options.java"));
        for (String game : List.of("hook", "merge", "pinball", "platformer")) {
            assertThat(Files.readString(source(game).resolve("Options.java")))
                    .isEqualToIgnoringWhitespace(swarm.replace("swarm", game)); // lines of long names break elsewhere
        }
    }

    private void requireRefusals(String game, List<Path> jars) {
        String frames = "--frames takes a whole number from 1 to 1000000, not ";
        requireRefusal(game, jars, frames + "'abc'", "--frames", "abc");
        requireRefusal(game, jars, frames + "'-1'", "--frames", "-1");
        requireRefusal(game, jars, frames + "'0'", "--frames", "0");
        requireRefusal(game, jars, frames + "'99999999999'", "--frames", "99999999999");
        requireRefusal(game, jars, "--frames needs a value", "--frames");
        requireRefusal(game, jars, "there is no option '--speed'", "--speed", "2");
        requireRefusal(game, jars, "--backend takes auto, jvm, cpu or gpu, not 'tpu'", "--backend", "tpu");
        requireRefusal(game, jars, "--picture needs --frames", "--picture", "a.png");
        ForkedJvm.Result help = jvm(jars).run("com.example." + game + ".Main", "--help");
        assertThat(help.output()).startsWith("usage: " + game);
        assertThat(help.exitStatus()).isZero();
    }

    private void requireRefusal(String game, List<Path> jars, String message, String... arguments) {
        ForkedJvm.Result result = jvm(jars).run("com.example." + game + ".Main", arguments);
        assertThat(result.output())
                .isEqualToNormalizingNewlines(game + ": " + message + "\n" + game + ": --help lists the options\n");
        assertThat(result.exitStatus()).isEqualTo(2);
    }

    private ForkedJvm jvm(List<Path> jars) {
        List<Path> classPath = new ArrayList<>(jars);
        classPath.add(classes);
        Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
                .map(Path::of)
                .forEach(classPath::add);
        return new ForkedJvm().only(classPath.toArray(Path[]::new));
    }

    private void compile(String game, List<Path> jars) throws IOException {
        List<String> command = new ArrayList<>(List.of("-d", classes.toString(), "-cp"));
        command.add(System.getProperty("java.class.path")
                + File.pathSeparator
                + String.join(
                        File.pathSeparator, jars.stream().map(Path::toString).toList()));
        try (Stream<Path> files = Files.list(source(game))) {
            files.forEach(file -> command.add(file.toString()));
        }
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        assertThat(compiler.run(null, null, null, command.toArray(String[]::new)))
                .isZero();
    }

    private static Path source(String game) {
        return Path.of("samples", game, "src/main/java/com/example", game);
    }
}
