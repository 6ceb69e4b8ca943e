package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.bodies.OutlineShape.LENGTH;
import static io.github.circles2d.world.bodies.OutlineShape.NX;
import static io.github.circles2d.world.bodies.OutlineShape.NY;
import static io.github.circles2d.world.bodies.OutlineShape.RADIUS;
import static io.github.circles2d.world.bodies.OutlineShape.THICKNESS;

import io.github.circles2d.world.bodies.RigidStep;
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

    /** By thing, and by contact and side: the next contact of a thing and its side, as twice a number and the side. */
    private int[] head = new int[0];

    private int[] next = new int[0];
    private boolean[] gone = new boolean[0];

    /** By contact and side: {@link #ABOVE} or {@link #BELOW}, as that thing is wholly above the plane of the contact or not; 0 if not known yet. */
    private byte[] lies = new byte[0];

    RigidCover(RigidContacts contacts, RigidThings things) {
        this.contacts = contacts;
        this.things = things;
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
        Arrays.fill(lies, 0, 2 * n, (byte) 0);
        Arrays.fill(head, 0, things.count, -1);
        for (int c = 0; c < n; c++) {
            gone[c] = false;
            next[2 * c] = head[contacts.a[c]];
            head[contacts.a[c]] = 2 * c;
            next[2 * c + 1] = head[contacts.b[c]];
            head[contacts.b[c]] = 2 * c + 1;
        }
        boolean some = false;
        for (int c = 0; c < n; c++) {
            gone[c] = contacts.impulse[c] == 0f && (isCovered(c, contacts.a[c]) || isCovered(c, contacts.b[c]));
            some |= gone[c];
        }
        if (some) {
            contacts.removeMarked(gone);
        }
    }

    private boolean isCovered(int c, int t) {
        if (things.shape[t] == null || things.w[t] == 0f) {
            return false;
        }
        float slack = Tuning.COVER * things.thin[t];
        for (int at = head[t]; at >= 0; at = next[at]) {
            int p = at >> 1;
            int other = (at & 1) == 0 ? contacts.b[p] : contacts.a[p];
            if (p != c
                    && contacts.isLine[p]
                    && contacts.impulse[p] > 0f
                    && contacts.gap[p] <= 0.5f * slack
                    && things.type[other] != RigidStep.BODY_CIRCLE
                    && covers(p, c, t, slack)) {
                return true;
            }
        }
        return false;
    }

    /** Whether a pressed contact p of a thing is a plane over which what it meets by c is no higher. */
    private boolean covers(int p, int c, int t, float slack) {
        boolean isA = contacts.a[p] == t;
        float nx = isA ? contacts.nx[p] : -contacts.nx[p];
        float ny = isA ? contacts.ny[p] : -contacts.ny[p];
        float px = isA ? contacts.ax[p] : contacts.bx[p];
        float py = isA ? contacts.ay[p] : contacts.by[p];
        boolean ownCorner = contacts.a[c] == t;
        float dot = contacts.nx[c] * nx + contacts.ny[c] * ny;
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
