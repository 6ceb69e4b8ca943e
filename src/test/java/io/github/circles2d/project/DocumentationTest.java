package io.github.circles2d.project;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Replay;
import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringWriter;
import java.net.URI;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What the documents say must hold on this commit. */
class DocumentationTest {
    private static final Path CONSUMER = Path.of("src/test/resources/consumer");

    @Test
    void theGameLoopOfTheReadmeCompilesWithoutAWarning(@TempDir Path folder) throws IOException {
        assertCompiles("Game", block(read("README.md"), "java"), folder);
    }

    /** Each block is the inside of a method of a game that has a world, a player and a few things of its own. */
    @ParameterizedTest
    @CsvSource({"docs/guide.md, 23", "docs/thesis.md, 1", "docs/coming-from.md, 1"})
    @Tag("long")
    void allCodeOfAPageCompilesWithoutAWarning(String page, int blocks, @TempDir Path folder) throws IOException {
        String imports = "import io.github.circles2d.*; import java.io.*; import java.nio.*; import java.nio.file.*;\n";
        String game =
                "abstract class Game { World world; long player; Path file; float mouseX; float mouseY; float x; float y;"
                        + " Object[] players; abstract float stickX(); abstract float stickY(); abstract boolean playing();"
                        + " abstract boolean rewindKey(); abstract float secondsSinceTheLastFrame();"
                        + " abstract void draw(float x, float y); void run() throws Exception {\n";
        List<String> codes = Pattern.compile("(?s)```java\\n(.*?)```")
                .matcher(read(page))
                .results()
                .map(match -> match.group(1))
                .filter(code -> !code.startsWith("// dyn4j"))
                .toList();
        assertThat(codes).hasSizeGreaterThanOrEqualTo(blocks);
        for (String code : codes) {
            assertCompiles("Game", imports + game + code + "} }", Files.createTempDirectory(folder, "game"));
        }
    }

    /** With keys and sticks that are scripted, the game runs, goes back, scores, and its log replays. */
    @Test
    void theWholeGameOfThePackageCompilesRunsAndReplays(@TempDir Path folder) throws Exception {
        String page = read("src/main/java/io/github/circles2d/package-info.java");
        String game = snippet(page, "final World world");
        String code = "import io.github.circles2d.*; import java.io.*; import java.nio.*; import java.nio.file.*;\n"
                + "public class Game {\n" + game
                + "private int frames; private String shown;"
                + " private boolean playing() { return frames++ < 400; }"
                + " private boolean backKey() { return frames == 300; }"
                + " private float secondsSinceTheLastFrame() { return 1 / 50f; }"
                + " private float stickX() { return step < 200 ? 0 : -0.5f; }"
                + " private void draw(float x, float y) { if (!(x > 0 && y > 0)) throw new AssertionError(); }"
                + " private void show(String text) { shown = text; }"
                + " public static String run(Path file) throws IOException {"
                + " Game game = new Game(); game.world.add(40, 20, 3, Float.POSITIVE_INFINITY); game.play(file);"
                + " return game.shown; } }";
        assertCompiles("Game", code, folder);
        Path log = folder.resolve("log");
        String shown;
        try (URLClassLoader loader =
                new URLClassLoader(new URL[] {folder.toUri().toURL()})) {
            shown = (String)
                    loader.loadClass("Game").getMethod("run", Path.class).invoke(null, log);
        }
        Matcher end = Pattern.compile("([1-9]\\d*) points in (\\d+) steps").matcher(shown);
        assertThat(end.matches()).as(shown).isTrue();
        int steps = Integer.parseInt(end.group(2));
        assertThat(steps).isBetween(470, 480);
        try (World world = WorldScenes.jvm().build();
                InputStream in = Files.newInputStream(log)) {
            Replay replay = new Replay(in, world).run();
            assertThat(replay.difference()).isEqualTo("no difference in " + steps + " steps");
        }
    }

    @Test
    void theStatesBesideARewindCompileInAGame(@TempDir Path folder) throws IOException {
        String code = snippet(
                read("src/main/java/io/github/circles2d/Rewind.java"), "Rewind rewind = new Rewind(world, 600);\nGame");
        String around = "abstract class GameState { abstract GameState copy(); abstract void set(GameState state); }\n"
                + "class Game { World world = World.builder().build(); GameState game;\n";
        assertCompiles("Game", "import io.github.circles2d.*;\n" + around + code + "}", folder);
    }

    @Test
    void theExamplesOfRopesAndBlobsRun(@TempDir Path folder) throws Exception {
        String code = snippet(read("src/main/java/io/github/circles2d/Ropes.java"), "long hook")
                + snippet(read("src/main/java/io/github/circles2d/Blobs.java"), "JointedCircles ball");
        String around = "import io.github.circles2d.*;\npublic class Game { public static void run(World world) {\n";
        assertCompiles("Game", around + code + "} }", folder);
        try (World world =
                        WorldScenes.jvm().bounds(0, 0, 100, 100).gravity(0, -10).build();
                URLClassLoader loader =
                        new URLClassLoader(new URL[] {folder.toUri().toURL()})) {
            loader.loadClass("Game").getMethod("run", World.class).invoke(null, world);
            int joints = world.joints().size();
            assertThat(joints).isGreaterThan(500);
            world.step(1 / 60f);
            for (int id = 0; id < world.idLimit(); id++) {
                long circle = world.handle(id);
                assertThat(Math.hypot(world.vx(circle), world.vy(circle)))
                        .as("nothing jumps")
                        .isLessThan(2);
            }
        }
    }

    @Test
    void theLoopOfRollbackCompilesInAGame(@TempDir Path folder) throws IOException {
        String code = snippet(read("src/main/java/io/github/circles2d/Rollback.java"), "Rollback rollback");
        String around = "class Packet { int player; int frame; long input; }\n"
                + "abstract class Game { World world; Rollback.Game game; int me; abstract boolean playing();"
                + " abstract java.util.List<Packet> arrived(); abstract long keys(); abstract void draw(World world);"
                + " abstract void send(int player, int frame, long input); void run() {\n";
        assertCompiles("Game", "import io.github.circles2d.*;\n" + around + code + "} }", folder);
    }

    /** The code of a page of Javadoc that begins so. */
    private static String snippet(String page, String beginning) {
        String text = page.replaceAll("(?m)^ \\* ?", "");
        return first("(?s)<pre>\\{@code\\n(" + Pattern.quote(beginning) + ".*?)\\}</pre>", text);
    }

    private static void assertCompiles(String name, String code, Path folder) {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        assertThat(compiler).as("this Java runtime has a compiler").isNotNull();
        JavaFileObject source =
                new SimpleJavaFileObject(URI.create("string:///" + name + ".java"), JavaFileObject.Kind.SOURCE) {
                    @Override
                    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                        return code;
                    }
                };
        List<String> options = List.of(
                "-Xlint:all",
                "-Werror",
                "--release",
                "17",
                "-d",
                folder.toString(),
                "-cp",
                System.getProperty("java.class.path"));
        StringWriter log = new StringWriter();
        boolean compiles = compiler.getTask(log, null, null, options, null, List.of(source))
                .call();
        assertThat(compiles).as(log.toString()).isTrue();
        assertThat(folder.resolve(name + ".class")).exists();
    }

    @Test
    void theGameLoopOfTheReadmeIsTheOneThatTheConsumerRuns() throws IOException {
        assertThat(block(read("README.md"), "java")).isEqualTo(read(CONSUMER + "/src/main/java/Game.java"));
    }

    @Test
    void allFilesNameThisVersionOfTheArtifacts() throws IOException {
        String version = first("<version>(.*?)</version>", read("pom.xml"));
        Pattern names = Pattern.compile("<artifactId>circles2d[-a-z]*</artifactId>\\s*<version>(.*?)</version>"
                + "|<circles2d\\.version>(.*?)<|io\\.github\\.circles2d:circles2d:([\\w.-]*\\w)");
        List<String> files = new ArrayList<>(List.of(
                "README.md", "docs/platforms.md", CONSUMER + "/pom.xml", "release/pom.xml", "playground/pom.xml"));
        for (String folder : new String[] {"bench", "samples", "web"}) {
            try (Stream<Path> all = Files.find(
                    Path.of(folder),
                    3,
                    (file, of) -> file.endsWith("pom.xml") && !file.toString().contains("target"))) {
                all.forEach(file -> files.add(file.toString()));
            }
        }
        for (String file : files) {
            List<String> found = names.matcher(read(file))
                    .results()
                    .flatMap(match -> IntStream.rangeClosed(1, 3).mapToObj(match::group))
                    .filter(text -> text != null && !text.startsWith("${"))
                    .toList();
            assertThat(found).as(file).isNotEmpty().containsOnly(version);
        }
    }

    /** The folders of the sample games. */
    private static List<Path> games() throws IOException {
        try (Stream<Path> folders = Files.list(Path.of("samples"))) {
            List<Path> games = folders.filter(folder -> Files.exists(folder.resolve("pom.xml")))
                    .sorted()
                    .toList();
            assertThat(games).hasSizeGreaterThanOrEqualTo(5);
            return games;
        }
    }

    /** So that nobody has to look for it: each is in the README and the launcher's help, and its page shows it and says how to start it. */
    @Test
    void everyGameHasAPageWithASmallPictureAndIsNamedWhereItIsLookedFor() throws IOException {
        String usage = first("(?s)usage\\(\\) \\{(.*?)\nEND\n", read("circles2d"));
        for (Path game : games()) {
            String name = game.getFileName().toString();
            assertThat(read(game + "/README.md")).contains("](picture.png)", "`./circles2d play " + name + "`");
            assertThat(Files.size(game.resolve("picture.png"))).isBetween(1_000L, 150_000L);
            assertThat(read("README.md")).contains("./circles2d play " + name, game + "/README.md");
            assertThat(usage).contains(name);
        }
    }

    @Test
    void everyCommandThatTheReadmeNamesIsOneOfTheLauncher() throws IOException {
        List<String> commands = Pattern.compile("\\./circles2d (\\w+)")
                .matcher(read("README.md"))
                .results()
                .map(match -> match.group(1))
                .distinct()
                .collect(Collectors.toList());
        assertThat(commands).contains("thesis", "test", "bench", "doctor");
        String launcher = read("circles2d");
        for (String command : commands) {
            assertThat(launcher).containsPattern("(?m)^  (help \\| .*|" + command + "\\))");
        }
    }

    @ParameterizedTest
    @MethodSource("pages")
    void everyLinkLeadsToAFileAndToAHeading(Path page) throws IOException {
        Matcher links =
                Pattern.compile("\\]\\(([^)#\\s]*)(?:#([^)\\s]*))?\\)").matcher(withoutCode(read(page.toString())));
        while (links.find()) {
            if (links.group(1).startsWith("http")) {
                continue;
            }
            Path target = links.group(1).isEmpty() ? page : page.resolveSibling(links.group(1));
            assertThat(target).as("link in " + page).exists();
            if (links.group(2) != null) {
                assertThat(anchors(read(target.toString())))
                        .as("link to %s in %s", target, page)
                        .contains(links.group(2));
            }
        }
    }

    static List<Path> pages() throws IOException {
        List<Path> pages = new ArrayList<>();
        for (String folder : new String[] {"", "docs", "bench", "bench/results", "playground"}) {
            try (Stream<Path> files = Files.list(Path.of(folder))) {
                files.filter(file -> file.toString().endsWith(".md")).sorted().forEach(pages::add);
            }
        }
        games().forEach(game -> pages.add(game.resolve("README.md")));
        assertThat(pages).hasSizeGreaterThan(15);
        return pages;
    }

    private static String withoutCode(String markdown) {
        return markdown.replaceAll("(?ms)^```.*?^```$", "").replaceAll("`[^`\n]*`", "`");
    }

    /** The names by which links find the headings of a page. */
    private static Set<String> anchors(String markdown) {
        return Pattern.compile("(?m)^#+ (.*)$")
                .matcher(markdown.replaceAll("(?ms)^```.*?^```$", ""))
                .results()
                .map(heading -> heading.group(1)
                        .toLowerCase(Locale.ROOT)
                        .replaceAll("[^\\w\\- ]", "")
                        .replace(' ', '-'))
                .collect(Collectors.toSet());
    }

    /** A picture that nobody shows is forgotten when the library changes. */
    @Test
    void everyPictureOfTheJavadocIsThereSmallAndShown() throws IOException {
        Path types = Path.of("src/main/java/io/github/circles2d");
        Set<String> shown = new TreeSet<>();
        try (Stream<Path> files = Files.list(types)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Pattern.compile("<img src=\"doc-files/([\\w-]+\\.svg)\" alt=\"[^\"]+\">")
                        .matcher(read(file.toString()))
                        .results()
                        .forEach(picture -> shown.add(picture.group(1)));
            }
        }
        Set<String> there = new TreeSet<>();
        try (Stream<Path> files = Files.list(types.resolve("doc-files"))) {
            for (Path file : files.toList()) {
                there.add(file.getFileName().toString());
                assertThat(Files.size(file)).as("%s", file).isLessThan(10_000);
            }
        }
        assertThat(shown).isEqualTo(there).hasSizeGreaterThanOrEqualTo(7);
    }

    /** Whoever wants to know more finds a link. */
    @ParameterizedTest
    @CsvSource({
        "README.md, 1700",
        "ARCHITECTURE.md, 1300",
        "CONTRIBUTING.md, 2200",
        "docs/how-to-extend.md, 2000",
        "docs/notes.md, 8000"
    })
    void aPageStaysShort(String page, int words) throws IOException {
        assertThat(read(page).trim().split("\\s+")).hasSizeLessThanOrEqualTo(words);
    }

    /** All that people write: of the pages that the benchmarks generate, the templates instead. */
    @Test
    void thePagesTogetherHaveFewWords() throws IOException {
        List<Path> written = new ArrayList<>(pages());
        assertThat(written.removeIf(page -> page.toString().matches("docs/(benchmarks.*|broad-phases|physics)\\.md")))
                .isTrue();
        try (Stream<Path> files = Files.list(Path.of("bench/src/main/resources/io/github/circles2d/bench"))) {
            files.filter(file -> file.toString().endsWith(".md")).forEach(written::add);
        }
        assertThat(written).contains(Path.of("bench/src/main/resources/io/github/circles2d/bench/page.md"));
        long words = 0;
        for (Path page : written) {
            words += read(page.toString()).trim().split("\\s+").length;
        }
        assertThat(words).isLessThanOrEqualTo(60_000);
    }

    @Test
    void theGlossaryHasFewWords() throws IOException {
        assertThat(read("docs/glossary.md").lines().filter(line -> line.startsWith("| ")))
                .hasSizeLessThanOrEqualTo(81); // the heading is one
    }

    /** A name in code style that begins with a capital and has a small letter: a class, an example's variables apart, or a kernel file. */
    @ParameterizedTest
    @ValueSource(strings = {"ARCHITECTURE.md", "docs/decisions.md", "docs/glossary.md", "docs/patterns.md"})
    void everyClassAndKernelFileThatAPageNamesExists(String page) throws IOException {
        Set<String> files = new TreeSet<>();
        for (String folder : new String[] {
            "src/main/java", "src/test/java", "playground/src/main/java", "bench/src/main/java", "kernels"
        }) {
            try (Stream<Path> all = Files.walk(Path.of(folder))) {
                all.forEach(file -> files.add(file.getFileName().toString()));
            }
        }
        String text = read(page).replaceAll("(?ms)^```.*?^```$", "");
        Matcher names = Pattern.compile("`(?:[a-z_]+[./])*([A-Z]\\w*[a-z]\\w*)(\\.cl)?[^`]*`")
                .matcher(text);
        Set<String> known = Set.of("NoClassDefFoundError", "FP_CONTRACT");
        int count = 0;
        while (names.find()) {
            if (!known.contains(names.group(1))) {
                String file = names.group(1) + (names.group(2) == null ? ".java" : ".cl");
                assertThat(files).as("%s in %s", names.group(), page).contains(file);
                count++;
            }
        }
        assertThat(count).as("names in " + page).isGreaterThan(5);
    }

    @ParameterizedTest
    @ValueSource(strings = {"README.md", "CONTRIBUTING.md", "docs/guide.md", "docs/opencl.md"})
    void everyClassOfTheProjectThatADocumentNamesExists(String document) throws IOException {
        Matcher names = Pattern.compile("io\\.github\\.circles2d\\.(?:\\w+\\.)*[A-Z]\\w*")
                .matcher(read(document));
        while (names.find()) {
            String file = names.group().replace('.', '/') + ".java";
            assertThat(List.of(Path.of("src/main/java", file), Path.of("src/test/java", file)))
                    .as("class in " + document)
                    .anyMatch(Files::exists);
        }
    }

    @Test
    void everyTestOfTheTableOfPromisesExists() throws IOException {
        Set<String> tests = new TreeSet<>();
        for (String folder : new String[] {"src/test/java", "playground/src/test/java", "bench/src/test/java"}) {
            try (Stream<Path> files = Files.walk(Path.of(folder))) {
                files.forEach(file -> tests.add(file.getFileName().toString().replace(".java", "")));
            }
        }
        Matcher names = Pattern.compile("`(\\w+Test)`").matcher(read("CONTRIBUTING.md"));
        int count = 0;
        while (names.find()) {
            assertThat(tests).contains(names.group(1));
            count++;
        }
        assertThat(count).isGreaterThan(30);
    }

    /** So that a run without the tests that take long proves something of each class. */
    @Test
    void everyClassWithATestThatTakesLongHasAQuickOneToo() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/test/java"))) {
            for (Path file :
                    files.filter(file -> file.toString().endsWith("Test.java")).toList()) {
                String source = read(file.toString());
                long left = source.lines()
                        .filter(line -> line.matches("    @Tag\\(\"(long|exhaustive)\"\\)"))
                        .count();
                long all = source.lines()
                        .filter(line -> line.matches("    @(Test|ParameterizedTest|OnEach\\w+)"))
                        .count();
                assertThat(source.lines())
                        .as("%s has the tag on methods", file)
                        .noneMatch(line -> line.matches("@Tag\\(\"(long|exhaustive)\"\\)"));
                if (left > 0) {
                    assertThat(all).as("tests in %s", file).isGreaterThan(left);
                }
            }
        }
    }

    private static String block(String markdown, String language) {
        return first("(?s)```" + language + "\\n(.*?)```", markdown);
    }

    private static String first(String pattern, String text) {
        Matcher matcher = Pattern.compile(pattern).matcher(text);
        assertThat(matcher.find()).as("there is a " + pattern).isTrue();
        return matcher.group(1);
    }

    private static String read(String file) throws IOException {
        return Files.readString(Path.of(file), StandardCharsets.UTF_8);
    }
}
