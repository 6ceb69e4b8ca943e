package io.github.circles2d.world.device.plan;

import io.github.circles2d.world.device.memory.Status;
import io.github.circles2d.world.device.memory.StatusWord;
import io.github.circles2d.world.device.memory.TileRecord;

/**
 * How the last step filled its tiles: percent of the room that the fullest took, {@code TileRecord.NONE} if none would do, 0 if
 * there were none; tiles of the list, also those without room; whether some were cut.
 */
public record TileUse(int peak, int listed, boolean cut) {
    /** What tells plans to make the step without tiles. */
    public static final TileUse NONE_DO = new TileUse(TileRecord.NONE, 0, false);

    /** As the device tells it. */
    public static TileUse of(Status status) {
        return new TileUse(
                status.get(StatusWord.TILE_PEAK),
                status.get(StatusWord.TILES_LISTED),
                status.has(StatusWord.TILES_CUT));
    }
}
