package io.github.circles2d.world.device.memory;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.model.PieceRow;
import org.junit.jupiter.api.Test;

/** Where the tables of terrain lie in a device's memory. */
class TerrainRoomTest {
    @Test
    void tablesLieOneBehindTheOtherWhereVectorsMayBegin() {
        for (int size = 1; size < 70; size++) {
            TerrainRoom room = new TerrainRoom().with(size, 2 * size - 1, 28 * size);
            assertThat(room.at(TerrainRoom.ROWS)).isEqualTo(TerrainRoom.HEAD);
            assertRoom(room, TerrainRoom.ROWS, PieceRow.of(size));
            assertRoom(room, TerrainRoom.TRAITS, PieceRow.traits(size));
            assertRoom(room, TerrainRoom.BOXES, TerrainRoom.BOX * (2 * size - 1));
            assertRoom(room, TerrainRoom.LINKS, TerrainRoom.LINK * (2 * size - 1));
            assertThat(room.at(TerrainRoom.MOTION) % 4).isZero();
            assertThat(room.floats())
                    .isGreaterThanOrEqualTo(DeviceArray.TERRAIN_AT + room.at(TerrainRoom.MOTION) + 28 * size);
        }
        assertThat(DeviceArray.TERRAIN_AT % 4).isZero();
    }

    private static void assertRoom(TerrainRoom room, int table, int needed) {
        assertThat(room.at(table) % 4).isZero();
        assertThat(room.at(table + 1) - room.at(table)).isGreaterThanOrEqualTo(needed);
    }

    @Test
    void roomGrowsByHalfAndOnlyWhereItIsTooLittle() {
        TerrainRoom room = new TerrainRoom();
        assertThat(room.with(0, 0, 0)).isNull();
        int before = room.version();
        room.take(room.with(100, 199, 56));
        assertThat(room.version()).isEqualTo(before + 1);
        assertThat(room.with(100, 199, 56)).isNull();
        assertThat(room.with(1, 1, 0)).isNull();
        TerrainRoom more = room.with(101, 5, 5);
        assertThat(more.at(TerrainRoom.TRAITS) - more.at(TerrainRoom.ROWS)).isEqualTo(PieceRow.of(150));
        assertThat(more.at(TerrainRoom.LINKS) - more.at(TerrainRoom.BOXES)).isEqualTo(TerrainRoom.BOX * 199);
    }
}
