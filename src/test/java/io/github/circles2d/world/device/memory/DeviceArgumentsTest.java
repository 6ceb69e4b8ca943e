package io.github.circles2d.world.device.memory;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.ReachableNames;
import io.github.circles2d.world.device.memory.DeviceArray.Index;
import io.github.circles2d.world.device.plan.Plans;
import java.util.BitSet;
import org.junit.jupiter.api.Test;

/** The tests of all plans show that no buffer is missing, since a kernel would read nothing there; here is what is left out. */
class DeviceArgumentsTest {
    private final ReachableNames names = DeviceArguments.names(Plans.source(Plans.all()));

    private BitSet used(String kernel) {
        return DeviceArguments.used(names, kernel);
    }

    @Test
    void aKernelUsesTheBuffersOfArraysThatItsTextNames() {
        BitSet buffers = used("grid_count");
        assertThat(buffers.get(DeviceArguments.position(DeviceArray.CONSTANTS))).isTrue();
        assertThat(buffers.get(DeviceArguments.position(DeviceArray.HOME_CIRCLE)))
                .isTrue();
        assertThat(buffers.get(DeviceArguments.position(DeviceArray.LEVELS))).isTrue();
        assertThat(buffers.get(DeviceArguments.position(DeviceArray.CONTACT))).isFalse();
        assertThat(buffers.get(DeviceArguments.position(Index.TILE))).isFalse();
    }

    @Test
    void tablesOfTerrainAndJointsLieInThatOfKinds() {
        assertThat(DeviceArguments.position(DeviceArray.TERRAIN))
                .isEqualTo(DeviceArguments.position(DeviceArray.KIND_MOTION));
        assertThat(used("pieces_find").get(DeviceArguments.position(DeviceArray.TERRAIN)))
                .isTrue();
        assertThat(used("joints_begin").get(DeviceArguments.position(DeviceArray.JOINTS)))
                .isTrue();
    }

    /** Each costs a driver time, in 20 launches a step. */
    @Test
    void mostKernelsUseFewBuffers() {
        for (String kernel :
                new String[] {"grid_count", "grid_scatter", "contacts_cutTiles", "contacts_list", "contacts_link"}) {
            assertThat(used(kernel).cardinality()).as(kernel).isLessThan(DeviceArguments.COUNT / 2);
        }
    }
}
