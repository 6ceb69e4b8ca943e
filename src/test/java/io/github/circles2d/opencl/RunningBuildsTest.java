package io.github.circles2d.opencl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** An exit of the JVM waits for compilers, since a driver that is unloaded below its compiler ends the process with a signal. */
@Timeout(20)
class RunningBuildsTest {
    @Test
    void anExitWaitsForABuildThatRuns() throws InterruptedException {
        RunningBuilds builds = new RunningBuilds();
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch mayEnd = new CountDownLatch(1);
        Thread compiler = new Thread(() -> builds.run(() -> {
            begun.countDown();
            await(mayEnd);
        }));
        compiler.start();
        begun.await();
        Thread exit = new Thread(builds::awaitAtExit);
        exit.start();
        exit.join(100);
        assertThat(exit.isAlive()).isTrue();
        assertThat(builds.exits()).isTrue();
        mayEnd.countDown();
        exit.join();
        compiler.join();
    }

    @Test
    void anExitDoesNotWaitForABuildThatHasFailed() {
        RunningBuilds builds = new RunningBuilds();
        try {
            builds.run(() -> {
                throw new IllegalStateException("refused");
            });
        } catch (IllegalStateException e) {
            assertThat(e).hasMessage("refused");
        }
        builds.awaitAtExit();
        assertThat(builds.exits()).isTrue();
        assertThatIllegalStateException().isThrownBy(() -> builds.run(() -> {})).withMessageContaining("exits");
    }

    /** A process whose main ends while another thread compiles. */
    static final class Exits {
        public static void main(String[] arguments) throws InterruptedException {
            CountDownLatch begun = new CountDownLatch(1);
            Thread compiler = new Thread(() -> RunningBuilds.make(() -> {
                begun.countDown();
                await(new CountDownLatch(1), 1500);
                System.out.println("built");
            }));
            compiler.setDaemon(true);
            compiler.start();
            begun.await();
        }
    }

    @Test
    void aProcessEndsBehindItsCompiler() {
        ForkedJvm.Result result = new ForkedJvm().run(Exits.class);
        assertThat(result.output()).contains("built");
        assertThat(result.exitStatus()).isZero();
    }

    private static void await(CountDownLatch latch) {
        await(latch, 10_000);
    }

    private static void await(CountDownLatch latch, long milliseconds) {
        try {
            latch.await(milliseconds, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
