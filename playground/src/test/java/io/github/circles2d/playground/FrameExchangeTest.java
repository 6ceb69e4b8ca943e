package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** No frame is seen while it is filled, and none is older than one that was seen. */
class FrameExchangeTest {
    private static final int FRAMES = 20_000;
    private static final int LENGTH = 64;

    @Test
    void theFrameThatIsShownIsWholeAndTheNewest() throws Exception {
        FrameExchange exchange = new FrameExchange();
        CompletableFuture<Void> filling = CompletableFuture.runAsync(
                () -> {
                    for (int k = 1; k <= FRAMES; k++) {
                        Frame frame = exchange.toFill();
                        frame.ensure(LENGTH);
                        for (int i = 0; i < LENGTH; i++) {
                            frame.colour[i] = k;
                        }
                        exchange.publish();
                    }
                },
                command -> new Thread(command).start());
        int last = 0;
        while (last < FRAMES && !filling.isCompletedExceptionally()) {
            Frame frame = exchange.latest();
            if (frame.colour.length > 0) {
                int seen = frame.colour[0];
                assertThat(seen).isGreaterThanOrEqualTo(last);
                for (int i = 1; i < LENGTH; i++) {
                    assertThat(frame.colour[i]).isEqualTo(seen);
                }
                last = seen;
            }
        }
        filling.get(30, TimeUnit.SECONDS);
        assertThat(exchange.latest()).as("nothing newer").isSameAs(exchange.latest());
    }
}
