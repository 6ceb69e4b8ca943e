package io.github.circles2d.world.changes;

import static io.github.circles2d.world.shared.Call.real;
import static java.lang.Float.floatToRawIntBits;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.joints.GoneJoints;
import io.github.circles2d.world.joints.JointEnds;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.joints.JointLimits;
import io.github.circles2d.world.joints.JointSetting;
import io.github.circles2d.world.joints.JointTable;
import io.github.circles2d.world.joints.RigidEnds;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;

/** The calls that change joints. A change acts from the next step on. */
public final class JointCalls implements Calls.Effects {
    private final WorldParts world;
    private final JointTable table;

    /** What a call names. */
    private int[] found = new int[0];

    private int[] foundOthers = new int[0];
    private final IdSet leaving = new IdSet();

    /** What the next joints of a log are; null if it has not said so. */
    private JointForm form;

    private final int[] words = new int[Call.MOST_WORDS];

    /** Points of a new joint on bodies that are pushed. */
    private final float[] points = new float[4];

    // circles as of now, if new joints look at them
    private float[] circles;
    private int[] angles;

    public JointCalls(WorldParts world) {
        this.world = world;
        table = world.joints.table;
        world.calls.defineAll(this, Call.JOINT_FORM, Call.CLEAR_JOINTS);
        world.calls.define(this, Call.RIGID_JOINT);
    }

    // ---- joints come

    /** Adds a joint between two circles or bodies, which are held at their centroids, and returns its handle. */
    public long add(long first, long other, JointForm form) {
        if (Handle.has(first, Handle.RIGID) || Handle.has(other, Handle.RIGID)) {
            return add(typeOf(first), first, 0, 0, typeOf(other), other, 0, 0, form);
        }
        return add(Call.JOINT, first, other, 0, 0, form);
    }

    private static int typeOf(long handle) {
        return Handle.has(handle, Handle.RIGID) ? JointEnds.RIGID : JointEnds.CIRCLE;
    }

    /** Adds a joint that holds a circle or a body to no place, and returns its handle. */
    public long add(long circle, JointForm form) {
        if (Handle.has(circle, Handle.RIGID)) {
            return add(JointEnds.RIGID, circle, 0, 0, JointEnds.NOTHING, 0, 0, 0, form);
        }
        return add(Call.JOINT_ALONE, circle, 0, 0, 0, form);
    }

    /** Adds a joint of which an end is a body that is pushed, and returns its handle. Types are those of {@link JointEnds}. */
    public long add(
            int typeA, long first, float ax, float ay, int typeB, long other, float bx, float by, JointForm form) {
        world.guard.enter();
        try (world.guard) {
            world.pending.settleJoints();
            words[0] = typeA;
            words[1] = find(typeA, first, ": a body and its point come first, then the circle");
            words[2] = floatToRawIntBits(ax);
            words[3] = floatToRawIntBits(ay);
            words[4] = typeB;
            words[5] = find(typeB, other, ": a circle is held by its centre, and takes no point");
            words[6] = floatToRawIntBits(bx);
            words[7] = floatToRawIntBits(by);
            return add(Call.RIGID_JOINT, form);
        }
    }

    /** circle: what to do with a circle where a body should be. */
    private int find(int type, long handle, String circle) {
        return switch (type) {
            case JointEnds.CIRCLE -> circle(handle);
            case JointEnds.RIGID -> rigid(handle, circle);
            case JointEnds.ANCHOR -> world.body(handle);
            default -> 0;
        };
    }

    private int rigid(long handle, String circle) {
        if (world.handles.find(handle) >= 0) {
            throw new IllegalArgumentException(WorldParts.goneRigid(handle) + circle);
        }
        return world.rigid(handle);
    }

    /** The id of a circle, where a caller may have meant a body that is pushed. */
    private int circle(long handle) {
        return circle(
                handle,
                ", which a joint holds at a point: x and y of it, from the centroid, follow the handle of the body");
    }

    /** body: what to do with a body that is pushed. */
    private int circle(long handle, String body) {
        if (world.rigids.ids.find(handle) >= 0) {
            throw new IllegalArgumentException("no circle has the handle " + handle + Handle.reason(handle, 0) + body);
        }
        return world.circle(handle);
    }

    /** Adds a joint that holds a circle to a place of a body of terrain, in the body's coordinates, and returns its handle. */
    public long add(long circle, long body, float x, float y, JointForm form) {
        return add(Call.ANCHORED_JOINT, circle, body, x, y, form);
    }

    private long add(Call call, long circle, long other, float x, float y, JointForm form) {
        world.guard.enter();
        try (world.guard) {
            world.pending.settleJoints();
            words[0] = circle(circle);
            if (call != Call.JOINT_ALONE) {
                words[1] = call == Call.JOINT ? world.circle(other) : world.body(other);
            }
            words[2] = floatToRawIntBits(x);
            words[3] = floatToRawIntBits(y);
            return add(call, form);
        }
    }

    /** Adds a joint by {@link #words}. */
    private long add(Call call, JointForm of) {
        prepare(call, words, of);
        world.log.joints(of);
        world.calls.begin(call, words);
        long joint = apply(call, words, of);
        world.calls.end();
        return joint;
    }

    // ---- sleep

    /** Makes room for {@link #wake}. */
    private void expectToWake(int more) {
        if (world.settings.sleeps()) {
            world.pending.expect(2 * more);
        }
    }

    /** The circles of a joint wake that comes, goes or changes. There is room. */
    private void wake(int joint) {
        if (world.settings.sleeps()) {
            if (table.a(joint) != JointRow.NONE) {
                world.commands.set(Commands.WAKE, table.a(joint), 0, 0);
            }
            if (table.b(joint) != JointRow.NONE) {
                world.commands.set(Commands.WAKE, table.b(joint), 0, 0);
            }
            for (int end = RigidEnds.A; end <= RigidEnds.B; end++) {
                if (table.rigid.body(joint, end) != JointRow.NONE) {
                    world.rigids.step.wake(table.rigid.body(joint, end));
                }
            }
            world.rigids.step.changes++;
        }
    }

    /** Checks a joint that is to come, and makes room for it. */
    private void prepare(Call call, int[] w, JointForm of) {
        if (call == Call.RIGID_JOINT) {
            prepareOfBodies(w, of);
            if (of.kind() == JointForm.WELD) {
                world.joints.requireWeld(w[0], w[1], w[4], w[5], pointsOf(w), world.last.circles());
            }
        } else if (call == Call.ANCHORED_JOINT) {
            JointLimits.anchor(of, false, real(w[2]), real(w[3]));
            JointLimits.moves(w[0], world.handles);
        } else {
            check(of, w[0], call == Call.JOINT ? w[1] : JointRow.NONE);
        }
        begin(of, 1);
    }

    /** Checks a joint of bodies that are pushed. */
    private void prepareOfBodies(int[] w, JointForm of) {
        switch (w[4]) {
            case JointEnds.ANCHOR -> JointLimits.anchor(of, true, real(w[6]), real(w[7]));
            case JointEnds.NOTHING -> JointLimits.alone(of, true);
            default -> JointLimits.things(of);
        }
        if (w[0] == w[4] && w[1] == w[5]) {
            throw new IllegalArgumentException("both bodies have the handle " + world.rigids.ids.handle(w[1])
                    + ", but a joint holds two different ones");
        }
        boolean moves = false;
        for (int end = 0; end <= 4; end += 4) {
            if (w[end] == JointEnds.RIGID) {
                JointLimits.point(real(w[end + 2]), real(w[end + 3]), world.rigids.step.outline[w[end + 1]]);
                moves |= world.rigids.moves(w[end + 1]);
            } else if (w[end] == JointEnds.CIRCLE) {
                moves |= !world.handles.isStatic(w[end + 1]);
            }
        }
        if (!moves) {
            throw new IllegalArgumentException("nothing that the joint holds can move: "
                    + (w[0] == JointEnds.RIGID
                            ? "the body with the handle " + world.rigids.ids.handle(w[1])
                            : "the circle with the handle " + world.handles.handle(w[1])));
        }
    }

    /** Adds a joint of bodies that are pushed, and returns its id. */
    private int addOfBodies(int[] w, JointForm of) {
        int joint = world.joints.add(
                of,
                w[0] == JointEnds.CIRCLE ? w[1] : JointRow.NONE,
                w[4] == JointEnds.CIRCLE ? w[5] : JointRow.NONE,
                w[0] == JointEnds.RIGID ? w[1] : JointRow.NONE,
                w[4] == JointEnds.RIGID ? w[5] : JointRow.NONE,
                pointsOf(w));
        if (w[4] == JointEnds.ANCHOR) {
            world.joints.anchor(joint, w[5], real(w[6]), real(w[7]));
        }
        return joint;
    }

    /** The points of a joint on bodies that are pushed. */
    private float[] pointsOf(int[] w) {
        for (int k = 0; k < points.length; k++) {
            points[k] = w[k < 2 ? 0 : 4] == JointEnds.RIGID ? real(w[k < 2 ? 2 + k : 4 + k]) : 0f;
        }
        return points;
    }

    /** Refuses types of ends in a log that no joint of bodies has, and ids of nothing. */
    private void requireEnds(int[] w) {
        boolean fits = (w[0] == JointEnds.RIGID || w[0] == JointEnds.CIRCLE && w[4] == JointEnds.RIGID)
                && w[4] >= JointEnds.CIRCLE
                && w[4] <= JointEnds.NOTHING;
        if (!fits) {
            throw new IllegalArgumentException("no joint of bodies has ends of the types " + w[0] + " and " + w[4]);
        }
        requireEnd(w[0], w[1]);
        requireEnd(w[4], w[5]);
    }

    private void requireEnd(int type, int id) {
        Call.Named named =
                switch (type) {
                    case JointEnds.CIRCLE -> Call.Named.CIRCLE;
                    case JointEnds.RIGID -> Call.Named.RIGID;
                    case JointEnds.ANCHOR -> Call.Named.BODY;
                    default -> Call.Named.NOTHING;
                };
        world.calls.requireId(named, id);
    }

    /** Adds a joint, for which there is room, and returns its handle. */
    private long apply(Call call, int[] w, JointForm of) {
        return complete(
                of,
                switch (call) {
                    case RIGID_JOINT -> addOfBodies(w, of);
                    case ANCHORED_JOINT -> world.joints.add(of, w[0], w[1], real(w[2]), real(w[3]));
                    default -> world.joints.add(of, w[0], call == Call.JOINT ? w[1] : JointRow.NONE);
                });
    }

    /** Without a circle b, it holds a to no place. */
    private void check(JointForm form, int a, int b) {
        if (b == JointRow.NONE) {
            JointLimits.alone(form, false);
            JointLimits.moves(a, world.handles);
        } else {
            JointLimits.circles(form, a, b, world.handles);
        }
    }

    /** Adds joints between two circles each; the handles are optional. Returns how many. */
    public int addAll(long[] firsts, long[] others, JointForm form, long[] to) {
        return addAll(Call.JOINT, firsts, others, form, to);
    }

    /** Adds joints that hold a circle each to no place; the handles are optional. Returns how many. */
    public int addAll(long[] circlesOf, JointForm form, long[] to) {
        return addAll(Call.JOINT_ALONE, circlesOf, null, form, to);
    }

    private int addAll(Call call, long[] firsts, long[] others, JointForm form, long[] to) {
        world.guard.enter();
        try (world.guard) {
            world.pending.settleJoints();
            int n = Limits.notNull("circles", firsts).length;
            if (call == Call.JOINT) {
                checkOthers(others, n);
            }
            BulkChanges.checkHandles(to, n, "joints");
            JointLimits.room(n, table.ids.size());
            ensureFound(n);
            for (int k = 0; k < n; k++) {
                find(k, firsts[k], others, form);
            }
            begin(form, n);
            world.log.joints(form);
            for (int k = 0; k < n; k++) {
                words[0] = found[k];
                words[1] = foundOthers[k];
                world.log.write(call, words);
            }
            world.guard.changing = true;
            addFound(n, form, to);
            world.guard.changing = false;
            return n;
        }
    }

    private void addFound(int n, JointForm form, long[] to) {
        for (int k = 0; k < n; k++) {
            long joint = complete(form, world.joints.add(form, found[k], foundOthers[k]));
            if (to != null) {
                to[k] = joint;
            }
        }
    }

    private static void checkOthers(long[] others, int n) {
        if (Limits.notNull("others", others).length != n) {
            throw new IllegalArgumentException(
                    "others has " + others.length + " elements, but must have one for each of " + n + " circles");
        }
    }

    private void ensureFound(int n) {
        if (foundOthers.length < n) {
            found = new int[n];
            foundOthers = new int[n];
        }
    }

    /** Finds the circles of joint k; others is null if the joints hold circles to no place. */
    private void find(int k, long circle, long[] others, JointForm form) {
        try {
            String single = ", but this call takes circles alone: add joints of bodies one by one";
            found[k] = circle(circle, single);
            foundOthers[k] = others == null ? JointRow.NONE : circle(others[k], single);
            check(form, found[k], foundOthers[k]);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("joint " + k + ": " + e.getMessage(), e);
        }
    }

    /** Makes room for joints, which have been checked, and looks at what they take from circles. */
    private void begin(JointForm form, int more) {
        JointLimits.room(more, table.ids.size());
        table.ensure(more, world.handles.end());
        if (form.springs()) {
            table.ensureSprings(1); // all have the same
        }
        expectToWake(more);
        if (form.looks()) {
            circles = world.last.circles();
            angles = world.last.angles();
        }
        world.copies.forgetSaved();
    }

    /** A joint has come, which looks at what it holds and wakes it; returns its handle. */
    private long complete(JointForm form, int joint) {
        if (form.looks()) {
            world.joints.complete(joint, circles, angles);
        }
        wake(joint);
        return table.ids.handle(joint);
    }

    // ---- joints go

    /** Removes joints, all or none. */
    public void removeAll(long[] them) {
        world.guard.enter();
        try (world.guard) {
            world.pending.settleJoints();
            int n = Limits.notNull("joints", them).length;
            ensureFound(n);
            leaving.begin(table.ids.end());
            for (int k = 0; k < n; k++) {
                findLeaving(k, them[k]);
            }
            expectToWake(n);
            world.copies.forgetSaved();
            for (int k = 0; k < n; k++) {
                words[0] = found[k];
                world.log.write(Call.REMOVE_JOINT, words);
            }
            world.guard.changing = true;
            for (int k = 0; k < n; k++) {
                wake(found[k]);
                table.remove(found[k]);
            }
            world.guard.changing = false;
        }
    }

    private void findLeaving(int k, long handle) {
        int joint = table.ids.find(handle);
        if (joint < 0) {
            throw new IllegalArgumentException("handle " + k + ": " + WorldParts.goneJoint(handle));
        }
        if (!leaving.add(joint)) {
            throw new IllegalArgumentException(
                    "handle " + k + ": the joint with the handle " + handle + " occurs twice");
        }
        found[k] = joint;
    }

    // ---- calls by their words

    @Override
    public long make(Call call, int[] w) {
        world.pending.settleJoints();
        switch (call) {
            case JOINT_FORM -> {
                form = JointForm.of(w);
                if (form == null) {
                    throw new IllegalArgumentException("no joint has the form " + w[0]);
                }
                world.calls.begin(call, w); // it changes nothing yet
            }
            case JOINT, ANCHORED_JOINT, JOINT_ALONE, RIGID_JOINT -> {
                if (form == null) {
                    throw new IllegalArgumentException("a joint comes without a form");
                }
                if (call == Call.RIGID_JOINT) {
                    requireEnds(w);
                } else if (call != Call.JOINT_ALONE) {
                    world.calls.requireId(call == Call.JOINT ? Call.Named.CIRCLE : Call.Named.BODY, w[1]);
                }
                prepare(call, w, form);
                world.calls.begin(call, w);
                return apply(call, w, form);
            }
            case JOINT_SETTING -> {
                JointSetting setting = JointSetting.of(w[1]);
                world.joints.check(w[0], setting, real(w[2]), real(w[3]));
                if (setting == JointSetting.SPRING) {
                    table.ensureSprings(1);
                }
                expectToWake(1);
                world.calls.begin(call, w);
                if (world.joints.set(w[0], setting, real(w[2]), real(w[3]))) {
                    wake(w[0]);
                }
            }
            case REMOVE_JOINT -> {
                expectToWake(1);
                world.calls.begin(call, w);
                wake(w[0]);
                table.remove(w[0]);
            }
            default -> {
                world.calls.begin(call, w);
                if (world.settings.sleeps()) {
                    world.commands.wakeAll();
                }
                table.clear();
            }
        }
        return 0;
    }

    /** Joints of a log are not to have a form that came before. */
    public void forgetForm() {
        form = null;
    }

    // ---- joints that go by themselves

    /** Sets whether they are told of. */
    public void report(boolean on) {
        world.guard.enter();
        try (world.guard) {
            world.pending.settleJoints(); // what has gone so far is told of as it was to be
            world.joints.departures.report(on);
        }
    }

    /** Whether somebody is told of joints that go by themselves. */
    public boolean reports() {
        world.guard.check();
        return world.joints.departures.reports();
    }

    /** Gives those that went since the last call. */
    public void take(GoneJoints to) {
        world.guard.enter();
        try (world.guard) {
            world.pending.settleJoints();
            world.joints.departures.gone().moveTo(to);
        }
    }
}
