package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.world.device.memory.Status;
import io.github.circles2d.world.device.memory.StatusWord;
import io.github.circles2d.world.device.memory.TileRecord;
import java.util.List;
import java.util.Set;

/** A way to put steps to a device. All plans give the same bits; they differ in the worlds and devices that they suit. */
public interface Plan {
    /** The kernel files that the plan needs besides those that all plans share, and those that they use. */
    List<String> files();

    /** Adds the numbers that the files share with the host. */
    default KernelSource define(KernelSource source) {
        return source;
    }

    /** Whether the plan needs the arrays for tiles alone. */
    default boolean usesTileArrays() {
        return false;
    }

    /** The kernels that the plan alone needs: a program apart, which a driver may take long to compile. */
    default Set<String> ownKernels() {
        return Set.of();
    }

    /** Takes its kernels out of the compiled programs; before all that follows, and again if others have been compiled. */
    void load(Stages stages);

    /** Whether the plan can make such steps. */
    boolean suits(Steps steps);

    /** Enqueues steps that it suits. */
    void enqueue(Steps steps);

    /** Whether its launches decide themselves what such steps report; else there is one step a launch, and {@link EventStage} does. */
    default boolean decidesEvents(Steps steps) {
        return false;
    }

    /** Whether its launches tell of contacts and walls themselves; else {@link #tell} does. */
    default boolean tells() {
        return false;
    }

    /** Enqueues what tells of the contacts and walls of the last step, which it has made, and which recorded them. */
    void tell(int circles);

    /** Counts the contacts of each circle after a step of this plan, into ranks, which are all zeros before. */
    void countDegrees(int contacts);

    /** Takes note of how the last step filled its tiles, whichever plan made it. */
    default void learn(TileUse use, boolean thinning) {}

    /**
     * How the last step filled its tiles: percent of the room that the fullest took, {@code TileRecord.NONE} if none would do, 0 if
     * there were none; tiles of the list, also those without room; whether some were cut.
     */
    record TileUse(int peak, int listed, boolean cut) {
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
}
