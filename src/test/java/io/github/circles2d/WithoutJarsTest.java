package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClUnavailableException;
import io.github.circles2d.tools.Doctor;
import java.io.ByteArrayOutputStream;
import java.nio.file.Path;
import java.util.List;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A program may leave the jars of JavaCL and BridJ out: it has World on the JVM then, and is told so. */
@Tag("each-jdk")
class WithoutJarsTest {
    private static final String CONSUMER = "src/test/resources/consumer/src/main/java/WithoutOpenCl.java";

    private static final String ALL = "javacl-core opencl4java bridj nativelibs4java-utils";

    /** Uses everything twice, for a linkage error may change its face, and prints what came. */
    static final class Everything {
        public static void main(String[] arguments) {
            for (int round = 0; round < 2; round++) {
                for (Backend backend : Backend.values()) {
                    attempt(() -> world(backend));
                }
                attempt(() -> new Circles2D(true).close());
                attempt(() -> new Circles2D(false).close());
                attempt(OpenCl::devices);
            }
        }

        private static void world(Backend backend) {
            World.Builder builder =
                    World.builder().bounds(0, 0, 10, 10).capacity(5_000).backend(backend);
            try (World world = builder.build()) {
                world.add(5, 5, 1, 1);
                do {
                    world.step(1 / 60f); // a device is opened beside the second one
                } while (world.stats().reason().contains("made ready"));
                System.out.println(backend + " takes " + world.stats().backend());
            }
        }

        private static void attempt(Runnable action) {
            try {
                action.run();
            } catch (OpenClUnavailableException e) {
                System.out.println("refused: " + e.getMessage());
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"javacl-core", "bridj", "opencl4java nativelibs4java-utils", ALL})
    void autoTakesTheJvmSilentlyAndTheRestIsRefusedByNameOfTheJar(String missing) {
        String[] jars = missing.split(" ");
        ForkedJvm.Result result = new ForkedJvm().without(jars).run(Everything.class);

        assertThat(result.exitStatus()).as(result.output()).isZero();
        assertThat(lines(result, "AUTO takes JVM")).hasSize(2);
        assertThat(lines(result, "JVM takes JVM")).hasSize(2);
        List<String> refused = lines(result, "refused: ");
        assertThat(refused).hasSize(10).allSatisfy(line -> assertThat(line)
                .contains(jars)
                .contains("io.github.circles2d:circles2d")
                .doesNotContain("pocl"));
        assertThat(result.output()).doesNotContain("INFO", "WARNING", "SEVERE", "\tat ");
    }

    @Test
    void aGameBuildsAndRunsWithTheClassesOfTheLibraryAlone(@TempDir Path game) throws Exception {
        Path library = Path.of(
                World.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        int status = compiler.run(
                null, log, log, "-Xlint:all", "-Werror", "-d", game.toString(), "-cp", library.toString(), CONSUMER);
        assertThat(status).as(log.toString()).isZero();

        ForkedJvm.Result result = new ForkedJvm().only(library, game).run("WithoutOpenCl");

        assertThat(result.output()).contains("plays without OpenCL");
        assertThat(result.exitStatus()).as(result.output()).isZero();
    }

    @Test
    void theDoctorNamesTheJarAndPrescribesNoDriver() {
        ForkedJvm.Result result = new ForkedJvm().without("bridj").run(Doctor.class);

        assertThat(result.output())
                .contains("does not work: the class path lacks com.nativelibs4java:bridj")
                .doesNotContain("apt-get");
        assertThat(result.exitStatus()).isEqualTo(1);
    }

    private static List<String> lines(ForkedJvm.Result result, String start) {
        return result.output().lines().filter(line -> line.startsWith(start)).toList();
    }
}
