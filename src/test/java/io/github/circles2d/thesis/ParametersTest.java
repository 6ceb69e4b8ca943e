package io.github.circles2d.thesis;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.invoke.VarHandle;
import org.junit.jupiter.api.Test;

class ParametersTest {
    @Test
    void whatWasCheckedIsTakenWhileAnotherThreadWritesIntoTheArray() throws InterruptedException {
        float[] gravity = new float[2];
        Thread writer = new Thread(() -> {
            while (!Thread.currentThread().isInterrupted()) {
                gravity[0] = Float.NaN;
                VarHandle.fullFence(); // or the compiler leaves the first value out
                gravity[0] = 1;
            }
        });
        writer.start();
        try {
            for (int k = 0; k < 300_000; k++) {
                try {
                    assertFinite(Parameters.of(0.01f, 0.5f, gravity));
                } catch (IllegalArgumentException e) {
                    // The other value comes soon.
                }
            }
        } finally {
            writer.interrupt();
            writer.join();
        }
    }

    private static void assertFinite(Parameters parameters) {
        if (!Float.isFinite(parameters.gravityX)) {
            assertThat(parameters.gravityX).isFinite();
        }
    }
}
