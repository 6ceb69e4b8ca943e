package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.world.bodies.OutlineShape;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class OutlineTest {
    private static final float PI = (float) Math.PI;

    @Test
    void boxesMayBeAThousandTimesAsLongAsWideOrRoundAllOver() {
        assertEquals(1000, Outline.box(1000, 1).area(), 0.01);
        assertEquals(1000, Outline.box(1, 1000).area(), 0.01);
        assertEquals(700 * 0.7, Outline.box(0.7f, 700).area(), 0.01);
        assertEquals(2000 * 2 + 2 * (Math.PI / 2 - 2), Outline.capsule(1998, 1).area(), 0.01);
        refused("1.0 wide and 1001.0", () -> Outline.box(1, 1001));
        refused("1.0 wide and 1001.0", () -> Outline.box(1001, 1));
        refused("2.0 wide and 2001.0 long", () -> Outline.capsule(1999, 1));
        for (int k = 0; k < 12; k++) {
            assertEquals(1000, Outline.polygon(turned(1000, 0.3 * k)).area(), 0.2);
            float[] longer = turned(1001, 0.3 * k);
            refused("wide", () -> Outline.polygon(longer));
        }
        Outline disc = Outline.box(2, 2).round(1);
        assertEquals(Math.PI, disc.area(), 1e-6);
        assertEquals(0.5, disc.inertia(1), 1e-6);
        assertEquals(1, disc.reach(), 1e-6);
        Outline capsule = Outline.box(4, 2).round(1);
        assertEquals(Outline.capsule(2, 1).area(), capsule.area(), 1e-6);
        assertEquals(Outline.capsule(2, 1).inertia(1), capsule.inertia(1), 1e-6);
    }

    /** A box so long and 1 wide, turned by an angle. */
    private static float[] turned(double length, double angle) {
        double[] x = {-length / 2, length / 2, length / 2, -length / 2};
        double[] y = {-0.5, -0.5, 0.5, 0.5};
        float[] points = new float[8];
        for (int k = 0; k < 4; k++) {
            points[2 * k] = (float) (Math.cos(angle) * x[k] - Math.sin(angle) * y[k]);
            points[2 * k + 1] = (float) (Math.sin(angle) * x[k] + Math.cos(angle) * y[k]);
        }
        return points;
    }

    @Test
    void aRoundedBoxHasTheAreaAndInertiaOfItsParts() {
        for (float r : new float[] {0.01f, 0.05f, 0.3f, 0.49f}) {
            Outline box = Outline.box(1, 2).round(r);
            // a cross of boxes, and four quarters of a disc
            double a = 0.5;
            double b = 1;
            double area = 4 * a * b - (4 - Math.PI) * r * r;
            assertEquals(area, box.area(), 1e-6);
            double ofBox = 4 * a * b * (a * a + b * b) / 3;
            // what each corner lacks: a square of side r, less a quarter of a disc, about the centre
            double ofSquare = r * r * (r * r / 6 + square(a - r / 2) + square(b - r / 2));
            double quarter = Math.PI * r * r / 4;
            double d = 4 * r / (3 * Math.PI);
            double ofQuarter = Math.PI * Math.pow(r, 4) / 8
                    - quarter * 2 * d * d
                    + quarter * (square(a - r + d) + square(b - r + d));
            assertEquals((ofBox - 4 * (ofSquare - ofQuarter)) / area, box.inertia(1), 1e-6);
            assertEquals(0, box.centroidX(), 1e-7);
            assertEquals(0, box.centroidY(), 1e-7);
        }
    }

    @Test
    void aCapsuleIsABoxBetweenHalfDiscs() {
        float length = 1.2f;
        float r = 0.3f;
        Outline capsule = Outline.capsule(length, r);
        double box = length * 2 * r;
        double half = Math.PI * r * r / 2;
        double d = 4 * r / (3 * Math.PI);
        double inertia = box * (length * length + 4 * r * r) / 12
                + 2 * (Math.PI * Math.pow(r, 4) / 4 - half * d * d + half * square(length / 2 + d));
        assertEquals(box + 2 * half, capsule.area(), 1e-6);
        assertEquals(inertia / (box + 2 * half), capsule.inertia(1), 1e-6);
        assertEquals(length / 2 + r, capsule.reach(), 1e-6);
        assertEquals(4, capsule.pieces());
    }

    @Test
    void arcsMakeDiscsAndHalfDiscs() {
        Outline disc = Outline.of(Chain.from(3, 1).arcTo(1, 1, 2 * PI).close());
        assertEquals(4 * Math.PI, disc.area(), 1e-5);
        assertEquals(2, disc.inertia(1), 1e-6);
        assertEquals(1, disc.centroidX(), 1e-6);
        assertEquals(1, disc.centroidY(), 1e-6);
        assertEquals(2, disc.reach(), 1e-6);
        Outline half = Outline.of(Chain.from(1, 0).arcTo(0, 0, PI).close());
        assertEquals(Math.PI / 2, half.area(), 1e-6);
        assertEquals(4 / (3 * Math.PI), half.centroidY(), 1e-6);
        assertEquals(0.5 - square(4 / (3 * Math.PI)), half.inertia(1), 1e-6);
    }

    @Test
    void concaveOutlinesHaveTheirExactMass() {
        Outline ell = Outline.polygon(0, 0, 2, 0, 2, 0.6f, 0.7f, 0.6f, 0.7f, 2.5f, 0, 2.5f)
                .round(0.1f);
        double[] counted = count(ell, 1200);
        assertEquals(counted[0], ell.area(), 5e-3);
        assertEquals(counted[1], 0, 5e-3);
        assertEquals(counted[2], 0, 5e-3);
        assertEquals(counted[3] / counted[0], ell.inertia(1), 5e-3);
        assertEquals(2 * 0.6 + 0.7 * 1.9 - 5 * (1 - Math.PI / 4) * 0.01, ell.area(), 1e-6);
    }

    @Test
    void aPolygonMayBeDrawnInEitherDirectionAndAnywhere() {
        Outline near = Outline.polygon(0, 0, 2, 0, 0.5f, 1.5f);
        Outline far = Outline.polygon(100.5f, 101.5f, 102, 100, 100, 100);
        assertEquals(near.area(), far.area(), 1e-5);
        assertEquals(near.inertia(3), far.inertia(3), 1e-5);
        assertEquals(near.centroidX() + 100, far.centroidX(), 1e-5);
        // that of a triangle whose corners are rounded: a strip around an inner one
        double p = 2 + Math.hypot(1.5, 1.5) + Math.hypot(0.5, 1.5);
        float r = near.rounding();
        double shrunk = 1.5 - r * p + r * r * p * p / (4 * 1.5);
        double inner = p * (1 - r * p / (2 * 1.5));
        assertEquals(shrunk + inner * r + Math.PI * r * r, near.area(), 1e-6);
    }

    @Test
    void pointsLieOnTheOutline() {
        Outline box = Outline.box(2, 1).round(0.2f);
        float[] points = box.points(1e-3f);
        assertTrue(points.length > 2 * 12, () -> Arrays.toString(points));
        assertEquals(box.area(), shoelace(points), 3e-3);
        assertEquals(8, Outline.box(2, 1).round(0.02f).points(1).length / 2);
        assertEquals(
                Math.PI,
                shoelace(
                        Outline.of(Chain.from(1, 0).arcTo(0, 0, 2 * PI).close()).points(1e-4f)),
                1e-3);
    }

    @Test
    void wordsMakeTheSameOutline() {
        Outline[] all = {
            Outline.box(1, 2),
            Outline.capsule(1, 0.25f),
            tooth(),
            Outline.of(Chain.from(2, 0).arcTo(0, 0, 2 * PI).close()),
            Outline.polygon(0, 0, 0, 1, 3, 0)
        };
        for (Outline each : all) {
            OutlineShape again = OutlineShape.of(each.shape().words());
            assertEquals(each.shape(), again);
            assertEquals(each.shape().hashCode(), again.hashCode());
            assertArrayEquals(each.shape().corners(), again.corners());
            assertArrayEquals(each.shape().lines(), again.lines());
        }
        refused("words", () -> OutlineShape.of(new int[3]));
        refused("words", () -> OutlineShape.of(new int[] {Float.floatToRawIntBits(Float.NaN), 0, 0, 0}));
    }

    @Test
    void aRoundingIsATwentiethOfTheWidthUnlessALineIsTooShort() {
        assertEquals(0.05f, Outline.box(3, 1).rounding(), 1e-6);
        assertEquals(0.2f, Outline.box(3, 1).round(0.2f).rounding());
        assertEquals(0.2f, Outline.box(3, 1).round(0.3f).round(0.2f).rounding());
        Outline step = tooth();
        assertTrue(step.rounding() > 0 && step.rounding() < 0.05f, step::toString);
    }

    /** The rounding of an arc that ends at the origin is that of its radius, not that of the coordinates there. */
    @Test
    void aChainThatComesBackToTheOriginIsClosedByNothing() {
        for (float x : new float[] {0, 10}) {
            Chain dome = Chain.from(x, 0).lineTo(x + 4, 0).arcTo(x + 2, 0, PI).close();
            assertEquals(2, dome.pieces());
            assertEquals(2 * PI, Outline.of(dome).area(), 1e-4);
            assertEquals(2, dome.reversed().pieces());
            assertEquals(1, Chain.from(x, 0).arcTo(x + 2, 0, 2 * PI).close().pieces());
        }
        assertEquals(
                3, Chain.from(0, 0).lineTo(4, 0).lineTo(0.0001f, 0.1f).close().pieces());
        assertEquals(2, Chain.from(0, 0).arcTo(2, 0, 1e-5f).close().pieces(), "a short arc");
        Chain gap = Chain.from(0, 0).lineTo(4, 0).arcTo(2, 0, PI - 1e-5f).close();
        assertEquals(3, gap.pieces(), "a gap that is no rounding");
    }

    @Test
    void badOutlinesAreRefusedWithTheirPlace() {
        refused("corner 1 of the polygon is NaN", () -> Outline.polygon(0, 0, Float.NaN, 0, 1, 1));
        refused("corner 2 of the polygon is 1.0, 0.0, which", () -> Outline.polygon(0, 0, 1, 0, 1, 0, 1, 1));
        refused("pieces 1 and 3", () -> Outline.polygon(0, 0, 1, 0, 0, 1, 1, 1));
        refused(
                "pieces 0 and 2 of the outline, between (0.0, 0.0) and (4.0, 0.0) and between (4.0, 1.0) and (2.0, -1.0), meet",
                () -> Outline.polygon(0, 0, 4, 0, 4, 1, 2, -1, 0, 1));
        refused( // clockwise
                "pieces 1 and 4 of the outline, between (0.0, 1.0) and (2.0, -1.0) and between (4.0, 0.0) and (0.0, 0.0), meet",
                () -> Outline.polygon(0, 0, 0, 1, 2, -1, 4, 1, 4, 0));
        refused("wide", () -> Outline.polygon(0, 0, 1, 0, 2, 0));
        refused("wide", () -> Outline.box(1, 0.0001f));
        refused("pieces 0 and 2", () -> Outline.polygon(0, 0, 2, 0, 3, 0, 2, 0, 1, 1));
        refused("three corners", () -> Outline.polygon(0, 0, 1, 1));
        refused("257 corners", () -> Outline.polygon(new float[514]));
        refused("width", () -> Outline.box(Float.NaN, 1));
        refused("closed", () -> Outline.of(Chain.of(0, 0, 1, 0, 1, 1)));
        refused(
                "piece 1 of the outline is an arc that bends inwards",
                () -> Outline.of(Chain.from(0, 0)
                        .lineTo(4, 0)
                        .arcTo(4, 2, -PI)
                        .lineTo(0, 4)
                        .close()));
        refused("rounding", () -> Outline.box(1, 1).round(0.6f));
        refused("rounding", () -> Outline.box(1, 1).round(0.001f));
        refused("the rounding is NaN, but must be from 0.01 to 0.5", () -> Outline.box(1, 1)
                .round(Float.NaN));
        refused("line 4", () -> tooth().round(0.05f));
    }

    private static void refused(String part, Runnable call) {
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, call::run);
        assertTrue(e.getMessage().contains(part), e::getMessage);
    }

    /** A box with a thin tooth on it. */
    private static Outline tooth() {
        return Outline.polygon(0, 0, 2, 0, 2, 1, 1.02f, 1, 1.02f, 1.2f, 1, 1.2f, 1, 1, 0, 1);
    }

    private static double square(double x) {
        return x * x;
    }

    private static double shoelace(float[] p) {
        double sum = 0;
        for (int k = 0; k < p.length; k += 2) {
            int next = (k + 2) % p.length;
            sum += (double) p[k] * p[next + 1] - (double) p[k + 1] * p[next];
        }
        return sum / 2;
    }

    /** Area, centroid and second moment of the polygon of points, counted in a raster. */
    private static double[] count(Outline outline, int cells) {
        float[] p = outline.points(1e-4f);
        float far = outline.reach();
        double cell = 2.0 * far / cells;
        double[] sum = new double[4];
        for (int i = 0; i < cells; i++) {
            for (int k = 0; k < cells; k++) {
                double x = (i + 0.5) * cell - far;
                double y = (k + 0.5) * cell - far;
                if (isInside(p, x, y)) {
                    sum[0] += cell * cell;
                    sum[1] += cell * cell * x;
                    sum[2] += cell * cell * y;
                    sum[3] += cell * cell * (x * x + y * y);
                }
            }
        }
        return sum;
    }

    private static boolean isInside(float[] p, double x, double y) {
        boolean in = false;
        for (int i = 0, k = p.length - 2; i < p.length; k = i, i += 2) {
            if (p[i + 1] > y != p[k + 1] > y
                    && x < ((double) p[k] - p[i]) * (y - p[i + 1]) / ((double) p[k + 1] - p[i + 1]) + p[i]) {
                in = !in;
            }
        }
        return in;
    }
}
