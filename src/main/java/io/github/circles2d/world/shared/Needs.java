package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.snapshots.SavedState;

/**
 * What the pipeline must be ready for. Circles can rotate if something in the world may turn, grip or roll them; the world has terrain if there are
 * pieces; circles move in another way than those of their kind once one has had a gravity scale, a damping or a greatest speed of its own. Steps
 * of other worlds compute nothing of that, and pipelines keep nothing for it. No result depends on it, so it is no state. Circles can rotate until
 * all of them go, or another state takes their place.
 */
public final class Needs {
    private final WorldParts world;

    /** Whether a call has made a circle turn, or has given it a surface or a torque. */
    private boolean asked;

    private boolean turns;

    /** Whether the pipeline is ready for terrain. */
    private boolean hasTerrain;

    /** Whether the pipeline is ready for joints. */
    private boolean hasJoints;

    /** Whether the pipeline is ready for circles that move in another way than those of their kind. */
    private boolean hasOwnMotion;

    Needs(WorldParts world) {
        this.world = world;
    }

    /** Whether circles can rotate, and the pipeline is ready for that. */
    public boolean turns() {
        return turns;
    }

    /** What the pipeline is ready for. */
    Features features() {
        return Features.of(
                !world.settings.bounds().isWalled(),
                turns,
                hasTerrain,
                hasJoints,
                world.settings.sleeps(),
                hasOwnMotion,
                world.rigids.isThere());
    }

    /** A call makes a circle turn, or gives it a surface or a torque. */
    public void askToTurn() {
        asked = true;
    }

    /** Whether the world has begun to turn, and the pipeline is not ready for that. */
    boolean beginsToTurn() {
        return !turns
                && (asked
                        || world.kinds.grips()
                        || world.settings.surfaces().any()
                        || world.joints.table.turns()
                        || world.rigids.isThere());
    }

    /** Whether the pipeline is not ready for what the world has begun to need. */
    boolean begins() {
        return beginsToTurn()
                || !hasTerrain && world.terrain.isThere()
                || !hasJoints && world.joints.isThere()
                || !hasOwnMotion && ownMotion();
    }

    /** Whether a circle moves in another way than those of its kind, or has done so. */
    public boolean ownMotion() {
        CircleFields fields = world.handles.fields();
        return fields.isUsed(CircleField.GRAVITY_SCALE)
                || fields.isUsed(CircleField.DAMPING)
                || fields.isUsed(CircleField.GREATEST_SPEED);
    }

    /** Makes the pipeline ready, all steps of which have been made. If it cannot be made so, nothing has changed. */
    public void prepare() {
        prepare(
                world.settings.parameters(),
                turns || beginsToTurn(),
                hasTerrain || world.terrain.isThere(),
                hasJoints || world.joints.isThere(),
                hasOwnMotion || ownMotion(),
                world.rigids.isThere());
    }

    /** Makes the pipeline ready for rigid bodies. If it cannot be made so, nothing has changed. */
    public void prepareRigids() {
        world.pending.finish();
        boolean before = turns;
        prepare(
                world.settings.parameters(),
                true,
                hasTerrain || world.terrain.isThere(),
                hasJoints || world.joints.isThere(),
                hasOwnMotion || ownMotion(),
                true);
        turns = before; // until there are some
    }

    /** Makes the pipeline ready for another state. The one that it has still is there if what follows fails. */
    public void prepare(SavedState next) {
        boolean before = turns;
        prepare(
                next.parameters(),
                turns || turns(next),
                hasTerrain || next.terrain.hasPieces(),
                hasJoints || next.joints.hasJoints(),
                hasOwnMotion || ownMotion(next),
                next.rigids.hasBodies());
        turns = before;
    }

    private void prepare(
            WorldParameters p,
            boolean turning,
            boolean withTerrain,
            boolean withJoints,
            boolean withOwnMotion,
            boolean withBodies) {
        Features features = Features.of(
                !p.bounds().isWalled(), turning, withTerrain, withJoints, p.sleeps(), withOwnMotion, withBodies);
        world.moves.beforeFeatures(p.contacts(), features);
        try {
            prepare(p.contacts(), features);
        } catch (RuntimeException e) {
            world.moves.goHome(e);
            prepare(p.contacts(), features);
        }
        turns = turning;
        hasTerrain = withTerrain;
        hasJoints = withJoints;
        hasOwnMotion = withOwnMotion;
    }

    private void prepare(ContactSettings contacts, Features features) {
        if (features.bodies()) {
            world.pipeline.prepare(world.rigids.step);
        }
        world.pipeline.prepare(contacts, features);
    }

    /** The same of a pipeline that the world is to move to. */
    void prepare(Pipeline next) {
        if (world.rigids.isThere()) {
            next.prepare(world.rigids.step);
        }
        next.prepare(world.settings.contacts(), features());
    }

    private static boolean turns(SavedState s) {
        return s.turns
                || s.kinds.grips()
                || s.parameters().surfaces().any()
                || s.fields.used(CircleField.FRICTION) > 0
                || s.fields.used(CircleField.ROLLING_RESISTANCE) > 0
                || s.fields.used(CircleField.TORQUE) > 0
                || s.fields.used(CircleField.APPLIED_TORQUE) > 0
                || s.pieceContacts.hold()
                || s.joints.turn()
                || s.rigids.hasBodies();
    }

    private static boolean ownMotion(SavedState s) {
        return s.fields.used(CircleField.GRAVITY_SCALE) > 0
                || s.fields.used(CircleField.DAMPING) > 0
                || s.fields.used(CircleField.GREATEST_SPEED) > 0;
    }

    /** A saved state, for which the pipeline is ready, has taken the place of all that was. */
    public void restored(SavedState from) {
        asked = false;
        turns = turns(from);
    }

    /** All circles have gone, and all changes of them. */
    public void cleared() {
        asked = false;
        turns = false;
    }
}
