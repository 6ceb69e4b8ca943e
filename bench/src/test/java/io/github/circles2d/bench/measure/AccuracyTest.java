package io.github.circles2d.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.bench.Devices;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.opencl.Device;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.opentest4j.TestAbortedException;

class AccuracyTest {
    @TempDir
    Path temporary;

    static Collection<Device> devices() {
        Collection<Device> devices = Devices.all().values();
        if (devices.isEmpty() && !Boolean.getBoolean("circles2d.device.required")) {
            throw new TestAbortedException("no OpenCL device");
        }
        return devices;
    }

    @ParameterizedTest
    @MethodSource("devices")
    void wrongSlotsAreThoseThatTheEngineCounts(Device device) throws IOException {
        try (WrongSlots slots = new WrongSlots(device)) {
            assertThat(slots.count(1000)).isZero();
            assertThat(slots.count(10_000)).isPositive().isEqualTo(slots.countOfEngine(10_000));
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    void theSizesThatAreAskedForAreCountedAndTheFirstWrongOneIsSought(Device device) throws IOException {
        ResultsFolder folder = ResultsFolder.open(temporary.resolve("machine"));
        assertThat(new AccuracyWork("d", device, List.of(500, 1000), 10, folder).run(new Pace(), 10))
                .isEqualTo("no wrong slot up to n = 1,000");
        assertThat(folder.table(Kind.ACCURACY).rows("n", "1000"))
                .singleElement()
                .satisfies(
                        row -> assertThat(row).containsEntry("slots", "499500").containsEntry("wrong_slots", "0"));
    }
}
