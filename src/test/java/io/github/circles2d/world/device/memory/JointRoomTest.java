package io.github.circles2d.world.device.memory;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.device.memory.JointArray.Count;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Where the tables of joints lie in a device's memory. */
class JointRoomTest {
    private static int[] needed(int each) {
        int[] needed = new int[Count.COUNT];
        Arrays.fill(needed, each);
        return needed;
    }

    @Test
    void tablesLieOneBehindTheOtherWhereVectorsMayBegin() {
        for (int size = 1; size < 70; size++) {
            JointRoom room = new JointRoom().with(needed(size));
            int end = 0;
            for (JointArray table : JointArray.ALL) {
                assertThat(room.at(table) % 4).isZero();
                assertThat(room.at(table)).isGreaterThanOrEqualTo(end);
                end = room.at(table) + size * table.words();
            }
            assertThat(room.words()).isGreaterThanOrEqualTo(end);
        }
        assertThat(DeviceArray.JOINTS_AT % 4).isZero();
        assertThat(DeviceArray.TERRAIN_AT).isGreaterThanOrEqualTo(DeviceArray.JOINTS_AT + JointHead.STRUCT.words());
    }

    @Test
    void roomGrowsByHalfAndOnlyWhereItIsTooLittle() {
        JointRoom room = new JointRoom();
        assertThat(room.with(needed(0))).isNull();
        int before = room.version();
        room.take(room.with(needed(100)));
        assertThat(room.version()).isEqualTo(before + 1);
        assertThat(room.with(needed(100))).isNull();
        int[] more = needed(3);
        more[Count.SPLIT.ordinal()] = 101;
        JointRoom grown = room.with(more);
        assertThat(grown.capacity(Count.SPLIT)).isEqualTo(150);
        assertThat(grown.capacity(Count.JOINTS)).isEqualTo(100);
    }
}
