package io.github.circles2d.opencl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The first use of OpenCL may come from a thread that has been interrupted. */
@Tag("each-jdk")
class InterruptedStartTest {
    /** Starts a world on an interrupted thread, and divides by zero. */
    static final class Program {
        private static volatile int zero;

        public static void main(String[] arguments) {
            Thread.currentThread().interrupt();
            try (World world = World.builder()
                    .backend(Backend.valueOf(arguments[0]))
                    .capacity(100_000)
                    .build()) {
                world.add(0.5f, 0.5f, 0.1f, 1);
                world.step(1 / 60f);
                System.out.println("runs on " + world.stats().backend());
            } catch (OpenClUnavailableException e) {
                System.out.println("unavailable: " + e.getMessage());
            }
            System.out.println("interrupted: " + Thread.currentThread().isInterrupted());
            try {
                System.out.println("1 / 0 is " + 1 / zero);
            } catch (ArithmeticException e) {
                System.out.println("division by zero is refused");
            }
        }
    }

    @Test
    void autoWorksAndDivisionByZeroIsRefused() {
        ForkedJvm.Result result = new ForkedJvm().run(Program.class, "AUTO");
        assertThat(result.output()).contains("runs on", "interrupted: true", "division by zero is refused");
        assertThat(result.exitStatus()).isZero();
    }

    @Test
    void openClWorksAndDivisionByZeroIsRefused() {
        TestDevices.all();
        ForkedJvm.Result result = new ForkedJvm().run(Program.class, "OPENCL_CPU");
        assertThat(result.output()).contains("runs on OPENCL_CPU", "interrupted: true", "division by zero is refused");
    }

    @Test
    void openClIsRefusedIfTheSignalsCannotBeProtected(@TempDir Path folder) {
        assertThatThrownBy(() ->
                        NativeAccess.keepSignalsOfJava(folder.resolve("maps").toFile()))
                .isInstanceOf(OpenClUnavailableException.class)
                .hasMessageContaining("signals")
                .hasMessageContaining(folder.toString());
    }
}
