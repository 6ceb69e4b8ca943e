package io.github.circles2d.world.shared;

/** Whether the pipeline's figures are those of the last step. */
public final class StepFigures {
    private boolean hold;

    /** Takes note of a step: without circles the pipeline makes none, and its figures do not hold. */
    public void stepped(boolean byPipeline) {
        hold = byPipeline;
    }

    /** The state is another one. */
    public void forget() {
        hold = false;
    }

    /** Whether they are. */
    public boolean hold() {
        return hold;
    }
}
