package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.WallMotion;
import java.util.Arrays;

/** The {@link RigidThing things} of a step. The first ones are the bodies, in the order of their ids. */
final class RigidThings {
    /** Far beyond all that bodies reach. */
    private static final float FAR = 1e10f;

    RigidThing[] all = {};
    int count;
    int bodies;

    /** Forgets the things from a number on, which have been added last. */
    void truncate(int from) {
        count = Math.min(count, from);
    }

    /** One more thing without corners and lines, at rest and unturned. */
    RigidThing add(int type, int id, float x, float y) {
        if (count == all.length) {
            RigidThing[] grown = Arrays.copyOf(all, Math.max(64, 2 * count));
            for (int t = count; t < grown.length; t++) {
                grown[t] = new RigidThing(t);
            }
            all = grown;
        }
        RigidThing t = all[count++];
        t.begin(type, id, x, y);
        return t;
    }

    // ---- pieces of terrain, and walls

    /** Adds a piece. Its place is (X, Y), or what it turns around if it moves. */
    RigidThing addPiece(int piece, TerrainStep terrain, StepConstants k) {
        float[] rows = terrain.rows;
        int row = PieceRow.of(piece);
        int shape = terrain.traits[PieceRow.traits(piece) + PieceRow.SHAPE];
        int motion = terrain.traits[PieceRow.traits(piece) + PieceRow.MOTION];
        RigidThing t = add(RigidStep.BODY_PIECE, piece, rows[row + PieceRow.X], rows[row + PieceRow.Y]);
        t.kind = terrain.traits[PieceRow.traits(piece) + PieceRow.KIND];
        t.oneWay = terrain.kinds.rows[KindTerrain.of(t.kind) + KindTerrain.ONE_WAY] != 0f;
        float px = 0f;
        float py = 0f;
        if (motion != 0) {
            int body = BodyRow.of(motion, k.subSteps);
            px = rows[row + PieceRow.PIVOT_X];
            py = rows[row + PieceRow.PIVOT_Y];
            t.vx = terrain.motion[body + BodyRow.VX] + 0f; // never -0
            t.vy = terrain.motion[body + BodyRow.VY] + 0f;
            t.omega = terrain.motion[body + BodyRow.OMEGA] + 0f;
        }
        if (PieceRow.form(shape) == PieceRow.ARC) {
            addArc(t, rows, row, shape, px, py);
        } else {
            addLine(t, rows, row, shape, px, py);
        }
        pose(t, terrain, 0, k);
        return t;
    }

    private static void addLine(RigidThing t, float[] rows, int row, int shape, float px, float py) {
        float tx = rows[row + PieceRow.TX];
        float ty = rows[row + PieceRow.TY];
        float nx = ty;
        float ny = -1f * tx;
        float length = rows[row + PieceRow.LENGTH];
        float thickness = rows[row + PieceRow.THICKNESS];
        float endX = rows[row + PieceRow.END_X] - px;
        float endY = rows[row + PieceRow.END_Y] - py;
        float startX = rows[row + PieceRow.START_X] - px;
        float startY = rows[row + PieceRow.START_Y] - py;
        t.addLine(startX, startY, nx, ny, length, thickness);
        if (PieceRow.form(shape) == PieceRow.SEGMENT && !t.oneWay) {
            t.addLine(endX, endY, -1f * nx, -1f * ny, length, thickness);
        }
        addStart(t, shape, startX, startY, thickness, nx, ny);
        addEnd(t, rows, row, shape, endX, endY, thickness, nx, ny);
    }

    /** A free end has half a turn; a joint belongs to the piece that ends there. */
    private static void addStart(RigidThing t, int shape, float x, float y, float r, float nx, float ny) {
        if (PieceRow.startJoint(shape) == PieceRow.FREE) {
            t.addCorner(x, y, r, -1f * nx, -1f * ny, nx, ny);
        }
    }

    private static void addEnd(
            RigidThing t, float[] rows, int row, int shape, float x, float y, float r, float nx, float ny) {
        if (PieceRow.endJoint(shape) == PieceRow.FREE) {
            t.addCorner(x, y, r, nx, ny, -1f * nx, -1f * ny);
        } else if (PieceRow.endJoint(shape) == PieceRow.CONVEX) {
            t.addCorner(x, y, r, nx, ny, rows[row + PieceRow.NEXT_Y], -1f * rows[row + PieceRow.NEXT_X]);
        }
    }

    private static void addArc(RigidThing t, float[] rows, int row, int shape, float px, float py) {
        float r = rows[row + PieceRow.LENGTH];
        float spread = rows[row + PieceRow.SPREAD];
        boolean hollow = (shape & PieceRow.SOLID_OUTSIDE) != 0;
        float mx = rows[row + PieceRow.TX];
        float my = rows[row + PieceRow.TY];
        float cx = -1f * px;
        float cy = -1f * py;
        if (spread == PieceRow.ALL_AROUND) {
            if (hollow) {
                t.addLine(cx, cy, mx, my, -r, spread);
            } else {
                t.addDisc(cx, cy, r);
            }
            return;
        }
        float sx = rows[row + PieceRow.START_X];
        float sy = rows[row + PieceRow.START_Y];
        float ex = rows[row + PieceRow.END_X];
        float ey = rows[row + PieceRow.END_Y];
        if (hollow) {
            t.addLine(cx, cy, mx, my, -r, spread);
            addStart(t, shape, sx - px, sy - py, 0f, -1f * sx / r, -1f * sy / r);
            addEnd(t, rows, row, shape, ex - px, ey - py, 0f, -1f * ex / r, -1f * ey / r);
        } else {
            t.addCorner(cx, cy, r, sx / r, sy / r, mx, my);
            t.addCorner(cx, cy, r, mx, my, ex / r, ey / r);
            addStart(t, shape, sx - px, sy - py, 0f, sx / r, sy / r);
            addEnd(t, rows, row, shape, ex - px, ey - py, 0f, ex / r, ey / r);
        }
    }

    /** Brings a piece to where it is at a boundary of sub-steps. */
    static void pose(RigidThing t, TerrainStep terrain, int boundary, StepConstants k) {
        int motion = terrain.traits[PieceRow.traits(t.id) + PieceRow.MOTION];
        if (motion != 0) {
            int pose = BodyRow.of(motion, k.subSteps) + BodyRow.pose(boundary);
            t.dx = terrain.motion[pose + BodyRow.DX];
            t.dy = terrain.motion[pose + BodyRow.DY];
            t.cos = terrain.motion[pose + BodyRow.COS];
            t.sin = terrain.motion[pose + BodyRow.SIN];
        }
        if (motion != 0 || boundary == 0) {
            t.place(true);
        }
    }

    /** Adds a wall, by {@link WallMotion#of}. */
    RigidThing addWall(int wall, StepConstants k) {
        boolean lower = (wall & 1) == 0;
        float side = lower ? 1f : -1f;
        float reach = Float.MAX_VALUE;
        RigidThing t;
        if (wall < 2) {
            t = add(RigidStep.BODY_WALL, wall, lower ? k.bounds.minX() : k.bounds.maxX(), 0f);
            t.addLine(0f, -side * FAR, side, 0f, 2f * FAR, 0f);
            t.vx = side * k.walls.speedFor(wall, reach) + 0f; // never -0
        } else {
            t = add(RigidStep.BODY_WALL, wall, 0f, lower ? k.bounds.minY() : k.bounds.maxY());
            t.addLine(side * FAR, 0f, 0f, side, 2f * FAR, 0f);
            t.vy = side * k.walls.speedFor(wall, reach) + 0f;
        }
        poseWall(t, 0, k);
        t.place(true);
        return t;
    }

    static void poseWall(RigidThing t, int boundary, StepConstants k) {
        int wall = t.id;
        float behind = k.walls.behind(wall, boundary - 1);
        float out = (wall & 1) == 0 ? -behind : behind;
        t.dx = wall < 2 ? out : 0f;
        t.dy = wall < 2 ? 0f : out;
    }

    long bytes() {
        long sum = 0;
        for (RigidThing each : all) {
            sum += each.bytes();
        }
        return sum;
    }
}
