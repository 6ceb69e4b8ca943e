package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Tuning;
import java.util.Arrays;

/**
 * Keeps contacts from beginning that would stop a body at the joint of what it slides over: what a body meets is no obstacle if it is no higher
 * than the plane on which the body rests already.
 */
final class RigidCover {
    /** The cosine of 1.8 degrees: nearer normals are one plane. */
    private static final float SAME = 0.9995f;

    private static final int PLANE_STRIDE = 4;

    private static final byte ABOVE = 1;
    private static final byte BELOW = 2;

    private final RigidContacts contacts;
    private final RigidThings things;
    private final Team team;

    /** By thing: a contact on whose plane it may rest and its side, as twice a number and the side; -1 if there is none. Likewise the next one, by contact and side. */
    private int[] head = new int[0];

    private int[] next = new int[0];

    /** By contact and side: {@link #ABOVE} or {@link #BELOW}, as that thing is wholly above the plane of the contact or not; 0 if not known yet. Workers find the same. */
    private byte[] lies = new byte[0];

    /** By contact and side: the normal of its plane, towards that thing, and a point on it, against the thing's place. */
    private float[] plane = new float[0];

    /** By worker: whether it has found some contacts without impulse, or marked some. */
    private final boolean[] some;

    private final Team.Share list = this::list;
    private final Team.Share mark = this::mark;

    RigidCover(RigidContacts contacts, RigidThings things, Team team) {
        this.contacts = contacts;
        this.things = things;
        this.team = team;
        some = new boolean[team.most()];
    }

    /** Removes the contacts that do not begin. */
    void apply() {
        if (head.length < things.count) {
            head = new int[2 * things.count];
        }
        if (next.length < 2 * contacts.count) {
            next = new int[4 * contacts.count];
            lies = new byte[4 * contacts.count];
            plane = new float[PLANE_STRIDE * 4 * contacts.count];
        }
        team.share(things.count, 0, list);
        if (haveSome()) {
            team.share(contacts.count, 0, mark);
            if (haveSome()) {
                contacts.removeCovered();
            }
        }
    }

    private boolean haveSome() {
        boolean have = false;
        for (int worker = 0; worker < team.size(); worker++) {
            have |= some[worker];
        }
        return have;
    }

    /** Lists the planes of a worker's things, and notes whether contacts have no impulse. */
    private void list(int worker, int from, int end) {
        Arrays.fill(head, from, end, -1);
        boolean idle = false;
        for (int n = 0; n < contacts.count; n++) {
            RigidContact c = contacts.all[n];
            boolean ofA = c.a.number >= from && c.a.number < end;
            boolean ofB = c.b.number >= from && c.b.number < end;
            if (!ofA && !ofB) {
                continue;
            }
            if (c.impulse > 0f && c.isLine()) {
                if (ofA && mayRest(c.a, c, c.b)) {
                    add(2 * n, c.a, c.nx, c.ny, c.ax, c.ay);
                }
                if (ofB && mayRest(c.b, c, c.a)) {
                    add(2 * n + 1, c.b, -c.nx, -c.ny, c.bx, c.by);
                }
            } else {
                idle |= c.impulse == 0f;
            }
        }
        some[worker] = idle;
    }

    /** Whether a thing may rest on another one at a pressed contact on a line. */
    private static boolean mayRest(RigidThing t, RigidContact c, RigidThing other) {
        return t.shape != null && t.w > 0f && c.gap <= 0.5f * slack(t) && other.type != RigidStep.BODY_CIRCLE;
    }

    /** Adds a plane to those on which a thing may rest. */
    private void add(int side, RigidThing t, float nx, float ny, float x, float y) {
        int at = PLANE_STRIDE * side;
        plane[at] = nx;
        plane[at + 1] = ny;
        plane[at + 2] = x;
        plane[at + 3] = y;
        lies[side] = 0;
        next[side] = head[t.number];
        head[t.number] = side;
    }

    private static float slack(RigidThing t) {
        return Tuning.COVER * t.thin;
    }

    private void mark(int worker, int from, int end) {
        boolean found = false;
        for (int n = from; n < end; n++) {
            RigidContact c = contacts.all[n];
            c.covered = c.impulse == 0f && (isCovered(c, c.a) || isCovered(c, c.b));
            found |= c.covered;
        }
        some[worker] = found;
    }

    /** Whether a thing has a pressed contact that is a plane over which what it meets by c is no higher. */
    private boolean isCovered(RigidContact c, RigidThing t) {
        boolean ownCorner = c.a == t;
        RigidThing.Line line = ownCorner ? c.line : null;
        RigidCorner its = ownCorner ? c.itsCorner : c.corner;
        if (head[t.number] < 0 || line != null && (line.isHollow() || c.b.type == RigidStep.BODY_WALL)) {
            return false;
        }
        float slack = slack(t);
        float nx = ownCorner ? c.nx : -c.nx;
        float ny = ownCorner ? c.ny : -c.ny;
        // the place of the other thing, against that of this one
        float sign = ownCorner ? -1f : 1f;
        float x = sign * c.x();
        float y = sign * c.y();
        for (int side = head[t.number]; side >= 0; side = next[side]) {
            int at = PLANE_STRIDE * side;
            if (nx * plane[at] + ny * plane[at + 1] <= SAME
                    && (line != null ? isLineUnder(at, line, x, y, slack) : isCornerUnder(at, its, x, y, slack))
                    && liesAbove(side, t, slack)) {
                return true;
            }
        }
        return false;
    }

    private boolean liesAbove(int side, RigidThing t, float slack) {
        if (lies[side] == 0) {
            int at = PLANE_STRIDE * side;
            lies[side] = isAbove(t, plane[at], plane[at + 1], plane[at + 2], plane[at + 3], slack) ? ABOVE : BELOW;
        }
        return lies[side] == ABOVE;
    }

    /** Whether a corner of a thing at (atX, atY) is no higher than a plane. */
    private boolean isCornerUnder(int of, RigidCorner its, float atX, float atY, float slack) {
        float nx = plane[of];
        float ny = plane[of + 1];
        float x = atX - plane[of + 2] + its.bentX(nx, ny);
        float y = atY - plane[of + 3] + its.bentY(nx, ny);
        return !isHigher(x + its.x, y + its.y, nx, ny, slack - its.radius);
    }

    private boolean isLineUnder(int of, RigidThing.Line line, float atX, float atY, float slack) {
        float nx = plane[of];
        float ny = plane[of + 1];
        float most = slack - line.thickness;
        float sx = atX - plane[of + 2] + line.x;
        float sy = atY - plane[of + 3] + line.y;
        float ex = sx - line.ny * line.length;
        float ey = sy + line.nx * line.length;
        return !isHigher(sx, sy, nx, ny, most) && !isHigher(ex, ey, nx, ny, most);
    }

    /** Whether a thing is wholly above a plane through a point. */
    private static boolean isAbove(RigidThing t, float nx, float ny, float px, float py, float slack) {
        for (int k = 0; k < t.cornerCount; k++) {
            RigidCorner c = t.corners[k];
            float x = c.x - px + c.bentX(-nx, -ny);
            float y = c.y - py + c.bentY(-nx, -ny);
            if ((x * nx + y * ny) - c.radius < -slack) {
                return false;
            }
        }
        return true;
    }

    private static boolean isHigher(float x, float y, float nx, float ny, float most) {
        return x * nx + y * ny > most;
    }

    long bytes() {
        return 4L * (head.length + next.length + plane.length) + lies.length;
    }
}
