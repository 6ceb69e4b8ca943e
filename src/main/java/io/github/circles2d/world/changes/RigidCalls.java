package io.github.circles2d.world.changes;

import static io.github.circles2d.world.shared.Call.real;
import static java.lang.Float.floatToRawIntBits;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidLimits;
import io.github.circles2d.world.bodies.RigidTable;
import io.github.circles2d.world.joints.JointDepartures;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;
import java.util.ArrayList;
import java.util.List;

/** The calls that change rigid bodies. A change acts from the next step on. */
public final class RigidCalls implements Calls.Effects {
    private final WorldParts world;
    private final RigidTable table;
    private final Kinds kinds;
    private final int[] words = new int[Call.MOST_WORDS];

    /** The outlines that a log has told of, by their numbers there. */
    private final List<OutlineShape> told = new ArrayList<>();

    /** The words of the outline of which a log has the beginning; null if none has begun. */
    private int[] begun;

    private int begunWords;

    public RigidCalls(WorldParts world, Kinds kinds) {
        this.world = world;
        this.kinds = kinds;
        table = world.rigids;
        world.calls.define(
                this,
                Call.OUTLINE,
                Call.OUTLINE_WORDS,
                Call.RIGID,
                Call.REMOVE_RIGID,
                Call.CLEAR_RIGIDS,
                Call.RIGID_VELOCITY,
                Call.RIGID_ANGULAR_VELOCITY,
                Call.RIGID_IMPULSE,
                Call.RIGID_ANGULAR_IMPULSE,
                Call.RIGID_FORCE,
                Call.RIGID_KIND,
                Call.RIGID_TAG,
                Call.RIGID_RESTITUTION,
                Call.RIGID_INERTIA,
                Call.TELEPORT_RIGID,
                Call.RIGID_FORCE_AT,
                Call.RIGID_LASTING_FORCE,
                Call.RIGID_LASTING_TORQUE,
                Call.RIGID_GROUP,
                Call.WAKE_RIGID);
    }

    /** Adds a body at rest, at an angle in radians, with the restitution of its kind, else the world's, and returns its handle. */
    public long add(OutlineShape outline, float x, float y, float angle, float mass, int kind) {
        world.guard.enter();
        try (world.guard) {
            words[1] = kind;
            words[2] = floatToRawIntBits(x);
            words[3] = floatToRawIntBits(y);
            words[4] = floatToRawIntBits(angle);
            words[5] = floatToRawIntBits(mass);
            Call.RIGID.check(words, world.settings);
            try {
                long body = add(outline, words);
                world.calls.end();
                return body;
            } catch (RuntimeException | Error e) {
                throw world.guard.failed(e);
            }
        }
    }

    /** The first word has no meaning. */
    private long add(OutlineShape outline, int[] w) {
        RigidLimits.room(table.ids.size(), 1);
        RigidLimits.reach(outline, world.settings.bounds());
        if (!table.isThere()) {
            world.needs.prepareRigids();
        }
        table.ensure(1);
        table.prepare(outline);
        makeRoomToWake(1);
        return addPrepared(outline, w);
    }

    /** Adds a body that has been checked, and for which there is room, by the words behind the first one. */
    long addPrepared(OutlineShape outline, int[] w) {
        w[0] = world.log.outline(outline);
        world.calls.begin(Call.RIGID, w);
        Bounds bounds = world.settings.bounds();
        int kind = w[1];
        int body = table.add(
                outline,
                bounds.placeX(real(w[2])),
                bounds.placeY(real(w[3])),
                Surface.units(real(w[4])),
                real(w[5]),
                kind,
                kinds.newRestitution(kind));
        wakeNear(body);
        return table.ids.handle(body);
    }

    /** Makes room for so many bodies to wake what is near to them. */
    void makeRoomToWake(int bodies) {
        if (world.settings.sleeps()) {
            world.commands.ensureAreas(2 * bodies);
        }
    }

    /** Wakes the circles near to a body that comes, goes or changes. There is room. */
    private void wakeNear(int body) {
        if (world.settings.sleeps()) {
            float x = table.step.x[body];
            float y = table.step.y[body];
            float reach = table.step.outline[body].reach();
            Bounds bounds = world.settings.bounds();
            world.commands.wakeAround(x, y, reach);
            table.step.wakeNear(body, x, y, reach, bounds.periodX(), bounds.periodY());
        }
    }

    /** An impulse at the centroid. */
    public void applyImpulse(long body, float x, float y) {
        world.guard.check();
        int id = world.rigid(body);
        world.calls.changeByFloats(Call.RIGID_IMPULSE, body, x, y, table.step.x[id], table.step.y[id]);
    }

    // ---- calls by their words

    @Override
    public long make(Call call, int[] w) {
        switch (call) {
            case OUTLINE -> {
                if (w[0] < 1 || w[0] > OutlineShape.MOST_WORDS) {
                    throw new IllegalArgumentException("no outline has " + w[0] + " words");
                }
                begun = new int[w[0]];
                begunWords = 0;
                hear(w, 1);
                return 0;
            }
            case OUTLINE_WORDS -> {
                if (begun == null) {
                    throw new IllegalArgumentException("an outline has more words than it says");
                }
                hear(w, 0);
                return 0;
            }
            case RIGID -> {
                if (w[0] < 0 || w[0] >= told.size()) {
                    throw new IllegalArgumentException("no outline has the number " + w[0]);
                }
                System.arraycopy(w, 0, words, 0, Call.RIGID.words);
                return add(told.get(w[0]), words);
            }
            case RIGID_INERTIA -> RigidLimits.inertia(real(w[1]), table.mass(w[0]), table.step.outline[w[0]]);
            default -> makeRoom(call, 1);
        }
        world.calls.begin(call, w);
        change(call, w);
        return 0;
    }

    /** Makes room for calls on so many bodies that are there. */
    void makeRoom(Call call, int bodies) {
        switch (call) {
            case RIGID_KIND, TELEPORT_RIGID -> makeRoomToWake(bodies);
            case REMOVE_RIGID, CLEAR_RIGIDS -> {
                makeRoomToWake(bodies);
                world.pending.settleJoints();
                world.joints.departures.ensure(world.joints.table.rigid.count());
            }
            case RIGID_GROUP -> {
                makeRoomToWake(bodies);
                table.ensureExtras();
            }
            case RIGID_LASTING_FORCE, RIGID_LASTING_TORQUE -> table.ensureExtras();
            default -> {
                // it needs none
            }
        }
    }

    /** Changes a body as a call says, which has been checked and begun. There is room. */
    void change(Call call, int[] w) {
        table.step.changes++;
        switch (call) {
            case REMOVE_RIGID -> {
                world.joints.departures.removeOfRigid(w[0]);
                wakeNear(w[0]);
                table.remove(w[0]);
            }
            case CLEAR_RIGIDS -> {
                world.joints.departures.removeOfRigid(JointDepartures.ALL);
                wakeAll();
                table.clear();
            }
            case RIGID_VELOCITY -> table.setVelocity(w[0], real(w[1]), real(w[2]));
            case RIGID_ANGULAR_VELOCITY -> table.setOmega(w[0], real(w[1]));
            case RIGID_IMPULSE ->
                table.push(w[0], real(w[1]), real(w[2]), real(w[3]), real(w[4]), world.settings.bounds());
            case RIGID_ANGULAR_IMPULSE -> table.pushAround(w[0], real(w[1]));
            case RIGID_FORCE -> table.applyForce(w[0], real(w[1]), real(w[2]), real(w[3]));
            case RIGID_FORCE_AT ->
                table.applyForceAt(w[0], real(w[1]), real(w[2]), real(w[3]), real(w[4]), world.settings.bounds());
            case RIGID_LASTING_FORCE -> table.setForce(w[0], real(w[1]), real(w[2]));
            case RIGID_LASTING_TORQUE -> table.setTorque(w[0], real(w[1]));
            case RIGID_GROUP -> {
                wakeNear(w[0]);
                table.setGroup(w[0], w[1]);
            }
            case RIGID_KIND -> {
                wakeNear(w[0]);
                table.setKind(w[0], w[1], kinds.restitution(w[1], table.step.restitution[w[0]]));
            }
            case RIGID_TAG -> table.setTag(w[0], Call.value(w[1], w[2]));
            case RIGID_RESTITUTION -> {
                table.step.wake(w[0]);
                table.step.restitution[w[0]] = real(w[1]) + 0f;
            }
            case RIGID_INERTIA -> {
                table.step.wake(w[0]);
                table.setInertia(w[0], real(w[1]));
            }
            case WAKE_RIGID -> table.step.wake(w[0]);
            default -> {
                Bounds bounds = world.settings.bounds();
                wakeNear(w[0]);
                table.teleport(w[0], bounds.placeX(real(w[1])), bounds.placeY(real(w[2])), Surface.units(real(w[3])));
                wakeNear(w[0]);
            }
        }
    }

    private void wakeAll() {
        if (world.settings.sleeps()) {
            world.commands.wakeAll();
        }
    }

    /** Takes words of an outline of a log, from one on. */
    private void hear(int[] w, int from) {
        int count = Math.min(Call.MOST_WORDS - from, begun.length - begunWords);
        System.arraycopy(w, from, begun, begunWords, count);
        begunWords += count;
        for (int k = from + count; k < Call.MOST_WORDS; k++) {
            if (w[k] != 0) {
                throw new IllegalArgumentException("an outline has more words than it says");
            }
        }
        if (begunWords == begun.length) {
            told.add(OutlineShape.of(begun));
            begun = null;
        }
    }

    /** A log begins: no outline of another one counts. */
    public void forgetOutlines() {
        told.clear();
        begun = null;
    }
}
