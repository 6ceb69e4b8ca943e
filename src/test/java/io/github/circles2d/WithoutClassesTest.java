package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.InvocationTargetException;
import java.net.URL;
import java.net.URLClassLoader;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Where a system lacks classes, as Android lacks System.Logger, AUTO takes the JVM and nothing fails. */
@Tag("each-jdk")
class WithoutClassesTest {
    /** Loads the library's classes once more, but for some that it says are missing. JavaCL and BridJ are missing, too. */
    private static final class Lacking extends URLClassLoader {
        private static final String BASE = "io.github.circles2d.";

        private final List<String> missing;

        Lacking(List<String> missing) {
            super(
                    Stream.of(World.class, Game.class)
                            .map(type ->
                                    type.getProtectionDomain().getCodeSource().getLocation())
                            .toArray(URL[]::new),
                    ClassLoader.getPlatformClassLoader());
            this.missing = missing;
        }

        @Override
        protected Class<?> findClass(String name) throws ClassNotFoundException {
            if (missing.stream().anyMatch(start -> name.startsWith(BASE + start))) {
                throw new NoClassDefFoundError(name);
            }
            return super.findClass(name);
        }
    }

    /** A game that takes any back end. */
    public static final class Game {
        private Game() {}

        /** Makes a step, and returns the name of the back end. */
        public static String play() {
            try (World world = World.builder().capacity(5_000).build()) {
                world.add(0.5f, 0.5f, 0.1f, 1);
                world.step(1 / 60f);
                return world.stats().backend().name();
            }
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "opencl. calibration. Calibration Circles2D thesis. world.device. OpenClChoice Notice$WorldLog",
                "OpenClChoice",
                "Calibration",
                "opencl.",
                "Notice$WorldLog"
            })
    void autoTakesTheJvm(String missing) throws Exception {
        assertThat(playWithout(missing)).isEqualTo("JVM");
    }

    @Test
    void aClassThatEveryWorldNeedsIsMissed() {
        assertThatThrownBy(() -> playWithout("world.Simulation"))
                .isInstanceOf(InvocationTargetException.class)
                .hasCauseInstanceOf(NoClassDefFoundError.class);
    }

    private static Object playWithout(String missing) throws Exception {
        try (Lacking loader = new Lacking(List.of(missing.split(" ")))) {
            return loader.loadClass(Game.class.getName()).getMethod("play").invoke(null);
        }
    }
}
