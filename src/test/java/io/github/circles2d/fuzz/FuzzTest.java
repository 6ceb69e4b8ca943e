package io.github.circles2d.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.opencl.TestScale;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Random programs of all public calls, in worlds with one, two, three and seven threads and on devices side by side. After each step all worlds
 * say the same to the bit; a call that is refused has changed nothing; no world loses its state, nor ends the JVM.
 *
 * <p>Programs run in a JVM of their own. Of one that fails, this test tells the seed and a short program. To run it again:
 *
 * <pre>
 * ./circles2d test -Dtest=FuzzTest#oneProgramAlone -Dcircles2d.fuzz.seed=SEED -Dcircles2d.fuzz.lines=1,5,9
 * </pre>
 */
class FuzzTest {
    private static final long SEED = Long.getLong("circles2d.fuzz.seed", 1);

    /** Of a program whose fault ends the JVM, which costs one more for each attempt. */
    private static final int ATTEMPTS = 12;

    private static final Pattern SEED_LINE = Pattern.compile("(?m)^seed (\\d+)$");

    /** Everything that a game can call is in a table of the fuzz. */
    @Test
    void eachPublicMethodIsInATable() {
        Set<String> declared = new TreeSet<>();
        Table.ALL.forEach(entry -> declared.add(Api.name(entry.method())));
        List<String> own = Api.methods().stream()
                .filter(method -> !Api.isMadeByHand(method))
                .map(Api::name)
                .filter(name -> !declared.contains(name))
                .toList();
        assertThat(own).isEmpty();
    }

    /** A new public class is one of those that a fuzz knows, or one that it has a reason to leave out. */
    @Test
    void eachPublicClassIsKnown() throws Exception {
        Path classes = Path.of(Api.TYPES
                .get(0)
                .getProtectionDomain()
                .getCodeSource()
                .getLocation()
                .toURI());
        Path folder = classes.resolve(Api.TYPES.get(0).getPackageName().replace('.', '/'));
        List<String> unknown = new ArrayList<>();
        try (var files = Files.list(folder)) {
            for (Path file : files.toList()) {
                String name = file.getFileName().toString();
                if (name.endsWith(".class") && !name.startsWith("package-info")) {
                    Class<?> type = Class.forName(
                            Api.TYPES.get(0).getPackageName() + "." + name.substring(0, name.length() - 6));
                    if (Api.isUnknown(type)) {
                        unknown.add(name);
                    }
                }
            }
        }
        assertThat(unknown).isEmpty();
    }

    @Test
    void programsAreTheSameOnAnyNumberOfThreads() {
        run(SEED, TestScale.of(5, 600), List.of());
    }

    /** Where the heap is full, a call changes nothing, or a step says that the state is lost. */
    @Test
    @Tag("long")
    void aCallThatLacksMemoryHasChangedNothing() {
        String output = check(SEED, fork(SEED, TestScale.of(15, 600), "memory", "all", List.of()), List.of());
        assertThat(output).doesNotContain(" 0 calls without memory");
    }

    @Test
    @Tag("long")
    void programsAreTheSameOnEveryBackEnd() {
        String output = run(SEED + 1_000_000, TestScale.of(60, 3600), devices());
        if (TestScale.EXHAUSTIVE) { // a minute is too short for all
            assertThat(output)
                    .as("methods that no program has made, or that have always been refused")
                    .contains("missing []");
        }
    }

    /** The one that a failure has named, with all its lines or some. */
    @Test
    @Tag("exhaustive")
    void oneProgramAlone() {
        String lines = System.getProperty("circles2d.fuzz.lines", "each");
        check(SEED, fork(SEED, 0, mode(SEED), lines, devices()), devices());
    }

    private static List<Backend> devices() {
        return TestDevices.all().stream()
                .map(device -> device.kind() == Device.Kind.GPU ? Backend.OPENCL_GPU : Backend.OPENCL_CPU)
                .distinct()
                .toList();
    }

    private static String run(long seed, int seconds, List<Backend> devices) {
        return check(seed, fork(seed, seconds, mode(seed), "all", devices), devices);
    }

    /** In an exhaustive run worlds compile what they need, and so what they need first in the middle of a program. */
    private static String mode(long seed) {
        return TestScale.EXHAUSTIVE && seed % 2 == 0 ? "needed" : "ready";
    }

    private static ForkedJvm.Result fork(long seed, int seconds, String mode, String lines, List<Backend> devices) {
        List<String> arguments = new ArrayList<>(List.of("" + seed, "" + seconds, mode, lines));
        devices.forEach(device -> arguments.add(device.name()));
        ForkedJvm jvm = new ForkedJvm();
        String kernels = System.getProperty("circles2d.kernels");
        if (kernels != null) {
            jvm.option("-Dcircles2d.kernels=" + kernels);
        }
        return jvm.option(mode.equals("memory") ? "-Xmx24m" : "-Xmx2g")
                .option("-XX:+UseSerialGC")
                .environment("POCL_SIGFPE_HANDLER", "0")
                .run(FuzzRun.class, arguments.toArray(String[]::new));
    }

    /** Fails with what the JVM has printed of failures. If a fault has ended it, tells of the program that it was at. */
    private static String check(long seed, ForkedJvm.Result result, List<Backend> devices) {
        String output = result.output();
        if (result.exitStatus() != 0 && result.exitStatus() != FuzzRun.FAILED) {
            throw new AssertionError("the JVM ended with status " + result.exitStatus() + " in "
                    + deadly(lastSeed(output, seed), devices) + "\n" + tail(output));
        }
        if (result.exitStatus() == FuzzRun.FAILED) {
            throw new AssertionError(
                    output.lines().filter(line -> !line.matches("seed \\d+")).collect(Collectors.joining("\n")));
        }
        return output;
    }

    private static long lastSeed(String output, long first) {
        return SEED_LINE
                .matcher(output)
                .results()
                .mapToLong(match -> Long.parseLong(match.group(1)))
                .reduce(first, (before, last) -> last);
    }

    private static String tail(String output) {
        byte[] bytes = output.getBytes(StandardCharsets.UTF_8);
        return new String(
                bytes, Math.max(0, bytes.length - 3000), Math.min(bytes.length, 3000), StandardCharsets.UTF_8);
    }

    /** A program that ends the JVM, with as few lines as some attempts find. */
    private static String deadly(long seed, List<Backend> devices) {
        Program program = new Program(seed);
        int[] attempts = {ATTEMPTS};
        BitSet least = new Shrinker(300, lines -> {
                    if (attempts[0]-- <= 0 || lines.isEmpty()) {
                        return false;
                    }
                    int status =
                            fork(seed, 0, mode(seed), numbers(lines), devices).exitStatus();
                    return status != 0 && status != FuzzRun.FAILED;
                })
                .shrink(program.all());
        return "lines " + numbers(least) + " of " + program.text(least);
    }

    private static String numbers(BitSet lines) {
        return Arrays.stream(lines.stream().toArray())
                .mapToObj(Integer::toString)
                .collect(Collectors.joining(","));
    }
}
