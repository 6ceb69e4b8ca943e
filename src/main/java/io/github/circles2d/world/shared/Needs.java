package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.model.Bounds;
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

    /** Of those that pipelines stay ready for once a world has had them: terrain, joints, motion of circles' own. */
    private Features lasting = Features.NONE;

    Needs(WorldParts world) {
        this.world = world;
    }

    /** Whether circles can rotate, and the pipeline is ready for that. */
    public boolean turns() {
        return turns;
    }

    /** What the pipeline is ready for. */
    Features features() {
        boolean sleeps = world.settings.sleeps();
        return features(world.settings.bounds(), sleeps, turns, lasting, world.rigids.isThere());
    }

    private static Features features(
            Bounds bounds, boolean sleeping, boolean turning, Features others, boolean withBodies) {
        return others.and(Features.EDGES.when(!bounds.isWalled()))
                .and(Features.SLEEPING.when(sleeping))
                .and(Features.TURNING.when(turning))
                .and(Features.BODIES.when(withBodies));
    }

    private static Features lasting(boolean terrain, boolean joints, boolean ownMotion) {
        return Features.TERRAIN
                .when(terrain)
                .and(Features.JOINTS.when(joints))
                .and(Features.OWN_MOTION.when(ownMotion));
    }

    /** Those of the world as it is. */
    private Features begun() {
        return lasting(world.terrain.isThere(), world.joints.isThere(), ownMotion());
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
        return beginsToTurn() || !lasting.have(begun());
    }

    /** Whether a circle moves in another way than those of its kind, or has done so. */
    public boolean ownMotion() {
        return world.handles.fields().areMotionsUsed();
    }

    /** Makes the pipeline ready, all steps of which have been made. If it cannot be made so, nothing has changed. */
    public void prepare() {
        prepare(world.settings.parameters(), turns || beginsToTurn(), begun(), world.rigids.isThere());
    }

    /** Makes the pipeline ready for rigid bodies. If it cannot be made so, nothing has changed. */
    public void prepareRigids() {
        world.pending.finish();
        boolean before = turns;
        prepare(world.settings.parameters(), true, begun(), true);
        turns = before; // until there are some
    }

    /** Makes the pipeline ready for another state. The one that it has still is there if what follows fails. */
    public void prepare(SavedState next) {
        boolean before = turns;
        boolean ownMotion = next.fields.features().ownMotion();
        Features begun = lasting(next.terrain.hasPieces(), next.joints.hasJoints(), ownMotion);
        prepare(next.parameters(), turns || turns(next), begun, next.rigids.hasBodies());
        turns = before;
    }

    private void prepare(WorldParameters p, boolean turning, Features begun, boolean withBodies) {
        Features kept = lasting.and(begun);
        Features features = features(p.bounds(), p.sleeps(), turning, kept, withBodies);
        world.moves.beforeFeatures(p.contacts(), features);
        try {
            prepare(p.contacts(), features);
        } catch (RuntimeException e) {
            world.moves.goHome(e);
            prepare(p.contacts(), features);
        }
        turns = turning;
        lasting = kept;
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
                || s.fields.features().turning()
                || s.pieceContacts.hold()
                || s.joints.turn()
                || s.rigids.hasBodies();
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
