package io.github.circles2d.world.shared;

import io.github.circles2d.world.bodies.RigidTable;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.terrain.TerrainTables;

/**
 * The parts of a world, each of which is there once; calls get them from here. A part uses others in its calls, not when it is made, or those
 * above it.
 */
public final class WorldParts {
    /** Who makes the steps. */
    public Pipeline pipeline;

    public final Guard guard = new Guard(this::canReplace);
    public final HandleTable handles = new HandleTable();
    public final Commands commands = new Commands();
    public final KindTable kinds = new KindTable();
    public final ContactEvents events = new ContactEvents();
    public final StepInput input = new StepInput();
    public final WorldSettings settings;
    public final TerrainTables terrain;
    public final JointTables joints;
    public final RigidTable rigids;
    public final CallLog log = new CallLog(this);
    public final Calls calls = new Calls(this);
    public final FrameClock clock = new FrameClock();
    public final Moves moves = new Moves(this);
    public final Needs needs = new Needs(this);
    public final PendingWork pending = new PendingWork(this);
    public final LastReading last = new LastReading(this);
    public final WorldState state = new WorldState(this);
    public final Copies copies = new Copies(this);

    /** Those of a world without circles. The parameters have been checked. */
    public WorldParts(Pipeline pipeline, WorldParameters start) {
        use(pipeline);
        settings = new WorldSettings(events, start);
        terrain = new TerrainTables(input.terrain, settings.bounds());
        events.setPieces(terrain.pieces);
        rigids = new RigidTable(handles, terrain.pieces.ids);
        terrain.pieces.watch(rigids::pieceGoes);
        joints = new JointTables(input.joints, handles, terrain, rigids);
    }

    /** Sets who makes the steps to come. */
    void use(Pipeline next) {
        pipeline = next;
        next.watch(cause -> {
            if (pipeline == next) {
                guard.lose(cause);
            }
        });
    }

    private boolean canReplace(Throwable failure) {
        return moves.lost(failure);
    }

    /** The id of the circle that has a handle. */
    public int circle(long handle) {
        int id = handles.find(handle);
        return id >= 0 ? id : refuse(goneCircle(handle));
    }

    /** The id of the piece of terrain that has a handle. */
    public int piece(long handle) {
        int piece = terrain.pieces.ids.find(handle);
        return piece >= 0 ? piece : refuse(gone("piece of terrain", handle, Handle.PIECE));
    }

    /** The id of the body of terrain that has a handle. */
    public int body(long handle) {
        int body = terrain.bodies.ids.find(handle);
        return body >= 0 ? body : refuse(gone("body of terrain", handle, Handle.BODY));
    }

    /** The id of the rigid body that has a handle. */
    public int rigid(long handle) {
        int body = rigids.ids.find(handle);
        return body >= 0 ? body : refuse(goneRigid(handle));
    }

    /** The id of the joint that has a handle. */
    public int joint(long handle) {
        int joint = joints.table.ids.find(handle);
        return joint >= 0 ? joint : refuse(goneJoint(handle));
    }

    private static int refuse(String why) {
        throw new IllegalArgumentException(why);
    }

    /** Why a handle of no circle is refused. */
    public static String goneCircle(long handle) {
        String instead = Handle.has(handle, Handle.RIGID)
                ? ". Bodies has its calls (touching in place of contactsOf), and a kind its gravity scale, damping, greatest speed "
                        + "and surface"
                : "";
        return gone("circle", handle, 0) + instead;
    }

    /** Why a handle of no body that is pushed is refused. */
    public static String goneRigid(long handle) {
        return gone("body", handle, Handle.RIGID);
    }

    /** Why a handle of no joint is refused. */
    public static String goneJoint(long handle) {
        return Handle.has(handle, Handle.JOINT)
                ? "no joint has the handle " + handle + ": it was removed or has broken, or is none of this world's"
                : gone("joint", handle, Handle.JOINT);
    }

    private static String gone(String what, long handle, int mark) {
        return "no " + what + " has the handle " + handle + Handle.reason(handle, mark);
    }
}
