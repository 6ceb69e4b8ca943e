package io.github.circles2d.world.bodies;

import java.util.List;

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

    /** Of elements in order; they are taken relative to the first one's place. */
    OutlineMass(List<OutlineBuilder.Element> elements) {
        double ox = elements.get(0).x;
        double oy = elements.get(0).y;
        double startX = 0;
        double startY = 0;
        double x = 0;
        double y = 0;
        for (int k = 0; k < elements.size(); k++) {
            OutlineBuilder.Element e = elements.get(k).lower(ox, oy);
            double turn = e.span();
            double fromX = e.pointX(0);
            double fromY = e.pointY(0);
            double toX = e.pointX(turn);
            double toY = e.pointY(turn);
            if (k == 0) {
                startX = fromX;
                startY = fromY;
            } else {
                edge(x, y, fromX, fromY);
            }
            edge(fromX, fromY, toX, toY);
            if (!e.isLine && e.r > 0) {
                segment(e, turn);
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
    private void segment(OutlineBuilder.Element arc, double turn) {
        double r = arc.r;
        double cos = arc.ax * arc.bx + arc.ay * arc.by;
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
        double chordX = arc.bx - arc.ax;
        double chordY = arc.by - arc.ay;
        double length = Math.sqrt(chordX * chordX + chordY * chordY);
        double gx = arc.x + d * (chordY / length);
        double gy = arc.y - d * (chordX / length);
        double b = 2 * r * sinF;
        double h = r * cosF;
        double aboutCentre = r * r * r * r * f / 2 - b * h / 2 * (h * h / 2 + b * b / 24);
        a += s;
        mx += s * gx;
        my += s * gy;
        about += aboutCentre - s * d * d + s * (gx * gx + gy * gy);
    }
}
