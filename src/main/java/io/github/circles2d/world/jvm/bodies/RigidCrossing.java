package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.OutlineShape.LENGTH;
import static io.github.circles2d.world.bodies.OutlineShape.NX;
import static io.github.circles2d.world.bodies.OutlineShape.NY;
import static io.github.circles2d.world.bodies.OutlineShape.RADIUS;
import static io.github.circles2d.world.bodies.OutlineShape.THICKNESS;

/**
 * Finds how two bodies leave each other whose lines cross, like an X: by the corner and the line that are the least way from being apart, as if
 * the line had no ends. The bodies have no contact, or long ones hold each other by their ends.
 */
final class RigidCrossing {
    /** The sine of the least angle of lines that cross: of nearly parallel ones rounding decides. */
    private static final float LEAST_SINE = 0.05f;

    /** The sine of the greatest angle of long bodies that cross, and hold each other by their ends. */
    private static final float GREATEST_SINE = 0.45f;

    private final RigidThings things;

    /** The corner and the line of the last find, by number of all, and whether the line is the first thing's. */
    int corner;

    int line;
    boolean swapped;
    private float least;
    private float greatestSine;

    RigidCrossing(RigidThings things) {
        this.things = things;
    }

    /** Whether lines of a thing cross those of another one, from whose place it is (x, y) away; touch: the two have contacts. */
    boolean find(RigidThing t, RigidThing other, float x, float y, boolean touch) {
        greatestSine = touch ? GREATEST_SINE : 2f;
        corner = -1;
        least = Float.NEGATIVE_INFINITY;
        cornersOnLines(t, other, x, y, false);
        if (corner >= 0) { // else none cross
            cornersOnLines(other, t, -x, -y, true);
        }
        return corner >= 0;
    }

    private void cornersOnLines(RigidThing t, RigidThing other, float x, float y, boolean areSwapped) {
        for (int l = other.firstLine; l < other.endLine; l++) {
            if (!things.isHollow(l) && crosses(t, l, x, y)) {
                take(t, l, x, y, areSwapped);
            }
        }
    }

    /** Whether a line crosses one of a thing. */
    private boolean crosses(RigidThing t, int l, float x, float y) {
        float[] lines = things.turnedLine;
        int to = RigidThings.line(l);
        float nx = lines[to + NX];
        float ny = lines[to + NY];
        float length = lines[to + LENGTH];
        for (int m = t.firstLine; m < t.endLine; m++) {
            if (things.isHollow(m)) {
                continue;
            }
            int at = RigidThings.line(m);
            float mx = lines[at + NX];
            float my = lines[at + NY];
            float sine = Math.abs(nx * my - ny * mx);
            if (sine < LEAST_SINE || sine > greatestSine) {
                continue;
            }
            float rx = x + lines[at] - lines[to];
            float ry = y + lines[at + 1] - lines[to + 1];
            float endX = rx - lines[at + LENGTH] * my;
            float endY = ry + lines[at + LENGTH] * mx;
            boolean ofLine = rx * nx + ry * ny > 0f != endX * nx + endY * ny > 0f;
            float itsX = -rx - length * ny;
            float itsY = -ry + length * nx;
            if (ofLine && -rx * mx - ry * my > 0f != itsX * mx + itsY * my > 0f) {
                return true;
            }
        }
        return false;
    }

    /** Takes the deepest corner of a thing behind a line, if that is less deep than what has been taken. */
    private void take(RigidThing t, int l, float x, float y, boolean areSwapped) {
        float[] lines = things.turnedLine;
        float[] corners = things.turnedCorner;
        int to = RigidThings.line(l);
        float nx = lines[to + NX];
        float ny = lines[to + NY];
        int deepest = -1;
        float apart = Float.POSITIVE_INFINITY;
        for (int c = t.firstCorner; c < t.endCorner; c++) {
            int at = RigidThings.corner(c);
            float rx = x + corners[at] - lines[to];
            float ry = y + corners[at + 1] - lines[to + 1];
            if (things.isBent(c)) {
                rx += things.bentX(c, -nx, -ny);
                ry += things.bentY(c, -nx, -ny);
            }
            float far = (rx * nx + ry * ny) - (corners[at + RADIUS] + lines[to + THICKNESS]);
            if (far < apart) {
                apart = far;
                deepest = c;
            }
        }
        if (apart > least) {
            least = apart;
            corner = deepest;
            line = l;
            swapped = areSwapped;
        }
    }
}
