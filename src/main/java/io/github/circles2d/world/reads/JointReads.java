package io.github.circles2d.world.reads;

import io.github.circles2d.world.changes.JointCalls;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.joints.JointTable;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.PendingWork;

/** The reads of joints. */
public final class JointReads {
    // The functions of the calls. They are linked before memory, or the stack, may end in a call.
    private static final Guard.Numbers<JointReads, Void> FIND = (joints, none, handle, n) -> joints.lookFor(handle);
    private static final Guard.Numbers<JointReads, Void> SIZE = (joints, none, m, n) -> joints.count();
    private static final Guard.Numbers<JointReads, Void> HANDLE = (joints, none, id, n) -> joints.handleOf((int) id);
    private static final Guard.Numbers<JointReads, Void> CIRCLE =
            (joints, none, handle, n) -> joints.circleOf(handle, n != 0);
    private static final Guard.Numbers<JointReads, JointForm[]> FORM =
            (joints, to, handle, n) -> joints.formOf(handle, to);

    private final Guard guard;
    private final HandleTable handles;
    private final JointTable table;
    private final PendingWork pending;

    public JointReads(Guard guard, HandleTable handles, JointTables joints, PendingWork pending) {
        this.guard = guard;
        this.handles = handles;
        this.pending = pending;
        table = joints.table;
    }

    public boolean contains(long handle) {
        return guard.read(this, null, handle, 0, FIND) >= 0;
    }

    private int lookFor(long handle) {
        pending.settleJoints();
        return table.ids.find(handle);
    }

    /** The number of joints. */
    public int size() {
        return (int) guard.read(this, null, 0, 0, SIZE);
    }

    private int count() {
        pending.settleJoints();
        return table.ids.size();
    }

    /** One more than the greatest id that a joint has had. */
    public int idLimit() {
        guard.check();
        return table.ids.end();
    }

    /** The handle of the joint that has an id; 0 if there is none. */
    public long handle(int id) {
        return guard.read(this, null, id, 0, HANDLE);
    }

    private long handleOf(int id) {
        pending.settleJoints();
        return table.ids.handleOrNone(id);
    }

    /** The handle of the first circle of a joint, or of the other one; -1 if there is none. */
    public long circle(long handle, boolean other) {
        return guard.read(this, null, handle, other ? 1 : 0, CIRCLE);
    }

    private long circleOf(long handle, boolean other) {
        int joint = find(handle);
        int circle = other ? table.b(joint) : table.a(joint);
        return circle == JointRow.NONE ? -1 : handles.handle(circle);
    }

    private int find(long handle) {
        pending.settleJoints();
        return JointCalls.find(table, handle);
    }

    /** What a joint does. */
    public JointForm form(long handle) {
        JointForm[] to = new JointForm[1];
        guard.read(this, to, handle, 0, FORM);
        return to[0];
    }

    private long formOf(long handle, JointForm[] to) {
        to[0] = table.formOf(find(handle));
        return 0;
    }
}
