package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.WorldParameters;

/**
 * Whether the world turns: whether circles in it may turn, grip or roll. Steps of other worlds compute nothing of that, and pipelines keep
 * nothing for it. No result depends on it, so it is no state. It stays on until all circles go, or another state takes their place.
 */
public final class TurningFlag {
    private final Pipeline pipeline;
    private final KindTable kinds;
    private final WorldSettings settings;

    /** Whether a call has made a circle turn, or has given it a surface or a torque. */
    private boolean asked;

    private boolean on;

    public TurningFlag(Pipeline pipeline, KindTable kinds, WorldSettings settings) {
        this.pipeline = pipeline;
        this.kinds = kinds;
        this.settings = settings;
    }

    /** Whether the world turns, and the pipeline is ready for that. */
    public boolean isOn() {
        return on;
    }

    /** A call makes a circle turn, or gives it a surface or a torque. */
    public void ask() {
        asked = true;
    }

    /** Whether the world has begun to turn, and the pipeline is not ready for that. */
    boolean begins() {
        return !on && (asked || kinds.grips() || settings.surfaces().any());
    }

    /** Makes the pipeline ready, all steps of which have been made. If it cannot be made so, nothing has changed. */
    void begin() {
        prepare(settings.parameters(), true);
        on = true;
    }

    /** Makes the pipeline ready for a new world. */
    public void prepare() {
        boolean turning = begins();
        prepare(settings.parameters(), turning);
        on = turning;
    }

    /** Makes the pipeline ready for another state. The one that it has still is there if what follows fails. */
    public void prepare(SavedState next) {
        prepare(next.parameters(), on || turns(next));
    }

    private void prepare(WorldParameters p, boolean turning) {
        pipeline.prepare(p.contacts(), !p.bounds().isWalled(), turning, false);
    }

    private static boolean turns(SavedState s) {
        return s.turns
                || s.kinds.grips()
                || s.parameters().surfaces().any()
                || s.fields.used(CircleField.FRICTION) > 0
                || s.fields.used(CircleField.ROLLING_RESISTANCE) > 0
                || s.fields.used(CircleField.TORQUE) > 0
                || s.fields.used(CircleField.APPLIED_TORQUE) > 0;
    }

    /** A saved state, for which the pipeline is ready, has taken the place of all that was. */
    public void restored(SavedState from) {
        asked = false;
        on = turns(from);
    }

    /** All circles have gone, and all changes of them. */
    public void cleared() {
        asked = false;
        on = false;
    }
}
