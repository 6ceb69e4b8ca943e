package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Who waits for a compiler learns why, while it waits; who does not wait learns nothing. */
class CompilerNoticeTest {
    private static final Logger LOGGER = Logger.getLogger(DevicePipeline.class.getName());

    private final BlockingQueue<String> said = new LinkedBlockingQueue<>();

    private final Handler handler = new Handler() {
        @Override
        public void publish(LogRecord record) {
            said.add(record.getMessage());
        }

        @Override
        public void flush() {}

        @Override
        public void close() {}
    };

    @BeforeEach
    void listen() {
        LOGGER.addHandler(handler);
        LOGGER.setUseParentHandlers(false);
    }

    @AfterEach
    void listenNoMore() {
        LOGGER.removeHandler(handler);
        LOGGER.setUseParentHandlers(true);
    }

    private void awaitFirstLine() {
        try {
            assertThat(said.poll(100, TimeUnit.SECONDS))
                    .isEqualTo("World waits until kernels are compiled for a GPU; most drivers keep them");
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void aLongWaitIsToldOfWhileItLastsAndWhenItEnds() {
        CompilerNotice.during(this::awaitFirstLine, "a GPU");
        assertThat(said).hasSize(1);
        assertThat(said.remove()).matches("World has waited \\d+\\.\\d s for the compiler of a GPU");
    }

    @Test
    void aWaitForACompilerThatRefusesIsToldOfToo() {
        assertThatThrownBy(() -> CompilerNotice.during(
                        () -> {
                            awaitFirstLine();
                            throw new IllegalStateException("refused");
                        },
                        "a GPU"))
                .hasMessage("refused");
        assertThat(said).hasSize(1);
    }

    @Test
    void aShortWaitIsNotToldOf() throws InterruptedException {
        CompilerNotice.during(() -> {}, "a GPU");
        assertThat(said.poll(1500, TimeUnit.MILLISECONDS)).isNull();
    }
}
