package io.github.circles2d.world.device.plan;

import io.github.circles2d.world.device.memory.Status;
import io.github.circles2d.world.device.memory.StatusWord;
import io.github.circles2d.world.device.memory.TileRecord;

/**
 * How the last step filled its tiles.
 *
 * @param peak percent of the room that the fullest one took, {@code TileRecord.NO_TILE} where none would do, or 0 where there were none
 * @param listed tiles of the list, if there was one, also those that there was no room for
 * @param cut whether some of these were cut
 */
public record TileUse(int peak, int listed, boolean cut) {
    /** What tells plans to make the step without tiles. */
    public static final TileUse NONE_DO = new TileUse(TileRecord.NO_TILE, 0, false);

    /** As the device tells it. */
    public static TileUse of(Status status) {
        return new TileUse(
                status.get(StatusWord.TILE_PEAK),
                status.get(StatusWord.TILES_LISTED),
                status.has(StatusWord.TILES_CUT));
    }
}
