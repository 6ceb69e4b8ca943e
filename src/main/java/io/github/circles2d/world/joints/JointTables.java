package io.github.circles2d.world.joints;

import io.github.circles2d.world.bodies.RigidTable;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointRules;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.terrain.TerrainTables;

/** The joints of a world, and what a step is told of them. Changes have been checked, and there is room. */
public final class JointTables {
    public final JointTable table = new JointTable();

    public final JointSaves saves = new JointSaves(table);

    public final JointAnchors anchors;

    private final JointStep step;
    private final HandleTable handles;
    private final RigidTable rigids;
    private final TerrainTables terrain;
    private final JointSchedule schedule = new JointSchedule(table);

    /** Where the ends of joints are, for a caller to look at. */
    public final JointEnds ends;

    /** How joints go by themselves. */
    public final JointDepartures departures;

    /** No joints. The step is told of what there is. */
    public JointTables(JointStep step, HandleTable handles, TerrainTables terrain, RigidTable rigids) {
        this.step = step;
        this.handles = handles;
        this.terrain = terrain;
        this.rigids = rigids;
        anchors = new JointAnchors(table, terrain);
        ends = new JointEnds(this, handles, terrain, rigids);
        departures = new JointDepartures(table, handles, rigids);
    }

    /** Whether there are joints. */
    public boolean isThere() {
        return table.ids.size() > 0;
    }

    // ---- changes

    /** Adds a joint of a circle with another one, or with none; returns its id. */
    public int add(JointForm form, int circle, int other) {
        return table.add(form, circle, other);
    }

    /** Adds a joint of a circle with a place in the world, or on a body. */
    public int add(JointForm form, int circle, int body, float x, float y) {
        int joint = table.add(form, circle, JointRow.NONE);
        anchor(joint, body, x, y);
        return joint;
    }

    /**
     * Adds a joint of which an end is a body that is pushed.
     *
     * @param at the points on the bodies, in their coordinates: x and y of that at A, then of that at B
     */
    public int add(JointForm form, int circleA, int circleB, int bodyA, int bodyB, float[] at) {
        int joint = table.add(form, circleA, circleB, bodyA, bodyB);
        table.rigid.setPoint(joint, RigidEnds.A, at[0], at[1]);
        table.rigid.setPoint(joint, RigidEnds.B, at[2], at[3]);
        return joint;
    }

    /** Gives a new joint an anchor in the world, or on a body of terrain. */
    public void anchor(int joint, int body, float x, float y) {
        if (body != AnchorPlaces.WORLD) {
            table.places.enter(joint, body);
        }
        anchors.set(joint, x, y);
    }

    /**
     * Gives a new joint what it takes from its ends as they are now: its length, and a weld its direction and angles.
     *
     * @param circles as a bulk read gives them
     * @param angles likewise, in units; null if no circle has turned
     */
    public void complete(int joint, float[] circles, int[] angles) {
        ends.look(circles).of(joint);
        if (table.rigid.has(joint) && JointForm.kind(table.form(joint)) == JointForm.WELD) {
            weld(joint, angles);
            return;
        }
        if (Float.isNaN(table.value(joint, JointRow.LENGTH))) {
            table.setValue(joint, JointRow.LENGTH, ends.length());
        }
        if (JointForm.kind(table.form(joint)) == JointForm.WELD) {
            float d = ends.length();
            table.setValue(joint, JointRow.DIRECTION_X, d > 0f ? ends.dx() / d : 1f);
            table.setValue(joint, JointRow.DIRECTION_Y, d > 0f ? ends.dy() / d : 0f);
            if (angles != null) {
                int a = angles[handles.place(table.a(joint))];
                table.setReferences(joint, a, angles[handles.place(table.b(joint))]);
            }
        }
    }

    /**
     * Refuses a weld whose place is too far from a body that is pushed. Ends are those of a new joint.
     *
     * @param at the points on the bodies, as {@link #add(JointForm, int, int, int, int, float[])} gets them
     * @param circles as a bulk read gives them
     */
    public void requireWeld(int typeA, int a, int typeB, int b, float[] at, float[] circles) {
        Bounds bounds = terrain.bounds();
        float bx = x(typeB, b, at[2], at[3], circles);
        float by = y(typeB, b, circles);
        float ax = x(typeA, a, at[0], at[1], circles);
        float ay = y(typeA, a, circles);
        float share = typeA == JointEnds.CIRCLE ? 0f : typeB == JointEnds.CIRCLE ? 1f : 0.5f;
        float x = ax + share * CircleMath.shortWay(bx - ax, bounds.periodX());
        float y = ay + share * CircleMath.shortWay(by - ay, bounds.periodY());
        requireWeld(typeA, a, x, y);
        requireWeld(typeB, b, x, y);
    }

    private void requireWeld(int type, int body, float x, float y) {
        if (type == JointEnds.RIGID) {
            rigids.places.look(body, x, y, terrain.bounds());
            JointLimits.weld(rigids.places.x(), rigids.places.y(), rigids.step.outline[body]);
        }
    }

    private float x(int type, int id, float localX, float localY, float[] circles) {
        if (type == JointEnds.CIRCLE) {
            return circles[CircleRow.of(handles.place(id)) + CircleRow.X];
        }
        rigids.places.of(id, localX, localY, terrain.bounds());
        return rigids.places.x();
    }

    /** Behind {@link #x}. */
    private float y(int type, int id, float[] circles) {
        return type == JointEnds.CIRCLE ? circles[CircleRow.of(handles.place(id)) + CircleRow.Y] : rigids.places.y();
    }

    /** A weld of a body holds both as they lie, at the middle between their points, or at the centre of a circle. */
    private void weld(int joint, int[] angles) {
        float share = table.a(joint) != JointRow.NONE ? 0f : table.b(joint) != JointRow.NONE ? 1f : 0.5f;
        float x = ends.x() + share * ends.dx();
        float y = ends.y() + share * ends.dy();
        for (int end = RigidEnds.A; end <= RigidEnds.B; end++) {
            int body = table.rigid.body(joint, end);
            if (body != JointRow.NONE) {
                rigids.places.look(body, x, y, terrain.bounds());
                table.rigid.setPoint(joint, end, rigids.places.x(), rigids.places.y());
            }
        }
        table.setValue(joint, JointRow.LENGTH, 0f);
        table.setValue(joint, JointRow.DIRECTION_X, 1f);
        table.setValue(joint, JointRow.DIRECTION_Y, 0f);
        table.setReferences(
                joint,
                angle(joint, RigidEnds.A, table.a(joint), angles),
                angle(joint, RigidEnds.B, table.b(joint), angles));
    }

    /** Of an end, in units. */
    private int angle(int joint, int end, int circle, int[] angles) {
        int body = table.rigid.body(joint, end);
        if (body != JointRow.NONE) {
            return rigids.step.angle[body];
        }
        return angles == null ? 0 : angles[handles.place(circle)];
    }

    /** Refuses values that are out of range, and joints that do not have this. */
    public void check(int joint, JointSetting setting, float a, float b) {
        setting.check(table.form(joint), a, b);
        if (setting == JointSetting.ANCHOR) {
            requireAnchor(joint);
        }
    }

    /** Refuses a joint without an anchor. */
    public void requireAnchor(int joint) {
        JointSetting.require(JointRules.takesAnchor(table.form(joint)), table.form(joint), "anchor");
        if (table.b(joint) != JointRow.NONE || table.rigid.body(joint, RigidEnds.B) != JointRow.NONE) {
            throw new IllegalArgumentException("the " + JointForm.name(table.form(joint)) + " with the handle "
                    + table.ids.handle(joint) + " holds two "
                    + (table.rigid.has(joint) ? "things" : "circles") + ", and has no anchor");
        }
    }

    /** Returns whether the joint is another one then. */
    public boolean set(int joint, JointSetting setting, float a, float b) {
        return setting == JointSetting.ANCHOR ? anchors.set(joint, a, b) : table.set(joint, setting, a, b);
    }

    // ---- states

    /** Makes room for {@link #load}. If there is none, nothing has changed. */
    public void makeRoom(SavedJoints from, int circleIds) {
        table.makeRoom(from.ids, circleIds);
    }

    /** Takes over saved joints; circles and terrain are there. There is room. */
    public void load(SavedJoints from, SavedJointStates states) {
        saves.load(from, states);
        departures.gone().clear();
        anchors.changed();
    }

    // ---- steps

    /** Makes room for {@link #begin}. If there is none, nothing has changed. */
    public void makeRoom(int subSteps) {
        if (isThere()) {
            schedule.makeRoom(step, handles.end());
            anchors.makeRoom(step, subSteps);
            table.springs.makeRoom(step);
        }
    }

    /** Tells the next step of the joints. Room has been made. */
    public void begin(StepConstants constants) {
        anchors.begin(step, constants);
        table.springs.fill(step, constants.h);
        if (table.orderChanged) {
            schedule.make(step, handles.end());
            table.orderChanged = false;
        }
        if (table.partnersChanged) {
            schedule.makePartners(step);
            table.partnersChanged = false;
        }
        table.publish(step);
    }

    public long bytes() {
        return isThere() ? table.bytes() + schedule.bytes() + departures.bytes() + stepBytes() : 0;
    }

    private long stepBytes() {
        return 4L
                * (step.order.length
                        + step.starts.length
                        + step.splitIds.length
                        + step.splitEnds.length
                        + step.rigidOrder.length
                        + step.anchors.length
                        + step.springs.length
                        + step.partnerStart.length
                        + step.partners.length);
    }
}
