package io.github.circles2d.world.device.memory;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.device.memory.JointArray.Count;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Where the tables of joints and of terrain lie in a device's memory. */
class TableRoomTest {
    static Stream<Arguments> rooms() {
        return Stream.of(
                Arguments.of(JointArray.room(), 0, Count.COUNT, JointArray.ALL),
                Arguments.of(
                        TerrainArray.room(),
                        TerrainArray.HEAD,
                        TerrainArray.Count.values().length,
                        TerrainArray.values()));
    }

    private static int[] needed(int counts, int each) {
        int[] needed = new int[counts];
        Arrays.fill(needed, each);
        return needed;
    }

    @ParameterizedTest
    @MethodSource("rooms")
    void tablesLieOneBehindTheOtherWhereVectorsMayBegin(
            TableRoom empty, int head, int counts, TableRoom.Table[] tables) {
        for (int size = 1; size < 70; size++) {
            TableRoom room = empty.with(needed(counts, size));
            int end = head;
            for (TableRoom.Table table : tables) {
                assertThat(room.at(table) % 4).isZero();
                assertThat(room.at(table)).isGreaterThanOrEqualTo(end);
                end = room.at(table) + size * table.words();
            }
            assertThat(room.words()).isGreaterThanOrEqualTo(end);
        }
    }

    @Test
    void headsEndBeforeTheTables() {
        assertThat(DeviceArray.JOINTS_AT % 4).isZero();
        assertThat(DeviceArray.TERRAIN_AT % 4).isZero();
        assertThat(DeviceArray.TERRAIN_AT)
                .isGreaterThanOrEqualTo(DeviceArray.JOINTS_AT + JointUpload.Head.STRUCT.words());
        assertThat(TerrainArray.room().at(TerrainArray.ROWS)).isEqualTo(TerrainArray.HEAD);
    }

    @Test
    void roomGrowsByHalfAndOnlyWhereItIsTooLittle() {
        TableRoom room = JointArray.room();
        assertThat(room.with(needed(Count.COUNT, 0))).isNull();
        int before = room.version();
        room.take(room.with(needed(Count.COUNT, 100)));
        assertThat(room.version()).isEqualTo(before + 1);
        assertThat(room.with(needed(Count.COUNT, 100))).isNull();
        int[] more = needed(Count.COUNT, 3);
        more[Count.SPLIT.ordinal()] = 101;
        TableRoom grown = room.with(more);
        assertThat(grown.capacity(Count.SPLIT)).isEqualTo(150);
        assertThat(grown.capacity(Count.JOINTS)).isEqualTo(100);
        assertThat(grown.words(JointArray.SPLIT_ENDS)).isEqualTo(300);
    }
}
