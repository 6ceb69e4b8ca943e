package io.github.circles2d.world.jvm.bodies;

/**
 * Finds how two bodies leave each other whose lines cross, like an X: by the corner and the line that are the least way from being apart, as if
 * the line had no ends. The bodies have no contact, or long ones hold each other by their ends.
 */
final class RigidCrossing {
    /** The sine of the least angle of lines that cross: of nearly parallel ones rounding decides. */
    private static final float LEAST_SINE = 0.05f;

    /** The sine of the greatest angle of long bodies that cross, and hold each other by their ends. */
    private static final float GREATEST_SINE = 0.45f;

    /** The corner and the line of the last find, and whether the line is the first thing's. */
    RigidCorner corner;

    RigidLine line;
    boolean swapped;
    private float least;
    private float greatestSine;

    /** Whether lines of a thing cross those of another one, from whose place it is (x, y) away; touch: the two have contacts. */
    boolean find(RigidThing t, RigidThing other, float x, float y, boolean touch) {
        greatestSine = touch ? GREATEST_SINE : 2f;
        corner = null;
        least = Float.NEGATIVE_INFINITY;
        cornersOnLines(t, other, x, y, false);
        if (corner != null) { // else none cross
            cornersOnLines(other, t, -x, -y, true);
        }
        return corner != null;
    }

    private void cornersOnLines(RigidThing t, RigidThing other, float x, float y, boolean areSwapped) {
        for (int n = 0; n < other.lineCount; n++) {
            if (!other.lines[n].isHollow() && crosses(t, other.lines[n], x, y)) {
                take(t, other.lines[n], x, y, areSwapped);
            }
        }
    }

    /** Whether a line crosses one of a thing. */
    private boolean crosses(RigidThing t, RigidLine to, float x, float y) {
        for (int n = 0; n < t.lineCount; n++) {
            RigidLine line = t.lines[n];
            float sine = Math.abs(to.nx * line.ny - to.ny * line.nx);
            if (line.isHollow() || sine < LEAST_SINE || sine > greatestSine) {
                continue;
            }
            float rx = x + line.x - to.x;
            float ry = y + line.y - to.y;
            float endX = rx - line.length * line.ny;
            float endY = ry + line.length * line.nx;
            boolean ofLine = rx * to.nx + ry * to.ny > 0f != endX * to.nx + endY * to.ny > 0f;
            float itsX = -rx - to.length * to.ny;
            float itsY = -ry + to.length * to.nx;
            if (ofLine && -rx * line.nx - ry * line.ny > 0f != itsX * line.nx + itsY * line.ny > 0f) {
                return true;
            }
        }
        return false;
    }

    /** Takes the deepest corner of a thing behind a line, if that is less deep than what has been taken. */
    private void take(RigidThing t, RigidLine to, float x, float y, boolean areSwapped) {
        RigidCorner deepest = null;
        float apart = Float.POSITIVE_INFINITY;
        for (int n = 0; n < t.cornerCount; n++) {
            RigidCorner c = t.corners[n];
            float rx = x + c.x - to.x;
            float ry = y + c.y - to.y;
            if (c.isBent()) {
                rx += c.bentX(-to.nx, -to.ny);
                ry += c.bentY(-to.nx, -to.ny);
            }
            float far = (rx * to.nx + ry * to.ny) - (c.radius + to.thickness);
            if (far < apart) {
                apart = far;
                deepest = c;
            }
        }
        if (apart > least) {
            least = apart;
            corner = deepest;
            line = to;
            swapped = areSwapped;
        }
    }
}
