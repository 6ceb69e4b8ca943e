package io.github.circles2d.world.joints;

import io.github.circles2d.world.bodies.RigidTable;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.JointRow;
import java.util.Arrays;

/** How joints go by themselves: with what they hold, or since they break. It tells who asks for that. */
public final class JointDepartures {
    /** In place of a body: all bodies. */
    public static final int ALL = -1;

    private final JointTable table;
    private final HandleTable handles;
    private final RigidTable rigids;
    private final GoneJoints gone = new GoneJoints();
    private boolean reports;

    /** The joints of a circle. */
    private int[] leaving = new int[0];

    JointDepartures(JointTable table, HandleTable handles, RigidTable rigids) {
        this.table = table;
        this.handles = handles;
        this.rigids = rigids;
    }

    /** Whether somebody is told of joints that go. */
    public boolean reports() {
        return reports;
    }

    /** Forgets what nobody is to be told of any more. */
    public void report(boolean on) {
        reports = on;
        if (!on) {
            gone.clear();
        }
    }

    /** Those that have gone and that nobody has taken yet. */
    public GoneJoints gone() {
        return gone;
    }

    /** Makes room for so many. If there is none, nothing has changed. */
    public void ensure(int more) {
        if (reports) {
            gone.ensure(more);
            if (leaving.length < more) {
                leaving = new int[more + (more >> 1)];
            }
        }
    }

    /** How many go with a circle. */
    public int countOf(int circle) {
        int count = 0;
        for (int place = table.firstOfCircle(circle); place >= 0; place = table.nextOfCircle(place)) {
            count++;
        }
        return count;
    }

    /** A circle goes, which has its handle yet; there is room. */
    public void removeOfCircle(int circle) {
        if (!reports) {
            for (int place = table.firstOfCircle(circle); place >= 0; place = table.firstOfCircle(circle)) {
                table.remove(JointTable.jointAt(place));
            }
            return;
        }
        int count = 0;
        for (int place = table.firstOfCircle(circle); place >= 0; place = table.nextOfCircle(place)) {
            leaving[count++] = JointTable.jointAt(place);
        }
        Arrays.sort(leaving, 0, count);
        for (int k = 0; k < count; k++) {
            remove(leaving[k], GoneJoints.CIRCLE_REMOVED, 0f, 0f);
        }
    }

    /** All circles go, in the order of their ids. */
    public void removeOfCircles() {
        for (int circle = 0; table.ids.size() > 0 && circle < handles.end(); circle++) {
            removeOfCircle(circle);
        }
    }

    /** A body of terrain goes, or {@link #ALL}; there is room. */
    public void removeOfBody(int body) {
        for (int joint = 0; table.places.count() > 0 && joint < table.ids.end(); joint++) {
            if (table.ids.lives(joint)
                    && table.places.isOnBody(joint)
                    && (body == ALL || table.places.body(joint) == body)) {
                remove(joint, GoneJoints.BODY_REMOVED, 0f, 0f);
            }
        }
    }

    /** A body that is pushed goes, or {@link #ALL}, which have their handles yet; there is room. */
    public void removeOfRigid(int body) {
        for (int joint = 0; table.rigid.count() > 0 && joint < table.ids.end(); joint++) {
            if (table.ids.lives(joint) && (body == ALL ? table.rigid.has(joint) : table.rigid.has(joint, body))) {
                remove(joint, GoneJoints.BODY_REMOVED, 0f, 0f);
            }
        }
    }

    /** The handle of the circle or the body at an end of a joint; 0 if there is none. */
    public long handle(int joint, int end) {
        int body = table.rigid.body(joint, end);
        if (body != JointRow.NONE) {
            return rigids.ids.handle(body);
        }
        int circle = end == RigidEnds.A ? table.a(joint) : table.b(joint);
        return circle == JointRow.NONE ? 0 : handles.handle(circle);
    }

    /** A joint has broken. */
    public void breakJoint(int joint, float force, float torque) {
        remove(joint, GoneJoints.BROKEN, force, torque);
    }

    private void remove(int joint, int reason, float force, float torque) {
        if (reports) {
            gone.add(
                    table.ids.handle(joint),
                    handle(joint, RigidEnds.A),
                    handle(joint, RigidEnds.B),
                    reason,
                    force,
                    torque);
        }
        table.remove(joint);
    }

    long bytes() {
        return 4L * leaving.length + gone.bytes();
    }
}
