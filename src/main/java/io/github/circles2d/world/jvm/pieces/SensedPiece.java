package io.github.circles2d.world.jvm.pieces;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.Partner;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.PieceGap;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.PieceSensor;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.TouchRule;

/** What a circle and a piece of terrain that only sense each other do in a step, as {@link PieceSensor} says. Each worker has its own. */
public final class SensedPiece {
    private final ContactEvents events;
    private final PieceGap found = new PieceGap();

    // the normal towards the circle and the place, as the piece is after the step
    private float nx;
    private float ny;
    private float x;
    private float y;

    public SensedPiece(ContactEvents events) {
        this.events = events;
    }

    /**
     * Tells of a circle and a piece if they are in touch. o and end: the centre as the step begins and after it, in the frame of the piece; side:
     * of a piece that has a front, 1 if the circle has come from there.
     */
    public void tell(
            TouchRecords records,
            int id,
            int piece,
            float ox,
            float oy,
            float endX,
            float endY,
            float r,
            float side,
            TerrainStep terrain,
            StepConstants k) {
        int at = PieceRow.of(piece);
        int shape = terrain.traits[PieceRow.traits(piece) + PieceRow.SHAPE];
        float ux = endX - ox;
        float uy = endY - oy;
        boolean twoSided = PieceMeasure.isTwoSided(terrain, piece, shape);
        boolean behind = !twoSided && !(side > 0f);
        float measuredSide = twoSided && !PieceGap.isInFront(terrain.rows, at, shape, ox, oy) ? -1f : 1f;
        float time = behind
                ? PieceSensor.timeOfReturn(terrain.rows, at, shape, ox, oy, ux, uy, r)
                : PieceSensor.timeOfSensing(terrain.rows, at, shape, ox, oy, ux, uy, r);
        boolean touches = time <= 1f;
        if (!touches) {
            float gap = PieceGap.distance(terrain.rows, at, shape, endX, endY) - r;
            if (behind || !TouchRule.staysInTouch(TouchRule.NONE, gap, 2f * r)) {
                return;
            }
            time = 1f;
        }
        int code = Partner.ofPiece(piece);
        int pair = events.find(id, code);
        float thenX = ox + time * ux;
        float thenY = oy + time * uy;
        found.measure(terrain.rows, at, shape, thenX, thenY, r, measuredSide);
        float vn = (found.nx * ux + found.ny * uy) / k.dt;
        float approach = TouchRule.approachSpeed(vn);
        if (events.tracker.concerns(pair, id, code, touches, approach, 0f, Float.MAX_VALUE)) {
            float away = r + 0.5f * found.gap;
            place(thenX - away * found.nx, thenY - away * found.ny, piece, terrain, k);
            records.add(pair, id, code, approach, 0f, -nx, -ny, x, y, 0f, vn, Float.MAX_VALUE);
        }
    }

    /** Brings a place in the frame of a piece, which may have moved, to where it is after the step. */
    private void place(float inX, float inY, int piece, TerrainStep terrain, StepConstants k) {
        int at = PieceRow.of(piece);
        int motion = terrain.traits[PieceRow.traits(piece) + PieceRow.MOTION];
        float atX = terrain.rows[at + PieceRow.X];
        float atY = terrain.rows[at + PieceRow.Y];
        if (motion == 0) {
            nx = found.nx;
            ny = found.ny;
            x = atX + inX;
            y = atY + inY;
            return;
        }
        float[] bodies = terrain.motion;
        int pose = BodyRow.of(motion, k.subSteps) + BodyRow.pose(k.subSteps);
        float cos = bodies[pose + BodyRow.COS];
        float sin = bodies[pose + BodyRow.SIN];
        float pivotX = terrain.rows[at + PieceRow.PIVOT_X];
        float pivotY = terrain.rows[at + PieceRow.PIVOT_Y];
        float px = inX - pivotX;
        float py = inY - pivotY;
        nx = cos * found.nx - sin * found.ny;
        ny = sin * found.nx + cos * found.ny;
        x = ((atX + pivotX) + bodies[pose + BodyRow.DX]) + (cos * px - sin * py);
        y = ((atY + pivotY) + bodies[pose + BodyRow.DY]) + (sin * px + cos * py);
    }
}
