package io.github.circles2d.world.model;

/** All that a step needs besides circles and grids. */
public final class StepInput {
    public final StepConstants constants = new StepConstants();

    /** What circles do to each other by kinds, a {@link PairTable}; read during the step. */
    public int[] responses;

    public int responsesVersion;

    public final KindMotion motion = new KindMotion();
    public final KindSleep sleep = new KindSleep();
    public final KindSurface surfaces = new KindSurface();
    public final TerrainStep terrain = new TerrainStep();
    public final JointStep joints = new JointStep();
    public final StepReports reports = new StepReports();
}
