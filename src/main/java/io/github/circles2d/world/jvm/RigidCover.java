package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.bodies.OutlineShape.LENGTH;
import static io.github.circles2d.world.bodies.OutlineShape.NX;
import static io.github.circles2d.world.bodies.OutlineShape.NY;
import static io.github.circles2d.world.bodies.OutlineShape.RADIUS;
import static io.github.circles2d.world.bodies.OutlineShape.THICKNESS;

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

    private boolean[] gone = new boolean[0];

    /** By worker: whether it has marked some. */
    private final boolean[] some;

    private final Team.Work mark = this::mark;

    RigidCover(RigidContacts contacts, RigidThings things, Team team) {
        this.contacts = contacts;
        this.things = things;
        this.team = team;
        some = new boolean[team.most()];
    }

    /** Removes the contacts that do not begin. */
    void apply() {
        int n = contacts.count;
        if (head.length < things.count) {
            head = new int[2 * things.count];
        }
        if (gone.length < n) {
            gone = new boolean[2 * n];
            next = new int[4 * n];
            lies = new byte[4 * n];
        }
        Arrays.fill(head, 0, things.count, -1);
        boolean idle = false;
        for (int c = 0; c < n; c++) {
            if (contacts.rows[RigidRow.of(c) + RigidRow.IMPULSE] > 0f && contacts.isLine[c]) {
                add(2 * c, contacts.a[c], contacts.b[c]);
                add(2 * c + 1, contacts.b[c], contacts.a[c]);
            } else {
                idle |= contacts.rows[RigidRow.of(c) + RigidRow.IMPULSE] == 0f;
            }
        }
        if (!idle) {
            return;
        }
        team.together(mark);
        for (int worker = 0; worker < team.size(); worker++) {
            if (some[worker]) {
                contacts.removeMarked(gone);
                return;
            }
        }
    }

    /** Adds a pressed contact on a line to those on which a thing may rest. */
    private void add(int side, int t, int other) {
        if (things.shape[t] != null
                && things.w[t] > 0f
                && contacts.rows[RigidRow.of(side >> 1) + RigidRow.GAP] <= 0.5f * slack(t)
                && things.type[other] != RigidStep.BODY_CIRCLE) {
            lies[side] = 0;
            next[side] = head[t];
            head[t] = side;
        }
    }

    private float slack(int t) {
        return Tuning.COVER * things.thin[t];
    }

    private void mark(int worker) {
        boolean found = false;
        int end = team.part(contacts.count, worker + 1);
        for (int c = team.part(contacts.count, worker); c < end; c++) {
            gone[c] = contacts.rows[RigidRow.of(c) + RigidRow.IMPULSE] == 0f
                    && (isCovered(c, contacts.a[c]) || isCovered(c, contacts.b[c]));
            found |= gone[c];
        }
        some[worker] = found;
    }

    private boolean isCovered(int c, int t) {
        for (int side = head[t]; side >= 0; side = next[side]) {
            if (covers(side >> 1, c, t, slack(t))) {
                return true;
            }
        }
        return false;
    }

    /** Whether a pressed contact p of a thing is a plane over which what it meets by c is no higher. */
    private boolean covers(int p, int c, int t, float slack) {
        float[] rows = contacts.rows;
        int row = RigidRow.of(p);
        boolean isA = contacts.a[p] == t;
        float nx = isA ? rows[row + RigidRow.NX] : -rows[row + RigidRow.NX];
        float ny = isA ? rows[row + RigidRow.NY] : -rows[row + RigidRow.NY];
        float px = rows[row + (isA ? RigidRow.AX : RigidRow.BX)];
        float py = rows[row + (isA ? RigidRow.AY : RigidRow.BY)];
        boolean ownCorner = contacts.a[c] == t;
        float dot = rows[RigidRow.of(c) + RigidRow.NX] * nx + rows[RigidRow.of(c) + RigidRow.NY] * ny;
        if ((ownCorner ? dot : -dot) > SAME) {
            return false;
        }
        int side = 2 * p + (isA ? 0 : 1);
        if (lies[side] == 0) {
            lies[side] = isAbove(t, nx, ny, px, py, slack) ? ABOVE : BELOW;
        }
        if (lies[side] == BELOW) {
            return false;
        }
        // the place of the other thing, against that of this one
        int other = ownCorner ? contacts.b[c] : contacts.a[c];
        float sign = ownCorner ? -1f : 1f;
        float x = sign * (contacts.ox[c] + (things.dx[contacts.a[c]] - things.dx[contacts.b[c]])) - px;
        float y = sign * (contacts.oy[c] + (things.dy[contacts.a[c]] - things.dy[contacts.b[c]])) - py;
        if (!ownCorner || !contacts.isLine[c]) {
            int its = ownCorner ? contacts.feature[c] : contacts.corner[c];
            int at = RigidThings.corner(its);
            if (things.isBent(its)) {
                x += things.bentX(its, nx, ny);
                y += things.bentY(its, nx, ny);
            }
            return !isHigher(
                    x + things.turnedCorner[at],
                    y + things.turnedCorner[at + 1],
                    nx,
                    ny,
                    slack - things.turnedCorner[at + RADIUS]);
        }
        if (things.isHollow(contacts.feature[c]) || things.type[other] == RigidStep.BODY_WALL) {
            return false;
        }
        int line = RigidThings.line(contacts.feature[c]);
        float length = things.turnedLine[line + LENGTH];
        float most = slack - things.turnedLine[line + THICKNESS];
        float sx = x + things.turnedLine[line];
        float sy = y + things.turnedLine[line + 1];
        float ex = sx - things.turnedLine[line + NY] * length;
        float ey = sy + things.turnedLine[line + NX] * length;
        return !isHigher(sx, sy, nx, ny, most) && !isHigher(ex, ey, nx, ny, most);
    }

    /** Whether a thing is wholly above a plane through a point. */
    private boolean isAbove(int t, float nx, float ny, float px, float py, float slack) {
        for (int k = things.firstCorner[t]; k < things.firstCorner[t] + things.corners[t]; k++) {
            int at = RigidThings.corner(k);
            float x = things.turnedCorner[at] - px;
            float y = things.turnedCorner[at + 1] - py;
            if (things.isBent(k)) {
                x += things.bentX(k, -nx, -ny);
                y += things.bentY(k, -nx, -ny);
            }
            if ((x * nx + y * ny) - things.turnedCorner[at + RADIUS] < -slack) {
                return false;
            }
        }
        return true;
    }

    private static boolean isHigher(float x, float y, float nx, float ny, float most) {
        return x * nx + y * ny > most;
    }

    long bytes() {
        return 4L * (head.length + next.length) + gone.length + lies.length;
    }
}
