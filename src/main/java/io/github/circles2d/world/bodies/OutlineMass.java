package io.github.circles2d.world.bodies;

/**
 * Area, centroid and second moment of an outline, exact but for rounding: those of the polygon through all ends of lines and arcs, and of
 * the segments between arcs and their chords.
 */
final class OutlineMass {
    final double area;
    final double centroidX;
    final double centroidY;

    /** About the centroid. */
    final double secondMoment;

    private double a;
    private double mx;
    private double my;
    private double about;

    /** Of elements in order, by {@link OutlineBuilder#STRIDE}; they are taken relative to the first one's place. */
    OutlineMass(double[] elements, int count) {
        double ox = elements[OutlineBuilder.X];
        double oy = elements[OutlineBuilder.Y];
        double[] element = new double[OutlineBuilder.STRIDE];
        double startX = 0;
        double startY = 0;
        double x = 0;
        double y = 0;
        for (int e = 0; e < count; e++) {
            System.arraycopy(elements, OutlineBuilder.STRIDE * e, element, 0, OutlineBuilder.STRIDE);
            element[OutlineBuilder.X] -= ox;
            element[OutlineBuilder.Y] -= oy;
            double turn = span(element);
            double fromX = OutlineBuilder.pointX(element, 0);
            double fromY = OutlineBuilder.pointY(element, 0);
            double toX = OutlineBuilder.pointX(element, turn);
            double toY = OutlineBuilder.pointY(element, turn);
            if (e == 0) {
                startX = fromX;
                startY = fromY;
            } else {
                edge(x, y, fromX, fromY);
            }
            edge(fromX, fromY, toX, toY);
            if (element[OutlineBuilder.IS_LINE] == 0 && element[OutlineBuilder.R] > 0) {
                segment(element, turn);
            }
            x = toX;
            y = toY;
        }
        edge(x, y, startX, startY);
        area = a;
        centroidX = ox + mx / a;
        centroidY = oy + my / a;
        secondMoment = about - (mx * mx + my * my) / a;
    }

    private void edge(double x1, double y1, double x2, double y2) {
        double cross = x1 * y2 - y1 * x2;
        a += cross / 2;
        mx += cross * (x1 + x2) / 6;
        my += cross * (y1 + y2) / 6;
        about += cross * (x1 * x1 + x1 * x2 + x2 * x2 + y1 * y1 + y1 * y2 + y2 * y2) / 12;
    }

    /** Between an arc and its chord. */
    private void segment(double[] arc, double turn) {
        double r = arc[OutlineBuilder.R];
        double cos = arc[OutlineBuilder.AX] * arc[OutlineBuilder.BX] + arc[OutlineBuilder.AY] * arc[OutlineBuilder.BY];
        double f = turn / 2;
        double cosF = Math.sqrt(Math.max(0, (1 + cos) / 2));
        double sinF = Math.sqrt(Math.max(0, (1 - cos) / 2));
        // f - sin f cos f, without a difference of like numbers where f is small
        double lens = f < 0.01 ? f * f * f * (2.0 / 3 - f * f * (2.0 / 15)) : f - sinF * cosF;
        double s = r * r * lens;
        if (!(s > 0)) {
            return;
        }
        double d = 2 * r * sinF * sinF * sinF / (3 * lens);
        // the middle of the cone: the chord's normal, which is exact for half a turn too
        double chordX = arc[OutlineBuilder.BX] - arc[OutlineBuilder.AX];
        double chordY = arc[OutlineBuilder.BY] - arc[OutlineBuilder.AY];
        double length = Math.sqrt(chordX * chordX + chordY * chordY);
        double gx = arc[OutlineBuilder.X] + d * (chordY / length);
        double gy = arc[OutlineBuilder.Y] - d * (chordX / length);
        double b = 2 * r * sinF;
        double h = r * cosF;
        double aboutCentre = r * r * r * r * f / 2 - b * h / 2 * (h * h / 2 + b * b / 24);
        a += s;
        mx += s * gx;
        my += s * gy;
        about += aboutCentre - s * d * d + s * (gx * gx + gy * gy);
    }

    /** The opening of an arc's cone, radians, or the length of a line. */
    static double span(double[] element) {
        if (element[OutlineBuilder.IS_LINE] != 0) {
            return element[OutlineBuilder.SPAN];
        }
        double ax = element[OutlineBuilder.AX];
        double ay = element[OutlineBuilder.AY];
        double bx = element[OutlineBuilder.BX];
        double by = element[OutlineBuilder.BY];
        return OutlineShape.angle(ax * bx + ay * by, Math.max(0, ax * by - ay * bx));
    }
}
