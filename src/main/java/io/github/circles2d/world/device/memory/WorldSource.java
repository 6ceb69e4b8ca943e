package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.KernelSource;
import java.util.Collection;

/** The source of the stages' kernels; the numbers that host and device share are defined from their one place in Java. */
public final class WorldSource {
    private static final String[] SHARED = {
        "world/stages/Scan.cl",
        "world/stages/Commands.cl",
        "world/stages/Grid.cl",
        "world/stages/Pieces.cl",
        "world/stages/Contacts.cl",
        "world/stages/Sensing.cl",
        "world/stages/StaticSensing.cl",
        "world/stages/Readback.cl"
    };

    private WorldSource() {}

    /** The files of all plans, those of some plans, and the files that these use, by paths below {@code kernels}. */
    public static KernelSource of(Collection<String> planFiles) {
        return tables().and(SHARED).and(planFiles.toArray(String[]::new));
    }

    /** What the host tells all files: its tables and numbers. */
    public static KernelSource tables() {
        return KernelSource.ofText(WorldTables.NAME, WorldTables.text());
    }
}
