package io.github.circles2d.world.terrain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainLimits;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.Random;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

class TerrainTablesTest {
    private static final Bounds BOUNDS = new Bounds(0, 0, 100, 100);
    private static final int SUB_STEPS = 4;
    private static final float DT = 1f / 60;

    private final TerrainStep step = new TerrainStep();
    private final KindTable kinds = new KindTable();
    private final StepConstants constants = new StepConstants();
    private TerrainTables tables = new TerrainTables(step, BOUNDS);

    private void begin() {
        constants.set(DT, SUB_STEPS, 0, 0, BOUNDS, BOUNDS, DT, ContactSettings.DEFAULT);
        tables.makeRoom(SUB_STEPS);
        tables.begin(constants, kinds);
    }

    private void end() {
        tables.end(DT, SUB_STEPS);
    }

    private int segment(int body, float x1, float y1, float x2, float y2) {
        tables.pieces.ensure(1);
        return tables.addSegment(body, 0, x1, y1, x2, y2, 0);
    }

    private int[] chain(ChainPath path) {
        long[] handles = new long[path.pieces()];
        tables.pieces.ensure(handles.length);
        tables.addChain(BodyTable.GROUND, 0, path, path.pieces(), path.isClosed(), handles);
        int[] ids = new int[handles.length];
        for (int k = 0; k < ids.length; k++) {
            ids[k] = Handle.id(handles[k]);
        }
        return ids;
    }

    private static ChainPath lines(float... points) {
        ChainPath path = new ChainPath(points[0], points[1]);
        for (int k = 2; k < points.length; k += 2) {
            path.lineTo(points[k], points[k + 1]);
        }
        return path;
    }

    private int shape(int piece) {
        return step.traits[PieceRow.traits(piece) + PieceRow.SHAPE];
    }

    private float row(int piece, int element) {
        return step.rows[PieceRow.of(piece) + element];
    }

    @Test
    void groundIsConvexWhereItsTopIs() {
        // from right to left, circles are above: a hill, then a valley
        int[] ids = chain(lines(40, 0, 30, 10, 20, 0, 10, 10));
        begin();
        assertThat(PieceRow.startJoint(shape(ids[0]))).isEqualTo(PieceRow.FREE);
        assertThat(PieceRow.endJoint(shape(ids[0]))).isEqualTo(PieceRow.CONVEX);
        assertThat(PieceRow.startJoint(shape(ids[1]))).isEqualTo(PieceRow.CONVEX);
        assertThat(PieceRow.endJoint(shape(ids[1]))).isEqualTo(PieceRow.CONCAVE);
        assertThat(PieceRow.startJoint(shape(ids[2]))).isEqualTo(PieceRow.CONCAVE);
        assertThat(PieceRow.endJoint(shape(ids[2]))).isEqualTo(PieceRow.FREE);
        assertThat(row(ids[0], PieceRow.NEXT_X)).isEqualTo(row(ids[1], PieceRow.TX));
        assertThat(row(ids[0], PieceRow.NEXT_Y)).isEqualTo(row(ids[1], PieceRow.TY));
        assertThat(row(ids[2], PieceRow.NEXT_X)).isZero();
        // the front is the right: above
        assertThat(-row(ids[1], PieceRow.TX)).isPositive();
    }

    @Test
    void pointsInLineAreNoCornersThoughTheyAreRounded() {
        float[] points = new float[400];
        for (int k = 0; k < 200; k++) {
            points[2 * k] = 90 - 0.37f * k;
            points[2 * k + 1] = 3 + 0.111f * k;
        }
        int[] ids = chain(lines(points));
        begin();
        for (int k = 1; k < ids.length; k++) {
            assertThat(PieceRow.startJoint(shape(ids[k]))).isEqualTo(PieceRow.CONVEX);
        }
    }

    @Test
    void aClosedChainHasNoFreeEndUntilAPieceIsRemoved() {
        ChainPath box = lines(0, 0, 10, 0, 10, 10, 0, 10);
        box.close();
        int[] ids = chain(box);
        begin();
        assertThat(ids).hasSize(4);
        for (int id : ids) {
            assertThat(PieceRow.startJoint(shape(id))).isEqualTo(PieceRow.CONVEX);
            assertThat(PieceRow.endJoint(shape(id))).isEqualTo(PieceRow.CONVEX);
        }
        tables.remove(ids[1]);
        begin();
        assertThat(PieceRow.form(shape(ids[1]))).isEqualTo(PieceRow.NO_PIECE);
        assertThat(PieceRow.endJoint(shape(ids[0]))).isEqualTo(PieceRow.FREE);
        assertThat(row(ids[0], PieceRow.NEXT_Y)).isZero();
        assertThat(PieceRow.startJoint(shape(ids[2]))).isEqualTo(PieceRow.FREE);
        assertThat(PieceRow.endJoint(shape(ids[2]))).isEqualTo(PieceRow.CONVEX);
    }

    @Test
    void anArcGoesOnSmoothlyFromALineToALine() {
        // down a slope into a bowl and up again: right to left, circles above; the bowl turns to the right
        ChainPath path = new ChainPath(30, 5);
        path.lineTo(20, 5);
        path.arcTo(20, 15, -(float) Math.PI / 2);
        path.lineTo(10, 30);
        int[] ids = chain(path);
        begin();
        int arc = ids[1];
        assertThat(PieceRow.form(shape(arc))).isEqualTo(PieceRow.ARC);
        assertThat(shape(arc) & PieceRow.SOLID_OUTSIDE).isNotZero();
        assertThat(PieceRow.endJoint(shape(ids[0]))).isEqualTo(PieceRow.CONVEX);
        assertThat(PieceRow.endJoint(shape(arc))).isEqualTo(PieceRow.CONVEX);
        assertThat(row(arc, PieceRow.LENGTH)).isEqualTo(10);
        assertThat(row(arc, PieceRow.X) + row(arc, PieceRow.START_X)).isCloseTo(20, within(1e-5f));
        assertThat(row(arc, PieceRow.Y) + row(arc, PieceRow.START_Y)).isCloseTo(5, within(1e-5f));
        assertThat(row(arc, PieceRow.X) + row(arc, PieceRow.END_X)).isCloseTo(10, within(1e-5f));
        assertThat(row(arc, PieceRow.Y) + row(arc, PieceRow.END_Y)).isCloseTo(15, within(1e-5f));
        assertThat(row(arc, PieceRow.SPREAD)).isCloseTo((float) Math.sqrt(0.5), within(1e-6f));
        assertThat(row(arc, PieceRow.TX)).isCloseTo(-(float) Math.sqrt(0.5), within(1e-6f));
        assertThat(row(arc, PieceRow.TY)).isCloseTo(-(float) Math.sqrt(0.5), within(1e-6f));
        assertThat(row(ids[0], PieceRow.NEXT_X)).isCloseTo(-1, within(1e-6f));
        assertThat(row(ids[0], PieceRow.NEXT_Y)).isCloseTo(0, within(1e-6f));
        assertThat(row(arc, PieceRow.NEXT_Y)).isEqualTo(1);
        // its box is the lower left quarter of the circle
        assertThat(row(arc, PieceRow.MID_X)).isCloseTo(15, within(1e-5f));
        assertThat(row(arc, PieceRow.MID_Y)).isCloseTo(10, within(1e-5f));
        assertThat(row(arc, PieceRow.HALF_X)).isCloseTo(5, within(1e-5f));
    }

    @Test
    void aWholeCircleClosesItself() {
        ChainPath hill = new ChainPath(60, 50);
        hill.arcTo(50, 50, 2 * (float) Math.PI);
        hill.close();
        int[] ids = chain(hill);
        begin();
        assertThat(ids).hasSize(1);
        assertThat(row(ids[0], PieceRow.SPREAD)).isEqualTo(PieceRow.ALL_AROUND);
        assertThat(row(ids[0], PieceRow.HALF_X)).isEqualTo(10);
        tables.remove(ids[0]);
        begin();
        assertThat(tables.isThere()).isFalse();
    }

    @Test
    void rowsFollowThePoseOfTheirBody() {
        tables.bodies.ensure(1);
        int body = tables.addBody(10, 20, 1 << 30);
        int piece = segment(body, 1, 0, 3, 0);
        tables.bodies.setVelocity(body, 6, 0);
        tables.bodies.setOmega(body, 3);
        begin();
        int traits = PieceRow.traits(piece);
        assertThat(step.bodies).isEqualTo(2);
        assertThat(step.traits[traits + PieceRow.MOTION]).isEqualTo(1);
        assertThat(row(piece, PieceRow.X)).isEqualTo(10);
        assertThat(row(piece, PieceRow.Y)).isEqualTo(21);
        assertThat(row(piece, PieceRow.END_Y)).isEqualTo(2);
        assertThat(row(piece, PieceRow.TY)).isEqualTo(1);
        assertThat(row(piece, PieceRow.MOST)).isBetween(6 * DT + 3 * 3 * DT, 1.0001f * (6 * DT + 3 * 3 * DT));
        int at = BodyRow.of(1, SUB_STEPS);
        assertThat(step.motion[at + BodyRow.PIVOT_X]).isEqualTo(10);
        assertThat(step.motion[at + BodyRow.VX]).isCloseTo(6, within(1e-5f));
        assertThat(step.motion[at + BodyRow.OMEGA]).isCloseTo(3, within(1e-5f));
        int half = at + BodyRow.pose(SUB_STEPS / 2);
        assertThat(step.motion[half + BodyRow.DX]).isCloseTo(3 * DT, within(1e-6f));
        assertThat(step.motion[half + BodyRow.SIN]).isCloseTo((float) Math.sin(1.5 * DT), within(1e-6f));
        assertThat(step.motion[at + BodyRow.pose(0) + BodyRow.COS]).isEqualTo(1);
        end();
        tables.bodies.setVelocity(body, 0, 0);
        tables.bodies.setOmega(body, 0);
        begin();
        assertThat(step.bodies).isEqualTo(1);
        assertThat(step.traits[traits + PieceRow.MOTION]).isZero();
        assertThat(row(piece, PieceRow.MOST)).isZero();
        assertThat(row(piece, PieceRow.X)).isCloseTo(10 + 6 * DT - (float) Math.sin(3 * DT), within(1e-5f));
        int version = step.version;
        begin();
        assertThat(step.version).isEqualTo(version);
    }

    @Test
    void aSlowBodyCreepsFarFromTheOrigin() {
        tables.bodies.ensure(1);
        int body = tables.addBody(90_000, 0, 0);
        tables.bodies.setVelocity(body, 0.06f, 0);
        for (int k = 0; k < 600; k++) {
            begin();
            end();
        }
        assertThat((float) tables.bodies.x[body]).isCloseTo(90_000.6f, within(0.01f));
    }

    @Test
    void aBodyTurnsLessThanHalfATurnASubStep() {
        tables.bodies.ensure(1);
        int body = tables.addBody(0, 0, 0);
        segment(body, 1, 0, 3, 0);
        tables.bodies.setOmega(body, 1e9f);
        begin();
        int at = BodyRow.of(1, SUB_STEPS);
        assertThat(step.motion[at + BodyRow.OMEGA] * DT / SUB_STEPS).isBetween(2.9f, 3.1f);
    }

    @Test
    void aPieceHasANewSerialOnceItIsAnotherOrHasJumped() {
        tables.bodies.ensure(1);
        int body = tables.addBody(0, 0, 0);
        int piece = segment(body, 1, 0, 3, 0);
        int serial = step.traits.length == 0 ? 0 : serial(piece);
        begin();
        int first = serial(piece);
        assertThat(first).isNotEqualTo(serial);
        tables.pieces.setKind(piece, 3);
        tables.travel(body, 5, 5, 0);
        begin();
        end();
        begin();
        assertThat(serial(piece)).isEqualTo(first);
        tables.teleport(body, 9, 9, 0);
        begin();
        int second = serial(piece);
        assertThat(second).isNotEqualTo(first);
        tables.remove(piece);
        assertThat(segment(BodyTable.GROUND, 0, 0, 1, 1)).isEqualTo(piece);
        begin();
        assertThat(serial(piece)).isNotIn(first, second);
    }

    private int serial(int piece) {
        return step.traits[PieceRow.traits(piece) + PieceRow.SERIAL];
    }

    @Test
    void theRangeThatHasChangedIsTold() {
        for (int k = 0; k < 10; k++) {
            segment(BodyTable.GROUND, k, 0, k + 1, 0);
        }
        begin();
        int version = step.version;
        assertThat(step.changedFrom).isZero();
        assertThat(step.changedTo).isEqualTo(10);
        tables.pieces.setKind(4, 1);
        tables.pieces.setKind(7, 1);
        begin();
        assertThat(step.version).isEqualTo(version + 1);
        assertThat(step.changedFrom).isEqualTo(4);
        assertThat(step.changedTo).isEqualTo(8);
    }

    @Test
    void whereAnAxisWrapsTheMiddleOfAPieceIsInside() {
        Bounds wraps = BOUNDS.with(AxisEdge.WRAP, AxisEdge.OPEN);
        tables = new TerrainTables(step, wraps);
        int right = segment(BodyTable.GROUND, 90, 0, 115, 0);
        int left = segment(BodyTable.GROUND, -20, 0, 10, -200);
        begin();
        assertThat(row(right, PieceRow.X)).isEqualTo(-10);
        assertThat(row(right, PieceRow.END_X)).isEqualTo(25);
        assertThat(row(left, PieceRow.X)).isEqualTo(80);
        assertThat(row(left, PieceRow.MID_X)).isEqualTo(95);
    }

    /** Points of pieces, found by sines of the library, are within the boxes of pieces, and of the tree, during the whole step. */
    @Test
    void boxesHoldAllPointsOfPiecesWhileTheyMove() {
        Random random = new Random(7);
        for (int round = 0; round < 40; round++) {
            tables = new TerrainTables(step, BOUNDS);
            addRandomTerrain(random, 1 + random.nextInt(60));
            for (int k = 0; k < 3; k++) {
                begin();
                for (int piece = 0; piece < step.pieces; piece++) {
                    if (PieceRow.form(shape(piece)) != PieceRow.NO_PIECE) {
                        checkPoints(piece);
                    }
                }
                checkTree(random);
                end();
            }
        }
    }

    private void addRandomTerrain(Random random, int count) {
        int bodies = 1 + random.nextInt(4);
        tables.bodies.ensure(bodies);
        for (int k = 1; k < bodies; k++) {
            int body = tables.addBody(random.nextFloat() * 100, random.nextFloat() * 100, random.nextInt());
            tables.bodies.setVelocity(body, random.nextFloat() * 200, random.nextFloat() * -100);
            tables.bodies.setOmega(body, random.nextFloat() * 200 - 100);
        }
        tables.pieces.ensure(count);
        for (int k = 0; k < count; k++) {
            int body = random.nextInt(bodies);
            float x = random.nextFloat() * 100;
            float y = random.nextFloat() * 100;
            if (random.nextBoolean()) {
                float size = random.nextInt(8) == 0 ? 100 : 5;
                tables.addSegment(
                        body,
                        0,
                        x,
                        y,
                        x + 0.1f + size * random.nextFloat(),
                        y - size * random.nextFloat(),
                        random.nextFloat());
            } else {
                float from = random.nextFloat() * 20 - 10;
                long opening = 2 + (long) (random.nextDouble() * (Rotation.TURN - 2));
                tables.addArc(body, 0, x, y, 0.1f + 8 * random.nextFloat(), from, opening, random.nextBoolean());
            }
        }
        for (int k = 0; k < count; k += 7) {
            tables.remove(k);
        }
    }

    private void checkPoints(int piece) {
        float x = row(piece, PieceRow.X);
        float y = row(piece, PieceRow.Y);
        int motion = step.traits[PieceRow.traits(piece) + PieceRow.MOTION];
        double thickness = row(piece, PieceRow.THICKNESS);
        boolean arc = PieceRow.form(shape(piece)) == PieceRow.ARC;
        double middle = Math.atan2(row(piece, PieceRow.TY), row(piece, PieceRow.TX));
        double half =
                row(piece, PieceRow.SPREAD) == PieceRow.ALL_AROUND ? Math.PI : Math.acos(row(piece, PieceRow.SPREAD));
        int leaf = leafOf(piece);
        for (int k = 0; k <= 16; k++) {
            double share = k / 16.0;
            double angle = middle + half * (2 * share - 1);
            double px =
                    arc ? x + row(piece, PieceRow.LENGTH) * Math.cos(angle) : x + share * row(piece, PieceRow.END_X);
            double py =
                    arc ? y + row(piece, PieceRow.LENGTH) * Math.sin(angle) : y + share * row(piece, PieceRow.END_Y);
            double slack = 1e-3; // of the cosine of a small opening
            assertThat(Math.abs(px - row(piece, PieceRow.MID_X)) + thickness)
                    .isLessThanOrEqualTo(row(piece, PieceRow.HALF_X) + slack);
            assertThat(Math.abs(py - row(piece, PieceRow.MID_Y)) + thickness)
                    .isLessThanOrEqualTo(row(piece, PieceRow.HALF_Y) + slack);
            for (int boundary = 0; boundary <= SUB_STEPS; boundary++) {
                double[] at = {px, py};
                if (motion > 0) {
                    move(motion, boundary, at);
                }
                assertThat(Math.hypot(at[0] - px, at[1] - py))
                        .isLessThanOrEqualTo(row(piece, PieceRow.MOST) * 1.00001 + 1e-5);
                assertThat(at[0] - thickness).isGreaterThanOrEqualTo(step.boxes[4 * leaf] - slack);
                assertThat(at[1] - thickness).isGreaterThanOrEqualTo(step.boxes[4 * leaf + 1] - slack);
                assertThat(at[0] + thickness).isLessThanOrEqualTo(step.boxes[4 * leaf + 2] + slack);
                assertThat(at[1] + thickness).isLessThanOrEqualTo(step.boxes[4 * leaf + 3] + slack);
            }
        }
    }

    private void move(int motion, int boundary, double[] at) {
        int row = BodyRow.of(motion, SUB_STEPS);
        int pose = row + BodyRow.pose(boundary);
        double x = at[0] - step.motion[row + BodyRow.PIVOT_X];
        double y = at[1] - step.motion[row + BodyRow.PIVOT_Y];
        double cos = step.motion[pose + BodyRow.COS];
        double sin = step.motion[pose + BodyRow.SIN];
        at[0] = step.motion[row + BodyRow.PIVOT_X] + step.motion[pose + BodyRow.DX] + cos * x - sin * y;
        at[1] = step.motion[row + BodyRow.PIVOT_Y] + step.motion[pose + BodyRow.DY] + sin * x + cos * y;
    }

    private int leafOf(int piece) {
        for (int node = 0; node < step.nodes; node++) {
            if (step.links[2 * node + 1] == piece) {
                return node;
            }
        }
        throw new AssertionError("piece " + piece + " is not in the tree");
    }

    private void checkTree(Random random) {
        int leaves = 0;
        for (int node = 0; node < step.nodes; node++) {
            leaves += step.links[2 * node + 1] >= 0 ? 1 : 0;
        }
        assertThat(leaves).isEqualTo(tables.pieces.ids.size());
        for (int k = 0; k < 20; k++) {
            float x = random.nextFloat() * 120 - 10;
            float y = random.nextFloat() * 120 - 10;
            float size = random.nextFloat() * 10;
            TreeSet<Integer> found = new TreeSet<>();
            int looked = 0;
            for (int i = 0; i < step.nodes; looked++) {
                if (meets(i, x, y, size)) {
                    if (step.links[2 * i + 1] >= 0) {
                        found.add(step.links[2 * i + 1]);
                    }
                    i++;
                } else {
                    i = step.links[2 * i];
                }
            }
            TreeSet<Integer> all = new TreeSet<>();
            for (int node = 0; node < step.nodes; node++) {
                if (step.links[2 * node + 1] >= 0 && meets(node, x, y, size)) {
                    all.add(step.links[2 * node + 1]);
                }
            }
            assertThat(found).isEqualTo(all);
            assertThat(looked).isLessThanOrEqualTo(step.nodes);
        }
    }

    private boolean meets(int node, float x, float y, float size) {
        return step.boxes[4 * node] <= x + size
                && step.boxes[4 * node + 1] <= y + size
                && step.boxes[4 * node + 2] >= x - size
                && step.boxes[4 * node + 3] >= y - size;
    }

    /** The greatest and least values that calls take. */
    @Test
    void everyNumberOfAStepIsFinite() {
        float[] values = {0, 1, -1, 1e9f, -1e9f, 1e-6f, 123456.79f};
        for (Bounds bounds : new Bounds[] {BOUNDS, BOUNDS.with(AxisEdge.WRAP, AxisEdge.WRAP)}) {
            Random random = new Random(5);
            tables = new TerrainTables(step, bounds);
            tables.bodies.ensure(40);
            for (int k = 0; k < 40; k++) {
                int body = tables.addBody(one(values, random), one(values, random), random.nextInt());
                tables.bodies.setVelocity(body, one(values, random), one(values, random));
                tables.bodies.setOmega(body, one(values, random));
                if (random.nextBoolean()) {
                    tables.travel(body, one(values, random), one(values, random), random.nextInt());
                }
            }
            tables.pieces.ensure(2000);
            for (int k = 0; k < 1000; k++) {
                addIfAllowed(random.nextInt(41), values, random, bounds);
            }
            for (int k = 0; k < 5; k++) {
                begin();
                for (int at = 0; at < PieceRow.of(step.pieces); at++) {
                    assertThat(step.rows[at])
                            .as("element %d of a row", at % PieceRow.STRIDE)
                            .isFinite();
                }
                for (int at = 0; at < 4 * step.nodes; at++) {
                    assertThat(step.boxes[at]).isFinite();
                }
                for (int at = 0; at < BodyRow.of(step.bodies, SUB_STEPS); at++) {
                    assertThat(step.motion[at]).isFinite();
                }
                end();
            }
        }
    }

    private static float one(float[] values, Random random) {
        return values[random.nextInt(values.length)];
    }

    private void addIfAllowed(int body, float[] values, Random random, Bounds bounds) {
        float x = one(values, random);
        float y = one(values, random);
        float x2 = one(values, random);
        float y2 = one(values, random);
        try {
            if (random.nextBoolean()) {
                float thickness = Math.abs(one(values, random));
                TerrainLimits.segment(x, y, x2, y2, thickness, bounds);
                tables.addSegment(body, 0, x, y, x2, y2, thickness);
            } else if (random.nextBoolean()) {
                ChainPath path = new ChainPath(x, y);
                path.arcTo(x2, y2, random.nextFloat() * 12 - 6);
                path.lineTo(one(values, random), one(values, random));
                path.check(path.pieces(), bounds);
                tables.addChain(body, 0, path, path.pieces(), false, null);
            } else {
                long opening = TerrainLimits.opening(0, random.nextFloat() * 6.28f);
                TerrainLimits.arc(x, y, Math.abs(x2), (int) (opening >>> 1), bounds);
                tables.addArc(body, 0, x, y, Math.abs(x2), y2, opening, random.nextBoolean());
            }
        } catch (IllegalArgumentException e) {
            // not allowed
        }
    }

    @Test
    void aLongFloorCostsNoMoreThanItsOwn() {
        Random random = new Random(3);
        for (int k = 0; k < 4096; k++) {
            float x = random.nextFloat() * 100;
            float y = random.nextFloat() * 100;
            segment(BodyTable.GROUND, x, y, x + 0.2f, y);
        }
        for (int k = 0; k < 8; k++) {
            segment(BodyTable.GROUND, -100, 10 * k, 200, 10 * k + 1);
        }
        begin();
        int looked = 0;
        for (int k = 0; k < 100; k++) {
            float x = random.nextFloat() * 100;
            float y = random.nextFloat() * 100;
            for (int i = 0; i < step.nodes; looked++) {
                i = meets(i, x, y, 0.5f) ? i + 1 : step.links[2 * i];
            }
        }
        assertThat(looked / 100).isLessThan(300); // of 8207
    }

    @Test
    void aRangeIsOfThePiecesOfARestoredState() {
        segment(BodyTable.GROUND, 0, 0, 1, 1);
        begin();
        SavedState saved = new SavedState();
        tables.save(saved.terrain);
        int version = step.version;
        for (int k = 0; k < 100; k++) {
            segment(BodyTable.GROUND, 0, k, 1, k); // no step sees them
        }
        tables.load(saved.terrain, BOUNDS, new SavedPieceContacts());
        begin();
        assertThat(step.pieces).isEqualTo(1);
        assertThat(step.version).isEqualTo(version + 1);
        assertThat(step.changedFrom).isZero();
        assertThat(step.changedTo).isEqualTo(1);
    }

    @Test
    void aChainMayHaveAllPiecesBeforeItIsClosed() {
        ChainPath path = new ChainPath(0, 0);
        while (path.pieces() < TerrainLimits.PIECES - 1) {
            path.lineTo(1 + path.pieces() % 2, 1);
        }
        path.lineTo(0, 0);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> path.lineTo(1, 1))
                .withMessage("a chain has at most 1048576 pieces");
        path.close();
        assertThat(path.isClosed()).isTrue();
        assertThat(path.pieces()).isEqualTo(TerrainLimits.PIECES);
    }
}
