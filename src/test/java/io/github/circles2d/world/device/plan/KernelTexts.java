package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.SourceFiles;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** Writes the programs of World for an NVIDIA GPU into a folder, which needs no device; {@code .ci/gate} counts their registers. */
public final class KernelTexts {
    /** A program each: its name and what is defined. */
    private static final List<List<String>> PROGRAMS = List.of(
            List.of("plain"),
            List.of("turning", "TURNING"),
            List.of("sleeping", "TURNING", "SLEEPING"),
            List.of("all", "EDGES", "TURNING", "TERRAIN", "JOINTS", "REPORTING", "RECORDING"));

    /** That of each NVIDIA GPU so far. */
    private static final int GREATEST_WORK_GROUP = 1024;

    private KernelTexts() {}

    public static void main(String[] arguments) throws IOException {
        KernelSource common = JointKernels.define(SleepStage.define(Plans.source(Plans.all())))
                .define("PTX", true)
                .define("EVENT_GROUP", Tiles.eventGroup(GREATEST_WORK_GROUP));
        for (List<String> program : PROGRAMS) {
            KernelSource source = common;
            for (String feature : program.subList(1, program.size())) {
                source = source.define(feature, 1);
            }
            SourceFiles.write(source, Path.of(arguments[0]), program.get(0));
        }
    }
}
