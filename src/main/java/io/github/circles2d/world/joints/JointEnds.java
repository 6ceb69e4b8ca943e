package io.github.circles2d.world.joints;

import io.github.circles2d.world.bodies.RigidPoses;
import io.github.circles2d.world.bodies.RigidTable;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointRules;
import io.github.circles2d.world.terrain.BodyPoses;
import io.github.circles2d.world.terrain.TerrainTables;
import java.nio.FloatBuffer;

/**
 * Where the two ends of a joint are, now or as they are drawn: with their circles and bodies. Of a joint without a place both are at its
 * circle. The second one is the image nearest to the first.
 */
public final class JointEnds {
    // what an end can be; logs have these numbers
    public static final int CIRCLE = 0;

    /** A body that is pushed. */
    public static final int RIGID = 1;

    /** A place of the world, or of a body of terrain. */
    public static final int ANCHOR = 2;

    /** The world, without a place. */
    public static final int NOTHING = 3;

    private final JointTables joints;
    private final HandleTable handles;
    private final TerrainTables terrain;
    private final RigidTable rigids;

    /** Of now, as a bulk read gives them. */
    private float[] circles;

    /** Null if ends are as they are now. */
    private Drawn drawn;

    private float x;
    private float y;
    private float dx;
    private float dy;

    JointEnds(JointTables joints, HandleTable handles, TerrainTables terrain, RigidTable rigids) {
        this.joints = joints;
        this.handles = handles;
        this.terrain = terrain;
        this.rigids = rigids;
    }

    /** Ends are as they are now, with circles as a bulk read gives them. */
    public JointEnds look(float[] now) {
        circles = now;
        drawn = null;
        return this;
    }

    /** Ends are where circles and bodies are drawn. */
    public JointEnds look(Drawn places) {
        drawn = places;
        if (joints.table.places.count() > 0) {
            drawn.between.keepBetween(drawn.before, drawn.after, drawn.alpha, terrain.bodies, terrain.bounds());
        }
        return this;
    }

    /** Whether {@link #takeNew} has to be called before a joint is looked at: a circle that is new is drawn where it is now. */
    public boolean hasNewCircle(int joint) {
        return drawn != null && (isNew(joints.table.a(joint)) || isNew(joints.table.b(joint)));
    }

    private boolean isNew(int circle) {
        return circle != JointRow.NONE
                && (2 * circle >= drawn.positions.limit() || Float.isNaN(drawn.positions.get(2 * circle)));
    }

    /** Takes circles of now, as a bulk read gives them. */
    public void takeNew(float[] now) {
        circles = now;
    }

    /** Looks at a joint. */
    public void of(int joint) {
        JointTable table = joints.table;
        int a = table.a(joint);
        int b = table.b(joint);
        if (a != JointRow.NONE) {
            x = circleX(a);
            y = circleY(a);
        } else {
            place(joint, RigidEnds.A);
            x = rigids.places.x();
            y = rigids.places.y();
        }
        dx = 0f;
        dy = 0f;
        if (table.rigid.body(joint, RigidEnds.B) != JointRow.NONE) {
            place(joint, RigidEnds.B);
            to(rigids.places.x(), rigids.places.y());
        } else if (b != JointRow.NONE) {
            to(circleX(b), circleY(b));
        } else if (JointRules.takesAnchor(table.form(joint))) {
            BodyPoses poses = drawn == null ? null : drawn.between;
            to(joints.anchors.x(joint, poses), joints.anchors.y(joint, poses));
        }
    }

    /** Where a body that is pushed is held. */
    private void place(int joint, int end) {
        RigidEnds held = joints.table.rigid;
        int body = held.body(joint, end);
        if (drawn == null) {
            rigids.places.of(body, held.x(joint, end), held.y(joint, end), terrain.bounds());
        } else {
            rigids.places.of(
                    drawn.rigidsBefore,
                    drawn.rigidsAfter,
                    drawn.alpha,
                    body,
                    held.x(joint, end),
                    held.y(joint, end),
                    terrain.bounds());
        }
    }

    private float circleX(int circle) {
        return drawn == null || isNew(circle)
                ? circles[CircleRow.of(handles.place(circle)) + CircleRow.X]
                : drawn.positions.get(2 * circle);
    }

    private float circleY(int circle) {
        return drawn == null || isNew(circle)
                ? circles[CircleRow.of(handles.place(circle)) + CircleRow.Y]
                : drawn.positions.get(2 * circle + 1);
    }

    private void to(float toX, float toY) {
        dx = CircleMath.shortWay(toX - x, terrain.bounds().periodX());
        dy = CircleMath.shortWay(toY - y, terrain.bounds().periodY());
    }

    /** Of the first end. */
    public float x() {
        return x;
    }

    public float y() {
        return y;
    }

    /** From the first end to the second one. */
    public float dx() {
        return dx;
    }

    public float dy() {
        return dy;
    }

    public float length() {
        return (float) Math.sqrt((double) dx * dx + (double) dy * dy);
    }

    /** The component of a vector from the first end to the second one; 0 if both are at one place. There is one zero. */
    public float along(float vx, float vy) {
        float d = length();
        return d > 0f ? (vx * dx + vy * dy) / d + 0f : 0f;
    }

    /** From a point to the line between both. */
    public double distanceTo(float px, float py) {
        double halfX = 0.5 * dx;
        double halfY = 0.5 * dy;
        Bounds bounds = terrain.bounds();
        double wayX = CircleMath.shortWay(bounds.placeX(px) - (float) (x + halfX), bounds.periodX());
        double wayY = CircleMath.shortWay(bounds.placeY(py) - (float) (y + halfY), bounds.periodY());
        double square = halfX * halfX + halfY * halfY;
        double share = square > 0 ? (wayX * halfX + wayY * halfY) / square : 0;
        share = Math.max(-1, Math.min(1, share));
        double offX = wayX - share * halfX;
        double offY = wayY - share * halfY;
        return Math.sqrt(offX * offX + offY * offY);
    }

    /** Where circles and bodies are drawn, which is between two steps. */
    public static final class Drawn {
        final BodyPoses before;
        final BodyPoses after;
        final BodyPoses between;
        final RigidPoses rigidsBefore;
        final RigidPoses rigidsAfter;

        /** x and y by id; NaN, or nothing, of a circle that is new. */
        FloatBuffer positions;

        float alpha;

        /** Takes the poses of bodies of terrain before a step and after it, and memory for those between them; and poses of bodies that are pushed. */
        public Drawn(
                BodyPoses before, BodyPoses after, BodyPoses between, RigidPoses rigidsBefore, RigidPoses rigidsAfter) {
            this.before = before;
            this.after = after;
            this.between = between;
            this.rigidsBefore = rigidsBefore;
            this.rigidsAfter = rigidsAfter;
        }

        /** Takes x and y of circles by id, and how far bodies are on their way, 0 to 1. */
        public Drawn at(FloatBuffer xy, float part) {
            positions = xy;
            alpha = part;
            return this;
        }
    }
}
