package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.joints.JointLimits;
import io.github.circles2d.world.joints.JointTable;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.WorldParts;
import io.github.circles2d.world.shared.WorldSettings;
import java.util.Arrays;

/**
 * The call that adds a {@link Net}: all of its circles and joints, or nothing. It checks each joint and makes all room before the first circle
 * comes. A log has it as calls that add circles, and joints.
 */
public final class Nets {
    private final WorldParts world;
    private final JointTable table;
    private final NewCircles newCircles;

    public Nets(WorldParts world, NewCircles newCircles) {
        this.world = world;
        this.newCircles = newCircles;
        table = world.joints.table;
    }

    /** Adds a net, and gives the handles of its circles and joints. */
    public void add(Net net, long[] circlesTo, long[] jointsTo) {
        world.guard.enter();
        try (world.guard) {
            world.pending.settleJoints();
            JointLimits.room(net.joints(), table.ids.size());
            for (int k = 0; k < net.joints(); k++) {
                check(net, k);
            }
            boolean looks = makeRoom(net);
            int n = net.size();
            // a read hands the changes that wait to the pipeline, and circles are prepared behind those that still wait
            Looked before = looks ? new Looked(world.handles, world.last.circles(), world.last.angles(), n) : null;
            int[] own = newCircles.prepareAll(n, net.circles, null, kinds(net, n));
            world.copies.forget();
            world.guard.changing = true;
            newCircles.admitAll(n, own, circlesTo);
            if (looks) {
                before.enter(circlesTo, net.circles, world.settings);
            }
            addJoints(net, circlesTo, jointsTo, before);
            world.guard.changing = false;
        }
    }

    // ---- before anything changes

    private void check(Net net, int k) {
        try {
            JointForm form = net.form(k);
            boolean isStatic = isStatic(net, net.firstIsThere(k), net.firstEnd(k));
            if (net.second(k) == Net.PLACE) {
                world.body(net.secondEnd(k));
                JointLimits.anchor(form, false, net.placeX(k), net.placeY(k));
                if (isStatic) {
                    throw new IllegalArgumentException("its circle is static, but must move");
                }
            } else {
                JointLimits.circles(form);
                if (isStatic & isStatic(net, net.second(k) == Net.CIRCLE, net.secondEnd(k))) {
                    throw new IllegalArgumentException("its circles are both static, but one of them must move");
                }
            }
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("joint " + k + ": " + e.getMessage(), e);
        }
    }

    private boolean isStatic(Net net, boolean isThere, long end) {
        return isThere
                ? world.handles.isStatic(world.circle(end))
                : net.circles[CircleRow.STRIDE * (int) end + CircleRow.MASS] == Float.POSITIVE_INFINITY;
    }

    private static int[] kinds(Net net, int n) {
        if (net.kind == 0) {
            return null;
        }
        int[] kinds = new int[n];
        Arrays.fill(kinds, net.kind);
        return kinds;
    }

    /** Makes room for joints; returns whether one of them looks at circles. */
    private boolean makeRoom(Net net) {
        table.ensure(net.joints(), world.handles.end() + net.size());
        boolean looks = false;
        int springs = 0;
        for (int k = 0; k < net.joints(); k++) {
            looks |= net.form(k).looks();
            springs += isOther(net, k) && net.form(k).springs() ? 1 : 0;
        }
        if (springs > 0) {
            table.ensureSprings(springs);
        }
        return looks;
    }

    /** Whether joint k has another form than the one before. */
    private static boolean isOther(Net net, int k) {
        return k == 0 || net.form(k) != net.form(k - 1);
    }

    // ---- the joints come

    private void addJoints(Net net, long[] circles, long[] to, Looked before) {
        for (int k = 0; k < net.joints(); k++) {
            JointForm form = net.form(k);
            if (isOther(net, k)) {
                world.log.joints(form);
            }
            int a = id(net.firstIsThere(k), net.firstEnd(k), circles);
            int joint = net.second(k) == Net.PLACE
                    ? anchor(net, k, form, a)
                    : join(form, a, id(net.second(k) == Net.CIRCLE, net.secondEnd(k), circles));
            if (form.looks()) {
                world.joints.complete(joint, before.circles, before.angles);
            }
            to[k] = table.ids.handle(joint);
        }
    }

    private static int id(boolean isThere, long end, long[] circles) {
        return Handle.id(isThere ? end : circles[(int) end]);
    }

    private int join(JointForm form, int a, int b) {
        world.log.write(Call.JOINT, a, b, 0, 0);
        return world.joints.add(form, a, b);
    }

    private int anchor(Net net, int k, JointForm form, int a) {
        int body = world.body(net.secondEnd(k));
        float x = net.placeX(k);
        float y = net.placeY(k);
        world.log.write(Call.ANCHORED_JOINT, a, body, Float.floatToRawIntBits(x), Float.floatToRawIntBits(y));
        return world.joints.add(form, a, body, x, y);
    }

    /** Circles as of now, with those that come, as a bulk read would give them. A joint can look at them before the pipeline knows them. */
    private static final class Looked {
        final float[] circles;

        /** Null if no circle has turned. */
        final int[] angles;

        private final HandleTable handles;
        private final float[] circlesBefore;
        private final int[] anglesBefore;
        private final int more;

        Looked(HandleTable handles, float[] circlesBefore, int[] anglesBefore, int more) {
            this.handles = handles;
            this.circlesBefore = circlesBefore;
            this.anglesBefore = anglesBefore;
            this.more = more;
            circles = new float[CircleRow.STRIDE * (handles.size() + more)];
            angles = anglesBefore == null ? null : new int[handles.size() + more];
        }

        /** The new circles have come. Their ids ascend. */
        void enter(long[] added, float[] values, WorldSettings settings) {
            int next = 0;
            int place = 0;
            for (int id = 0; id < handles.end(); id++) {
                if (next < more && Handle.id(added[next]) == id) {
                    float x = values[CircleRow.STRIDE * next + CircleRow.X];
                    float y = values[CircleRow.STRIDE * next + CircleRow.Y];
                    circles[CircleRow.STRIDE * place + CircleRow.X] =
                            settings.bounds().placeX(x);
                    circles[CircleRow.STRIDE * place + CircleRow.Y] =
                            settings.bounds().placeY(y);
                    next++;
                    place++;
                } else if (handles.lives(id)) {
                    int then = CircleRow.STRIDE * (place - next);
                    System.arraycopy(circlesBefore, then, circles, CircleRow.STRIDE * place, CircleRow.STRIDE);
                    if (angles != null) {
                        angles[place] = anglesBefore[place - next];
                    }
                    place++;
                }
            }
        }
    }
}
