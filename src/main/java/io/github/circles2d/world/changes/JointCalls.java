package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.joints.GoneJoints;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.joints.JointLimits;
import io.github.circles2d.world.joints.JointSetting;
import io.github.circles2d.world.joints.JointTable;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.LoggedCall;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.terrain.TerrainTables;

/** The calls that change joints. A change acts from the next step on. */
public final class JointCalls {
    private final Guard guard;
    private final HandleTable handles;
    private final TerrainTables terrain;
    private final JointTables joints;
    private final JointTable table;
    private final CallLog log;
    private final PendingWork pending;
    private final Copies copies;

    /** What a call names. */
    private int[] found = new int[0];

    private int[] foundOthers = new int[0];
    private final IdSet leaving = new IdSet();

    // circles as of now, if new joints look at them
    private float[] circles;
    private int[] angles;

    public JointCalls(
            Guard guard,
            HandleTable handles,
            TerrainTables terrain,
            JointTables joints,
            CallLog log,
            PendingWork pending,
            Copies copies) {
        this.guard = guard;
        this.handles = handles;
        this.terrain = terrain;
        this.joints = joints;
        this.log = log;
        this.pending = pending;
        this.copies = copies;
        table = joints.table;
    }

    /** One more than the greatest id that a joint has had. */
    public int idLimit() {
        guard.check();
        return table.ids.end();
    }

    /** The handle of the joint that has an id; 0 if there is none. */
    public long handle(int id) {
        guard.enter();
        try {
            pending.settleJoints();
            return table.ids.handleOrNone(id);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    // ---- joints come
    // -------------------------------------------------------------------------------------------------

    /** Adds a joint between two circles, and returns its handle. */
    public long add(long circle, long other, JointForm form) {
        return add(LoggedCall.JOINT, circle, other, form);
    }

    /** Adds a joint that holds a circle to no place, and returns its handle. */
    public long add(long circle, JointForm form) {
        return add(LoggedCall.JOINT_ALONE, circle, 0, form);
    }

    private long add(LoggedCall call, long circle, long other, JointForm form) {
        guard.enter();
        try {
            pending.settleJoints();
            int a = Circles.find(handles, circle);
            int b = call == LoggedCall.JOINT ? Circles.find(handles, other) : JointRow.NONE;
            check(form, a, b);
            begin(form, 1);
            log.joints(form);
            log.call(call, a, b);
            guard.changing = true;
            int joint = addOne(form, a, b);
            guard.changing = false;
            return table.ids.handle(joint);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Without a circle b, it holds a to no place. */
    private void check(JointForm form, int a, int b) {
        if (b == JointRow.NONE) {
            JointLimits.alone(form, a, handles);
        } else {
            JointLimits.circles(form, a, b, handles);
        }
    }

    /** Adds a joint that holds a circle to a place of a body of terrain, in the body's coordinates, and returns its handle. */
    public long add(long circle, long body, float x, float y, JointForm form) {
        guard.enter();
        try {
            pending.settleJoints();
            int a = Circles.find(handles, circle);
            int of = Bodies.find(terrain, body);
            JointLimits.anchor(form, a, x, y, handles);
            begin(form, 1);
            log.joints(form);
            log.call(LoggedCall.ANCHORED_JOINT, a, of, Float.floatToRawIntBits(x), Float.floatToRawIntBits(y));
            guard.changing = true;
            int joint = joints.add(form, a, of, x, y);
            complete(form, joint);
            guard.changing = false;
            return table.ids.handle(joint);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Adds joints between two circles each; the handles are optional. Returns how many. */
    public int addAll(long[] firsts, long[] others, JointForm form, long[] to) {
        return addAll(LoggedCall.JOINT, firsts, others, form, to);
    }

    /** Adds joints that hold a circle each to no place; the handles are optional. Returns how many. */
    public int addAll(long[] circlesOf, JointForm form, long[] to) {
        return addAll(LoggedCall.JOINT_ALONE, circlesOf, null, form, to);
    }

    private int addAll(LoggedCall call, long[] firsts, long[] others, JointForm form, long[] to) {
        guard.enter();
        try {
            pending.settleJoints();
            int n = Limits.notNull("circles", firsts).length;
            if (call == LoggedCall.JOINT) {
                checkOthers(others, n);
            }
            checkRoom(to, n);
            JointLimits.room(n, table.ids.size());
            ensureFound(n);
            for (int k = 0; k < n; k++) {
                find(k, firsts[k], others, form);
            }
            begin(form, n);
            log.joints(form);
            for (int k = 0; k < n; k++) {
                log.call(call, found[k], foundOthers[k]);
            }
            guard.changing = true;
            addFound(n, form, to);
            guard.changing = false;
            return n;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    private void addFound(int n, JointForm form, long[] to) {
        for (int k = 0; k < n; k++) {
            int joint = addOne(form, found[k], foundOthers[k]);
            if (to != null) {
                to[k] = table.ids.handle(joint);
            }
        }
    }

    private static void checkOthers(long[] others, int n) {
        if (Limits.notNull("others", others).length != n) {
            throw new IllegalArgumentException(
                    "others has " + others.length + " elements, but must have one for each of " + n + " circles");
        }
    }

    private static void checkRoom(long[] to, int n) {
        if (to != null && to.length < n) {
            throw new IllegalArgumentException(
                    "handles has " + to.length + " elements, but there are " + n + " joints");
        }
    }

    private void ensureFound(int n) {
        if (foundOthers.length < n) {
            int[] newFound = new int[n];
            int[] newFoundOthers = new int[n];
            found = newFound;
            foundOthers = newFoundOthers;
        }
    }

    /** Finds the circles of joint k; others is null if the joints hold circles to no place. */
    private void find(int k, long circle, long[] others, JointForm form) {
        try {
            found[k] = Circles.find(handles, circle);
            foundOthers[k] = others == null ? JointRow.NONE : Circles.find(handles, others[k]);
            check(form, found[k], foundOthers[k]);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("joint " + k + ": " + e.getMessage(), e);
        }
    }

    /** Makes room for joints, which have been checked, and looks at what they take from circles. */
    private void begin(JointForm form, int more) {
        JointLimits.room(more, table.ids.size());
        table.ensure(more, handles.end());
        if (form.springs()) {
            table.ensureSpring(); // all have the same
        }
        if (form.looks()) {
            circles = copies.last().circles();
            angles = copies.last().angles();
        }
        copies.forgetSaved();
    }

    private int addOne(JointForm form, int a, int b) {
        int joint = joints.add(form, a, b);
        complete(form, joint);
        return joint;
    }

    private void complete(JointForm form, int joint) {
        if (form.looks()) {
            joints.complete(joint, circles, angles);
        }
    }

    // ---- joints change
    // -----------------------------------------------------------------------------------------------

    /** Sets something of a joint, by one or two values. */
    public void set(JointSetting setting, long handle, float a, float b) {
        guard.enter();
        try {
            pending.settleJoints();
            int joint = find(handle);
            joints.check(joint, setting, a, b);
            if (setting == JointSetting.SPRING) {
                table.ensureSpring();
            }
            copies.forgetSaved();
            log.call(
                    LoggedCall.JOINT_SETTING,
                    joint,
                    setting.number,
                    Float.floatToRawIntBits(a),
                    Float.floatToRawIntBits(b));
            guard.changing = true;
            joints.set(joint, setting, a, b);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    private int find(long handle) {
        return find(table, handle);
    }

    /** The id of the joint that has a handle. */
    public static int find(JointTable table, long handle) {
        int joint = table.ids.find(handle);
        if (joint < 0) {
            throw new IllegalArgumentException(gone(handle));
        }
        return joint;
    }

    private static String gone(long handle) {
        return "no joint has the handle " + handle
                + (Handle.has(handle, Handle.JOINT)
                        ? ": it was removed or has broken, or is none of this world's"
                        : Handle.reason(handle, Handle.JOINT));
    }

    // ---- joints go
    // ---------------------------------------------------------------------------------------------------

    /** Removes a joint. */
    public void remove(long handle) {
        guard.enter();
        try {
            pending.settleJoints();
            int joint = find(handle);
            copies.forgetSaved();
            log.call(LoggedCall.REMOVE_JOINT, joint, 0);
            guard.changing = true;
            table.remove(joint);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Removes joints, all or none. */
    public void removeAll(long[] them) {
        guard.enter();
        try {
            pending.settleJoints();
            int n = Limits.notNull("joints", them).length;
            ensureFound(n);
            leaving.begin(table.ids.end());
            for (int k = 0; k < n; k++) {
                findLeaving(k, them[k]);
            }
            copies.forgetSaved();
            for (int k = 0; k < n; k++) {
                log.call(LoggedCall.REMOVE_JOINT, found[k], 0);
            }
            guard.changing = true;
            for (int k = 0; k < n; k++) {
                table.remove(found[k]);
            }
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    private void findLeaving(int k, long handle) {
        int joint = table.ids.find(handle);
        if (joint < 0) {
            throw new IllegalArgumentException("handle " + k + ": " + gone(handle));
        }
        if (!leaving.add(joint)) {
            throw new IllegalArgumentException(
                    "handle " + k + ": the joint with the handle " + handle + " occurs twice");
        }
        found[k] = joint;
    }

    /** Removes all joints. */
    public void clear() {
        guard.enter();
        try {
            pending.settleJoints();
            copies.forgetSaved();
            log.call(LoggedCall.CLEAR_JOINTS, 0, 0);
            guard.changing = true;
            table.clear();
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    // ---- joints that go by themselves
    // --------------------------------------------------------------------------------

    /** Sets whether they are told of. */
    public void report(boolean on) {
        guard.enter();
        try {
            pending.settleJoints(); // what has gone so far is told of as it was to be
            joints.departures().report(on);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Whether somebody is told of joints that go by themselves. */
    public boolean reports() {
        guard.check();
        return joints.departures().reports();
    }

    /** Gives those that went since the last call. */
    public void take(GoneJoints to) {
        guard.enter();
        try {
            pending.settleJoints();
            joints.departures().gone().moveTo(to);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }
}
