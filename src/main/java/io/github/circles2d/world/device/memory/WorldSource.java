package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.world.events.PieceCode;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.Reach;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.TouchRule;
import io.github.circles2d.world.model.Tuning;
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
        "world/stages/Readback.cl"
    };

    private WorldSource() {}

    /** The files of all plans, those of some plans, and the files that these use, by paths below {@code kernels}. */
    public static KernelSource of(Collection<String> planFiles) {
        return tables().and(SHARED).and(planFiles.toArray(String[]::new));
    }

    /** What the host tells all files: its tables and numbers. */
    public static KernelSource tables() {
        return KernelSource.ofText(WorldTables.NAME, WorldTables.text())
                .define("EDGE_WALL", AxisEdge.WALL.ordinal())
                .define("EDGE_OPEN", AxisEdge.OPEN.ordinal())
                .define("LEVELS", GridLevels.COUNT)
                .define("FEW", GridLevels.FEW)
                .define("ENDLESS", GridLevels.ENDLESS)
                .define("SHEET_X_FACTOR", GridLevels.SHEET_X_FACTOR)
                .define("SHEET_Y_FACTOR", GridLevels.SHEET_Y_FACTOR)
                .define("MARGIN", Tuning.MARGIN)
                .define("CAP", Tuning.CAP)
                .define("TRAVEL", Tuning.TRAVEL)
                .define("SWEEP_RATIO", Tuning.SWEEP_RATIO)
                .define("CLAMP_ALLOWANCE", Tuning.CLAMP_ALLOWANCE)
                .define("RUN_OVER", Tuning.RUN_OVER)
                .define("HOLD", Tuning.HOLD)
                .define("ASIDE", Tuning.ASIDE)
                .define("DULL", Tuning.DULL)
                .define("GRAZE", Tuning.GRAZE)
                .define("CORNER", Tuning.CORNER)
                .define("JAMMED", Tuning.JAMMED)
                .define("COVER", Tuning.COVER)
                .define("FLUSH", Tuning.FLUSH)
                .define("ROUNDED", Tuning.ROUNDED)
                .define("DEEP_RATE", Tuning.DEEP_RATE)
                .define("DEEP_OFFSET", Tuning.DEEP_OFFSET)
                .define("NEARLY_ELASTIC", Tuning.NEARLY_ELASTIC)
                .define("BOUNCE_DEPTH", Tuning.BOUNCE_DEPTH)
                .define("LINGER", Tuning.LINGER)
                .define("REACH_SLACK", Reach.SLACK)
                .define("REACH_STATIC_SLACK", Reach.STATIC_SLACK)
                .define("GREATEST_REACH", Reach.GREATEST)
                .define("REACH_EDGE_LOG", Reach.EDGE_LOG)
                .define("CROWD", Tuning.CROWD)
                .define("RANGE_LOG", CrossRule.RANGE_LOG)
                .define("LOAD_UNITS", CrossRule.LOAD_UNITS)
                .define("WAIT_DEPTH", CrossRule.WAIT_DEPTH)
                .define("WAIT_DEPTH_OF_SMALLER", CrossRule.WAIT_DEPTH_OF_SMALLER)
                .define("TOUCH_SLACK", TouchRule.SLACK)
                .define("FIRST_WALL", Limits.CIRCLES)
                .define("FIRST_PIECE", PieceCode.of(0))
                .define("ALL_AROUND", PieceRow.ALL_AROUND)
                .define("COINCIDENT", Tuning.COINCIDENT)
                .define("GREATEST_SPEED", Tuning.GREATEST_SPEED)
                .define("UNITS_PER_RADIAN", Surface.UNITS_PER_RADIAN)
                .define("RADIANS_PER_UNIT", JointMath.RADIANS_PER_UNIT)
                .define("GREATEST_JOINT_IMPULSE", JointMath.GREATEST_IMPULSE)
                .define("JOINT_STRAIN", Tuning.JOINT_STRAIN)
                .define("JOINT_PUSH", Tuning.JOINT_PUSH)
                .define("SCAN_GROUP", Scan.GROUP)
                .define("SCAN_EACH", Scan.EACH)
                .define("BLOCK_LOG", DeviceArrays.BLOCK_LOG);
    }
}
