package io.github.circles2d.world.model;

/** All that a step needs besides circles and grids. */
public final class StepInput {
    public final StepConstants constants = new StepConstants();
    public final PairResponses responses = new PairResponses();
    public final KindMotion motion = new KindMotion();
    public final KindSleep sleep = new KindSleep();
    public final KindSurface surfaces = new KindSurface();
    public final TerrainStep terrain = new TerrainStep();
    public final JointStep joints = new JointStep();
    public final StepReports reports = new StepReports();
}
