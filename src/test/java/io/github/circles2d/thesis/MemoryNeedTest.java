package io.github.circles2d.thesis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.OnEachDevice;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;

@Tag("each-jdk")
class MemoryNeedTest {
    private static final Pattern FITTING = Pattern.compile("(\\d+) circles would fit");

    @OnEachDevice
    void theNumberThatIsSaidToFitFitsAndOneMoreDoesNot(Device device) {
        for (PairStrategy strategy : ThesisStages.strategies()) {
            for (long free : new long[] {8, 100, 1_000, 123_456, 50_000_000, 900_000_000}) {
                int fitting = fittingCircles(strategy, device, free);
                assertThatCode(() -> MemoryNeed.of(strategy, fitting).requireRoom(device, free))
                        .doesNotThrowAnyException();
                assertThatThrownBy(() -> MemoryNeed.of(strategy, fitting + 1).requireRoom(device, free))
                        .isInstanceOf(DeviceMemoryException.class)
                        .hasMessageContaining(free + " bytes free");
            }
        }
    }

    private static int fittingCircles(PairStrategy strategy, Device device, long free) {
        DeviceMemoryException refusal =
                catchThrowableOfType(DeviceMemoryException.class, () -> MemoryNeed.of(strategy, PairSlots.MAX_CIRCLES)
                        .requireRoom(device, free));
        Matcher number = FITTING.matcher(refusal.getMessage());
        assertThat(number.find()).as(refusal.getMessage()).isTrue();
        return Integer.parseInt(number.group(1));
    }

    @OnEachDevice
    void theLargestBufferCountsByItself(Device device) {
        int circles = PairSlots.MAX_CIRCLES;
        long collision = 8 * PairSlots.count(circles);
        if (collision > device.maxBufferBytes()) {
            assertThatThrownBy(() -> MemoryNeed.of(new ExactPairs(), circles).requireRoom(device, Long.MAX_VALUE))
                    .isInstanceOf(DeviceMemoryException.class)
                    .hasMessageContaining(collision + " in one buffer")
                    .hasMessageContaining("allows " + device.maxBufferBytes());
        } else {
            assertThatCode(() -> MemoryNeed.of(new ExactPairs(), circles).requireRoom(device, Long.MAX_VALUE))
                    .doesNotThrowAnyException();
        }
    }

    @OnEachDevice
    void evenUnlimitedMemoryEndsAtTheSlotsThatAnIntCanNumber(Device device) {
        int tooMany = PairSlots.MAX_CIRCLES + 1;
        assertThat(PairSlots.count(PairSlots.MAX_CIRCLES)).isLessThan(1L << 31);
        assertThat(PairSlots.count(tooMany)).isGreaterThanOrEqualTo(1L << 31);
        assertThatThrownBy(() -> MemoryNeed.of(new ExactPairs(), tooMany).requireRoom(device, Long.MAX_VALUE))
                .isInstanceOf(DeviceMemoryException.class)
                .hasMessageContaining("65536 circles at most");
    }
}
