package io.github.circles2d.world.reads;

import io.github.circles2d.world.joints.JointEnds;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.joints.JointTable;
import io.github.circles2d.world.joints.RigidEnds;
import io.github.circles2d.world.joints.SavedJointStates;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.WorldParts;
import java.util.Arrays;

/** The reads of joints. */
public final class JointReads {
    // what a joint does to its first circle
    private static final int FORCE_X = 0;
    private static final int FORCE_Y = 1;
    private static final int FORCE = 2;
    private static final int TORQUE = 3;

    /** Elements of the ends of a joint. */
    private static final int ENDS = 4;

    private final WorldParts world;
    private final JointTable table;

    /** The joints of a circle. */
    private int[] found = new int[0];

    public JointReads(WorldParts world) {
        this.world = world;
        table = world.joints.table;
    }

    /** The handle of the circle or body that is the first end of a joint, or the other one; 0 if there is none. */
    public long end(long handle, boolean other) {
        world.guard.enter();
        try (world.guard) {
            return world.joints.departures.handle(find(handle), other ? RigidEnds.B : RigidEnds.A);
        }
    }

    private int find(long handle) {
        world.pending.settleJoints();
        return world.joint(handle);
    }

    /** What a joint does. */
    public JointForm form(long handle) {
        world.guard.enter();
        try (world.guard) {
            return table.formOf(find(handle));
        }
    }

    // ---- where joints are

    public float anchorX(long handle) {
        return anchor(handle, false);
    }

    public float anchorY(long handle) {
        return anchor(handle, true);
    }

    private float anchor(long handle, boolean y) {
        world.guard.enter();
        try (world.guard) {
            int joint = find(handle);
            world.joints.requireAnchor(joint);
            return y ? world.joints.anchors.y(joint, null) : world.joints.anchors.x(joint, null);
        }
    }

    /** How far its ends are apart now. */
    public float length(long handle) {
        world.guard.enter();
        try (world.guard) {
            int joint = find(handle);
            JointEnds ends = world.joints.ends.look(world.last.circles());
            ends.of(joint);
            return ends.length();
        }
    }

    /** x and y of both ends of all joints, in the order of ids, now; returns how many there are. */
    public int readEnds(float[] to) {
        return readEnds(null, to, null);
    }

    /** The same where circles and bodies of terrain are drawn; handles may be null. */
    public int readEnds(JointEnds.Drawn drawn, float[] to, long[] handles) {
        world.guard.enter();
        try (world.guard) {
            world.pending.settleJoints();
            Readings.requireRoom("ends", to, (long) ENDS * table.ids.size());
            if (handles != null) {
                Readings.requireRoom("handles", handles, table.ids.size());
            }
            return world.joints.isThere() ? copyEnds(drawn, to, handles) : 0;
        }
    }

    private int copyEnds(JointEnds.Drawn drawn, float[] to, long[] handles) {
        JointEnds ends = world.joints.ends;
        if (drawn == null) {
            ends.look(world.last.circles());
        } else {
            ends.look(drawn);
        }
        int n = 0;
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (table.ids.lives(joint)) {
                if (ends.hasNewCircle(joint)) {
                    ends.takeNew(world.last.circles());
                }
                ends.of(joint);
                to[ENDS * n] = ends.x();
                to[ENDS * n + 1] = ends.y();
                to[ENDS * n + 2] = ends.x() + ends.dx();
                to[ENDS * n + 3] = ends.y() + ends.dy();
                if (handles != null) {
                    handles[n] = table.ids.handle(joint);
                }
                n++;
            }
        }
        return n;
    }

    /** The joint whose line is nearest to a point, of several the one of the lowest id; 0 if all are farther away than a distance. */
    public long pick(float x, float y, float most) {
        world.guard.enter();
        try (world.guard) {
            world.pending.settleJoints();
            Limits.within("x", x, -Limits.COORDINATE, Limits.COORDINATE);
            Limits.within("y", y, -Limits.COORDINATE, Limits.COORDINATE);
            Limits.within("the greatest distance", most, 0f, Float.POSITIVE_INFINITY);
            int nearest = -1;
            double least = most;
            JointEnds ends = world.joints.isThere() ? world.joints.ends.look(world.last.circles()) : null;
            for (int joint = 0; ends != null && joint < table.ids.end(); joint++) {
                if (table.ids.lives(joint)) {
                    ends.of(joint);
                    double distance = ends.distanceTo(x, y);
                    if (distance < least || distance == least && nearest < 0) {
                        nearest = joint;
                        least = distance;
                    }
                }
            }
            return nearest < 0 ? 0 : table.ids.handle(nearest);
        }
    }

    /** The joints of a circle, in the order of ids, of which the array takes the first ones; returns how many there are. */
    public int ofCircle(long circle, long[] into) {
        world.guard.enter();
        try (world.guard) {
            world.pending.settleJoints();
            Limits.notNull("joints", into);
            int id = world.circle(circle);
            int count = world.joints.departures.countOf(id);
            if (found.length < count) {
                found = new int[count + (count >> 1)];
            }
            int k = 0;
            for (int place = table.firstOfCircle(id); place >= 0; place = table.nextOfCircle(place)) {
                found[k++] = JointTable.jointAt(place);
            }
            Arrays.sort(found, 0, count);
            for (k = 0; k < count && k < into.length; k++) {
                into[k] = table.ids.handle(found[k]);
            }
            return count;
        }
    }

    /** The joints of a body that is pushed, likewise. */
    public int ofBody(long body, long[] into) {
        world.guard.enter();
        try (world.guard) {
            world.pending.settleJoints();
            Limits.notNull("joints", into);
            int id = world.rigid(body);
            int count = 0;
            for (int joint = 0; table.rigid.count() > 0 && joint < table.ids.end(); joint++) {
                if (table.ids.lives(joint) && table.rigid.has(joint, id)) {
                    if (count < into.length) {
                        into[count] = table.ids.handle(joint);
                    }
                    count++;
                }
            }
            return count;
        }
    }

    // ---- what they do

    /** The force on the first circle in the last step. */
    public float forceX(long handle) {
        return load(handle, FORCE_X);
    }

    public float forceY(long handle) {
        return load(handle, FORCE_Y);
    }

    /** Along the line of a joint that has one, positive if it pulls; else how great it is. */
    public float force(long handle) {
        return load(handle, FORCE);
    }

    /** On the first circle. */
    public float torque(long handle) {
        return load(handle, TORQUE);
    }

    private float load(long handle, int which) {
        world.guard.enter();
        try (world.guard) {
            int joint = find(handle);
            SavedJointStates states = world.last.joints();
            if (joint >= states.joints || states.serial[joint] != table.serial(joint)) {
                return 0; // it is new
            }
            return load(states, joint, which, world.settings.lastStep());
        }
    }

    private float load(SavedJointStates states, int joint, int which, float dt) {
        return switch (which) {
            case FORCE_X -> states.forceX(joint, dt);
            case FORCE_Y -> states.forceY(joint, dt);
            case TORQUE -> states.torque(joint, dt);
            default -> {
                if (!JointForm.isAxial(table.form(joint)) || isWeldOfBody(joint)) {
                    yield states.force(joint, dt);
                }
                JointEnds ends = world.joints.ends.look(world.last.circles());
                ends.of(joint);
                yield ends.along(states.forceX(joint, dt), states.forceY(joint, dt));
            }
        };
    }

    /** Both ends of a weld of a body are at one place, so it has no line. */
    private boolean isWeldOfBody(int joint) {
        return table.rigid.has(joint) && (table.form(joint) & JointRow.ACROSS) != 0;
    }
}
