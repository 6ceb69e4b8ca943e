package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.AnchorRow;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.terrain.BodyAnchors;
import java.util.Arrays;

/** Brings the anchors of joints that are on bodies of terrain to where these are, and tells steps how they move. */
final class JointAnchors {
    private final JointTable table;
    private final BodyAnchors places;

    /** Bodies have not jumped since this number was theirs. */
    private int jumps;

    private boolean placed;

    /** The number of sub-steps that row 0 is of. */
    private int subSteps;

    JointAnchors(JointTable table, BodyAnchors places) {
        this.table = table;
        this.places = places;
    }

    /** An anchor has come, or is another one. */
    void changed() {
        placed = false;
    }

    /** Makes room for {@link #begin}. If there is none, nothing has changed. */
    void makeRoom(JointStep step, int subSteps) {
        int needed = AnchorRow.of(1 + (places.anyMoves() ? table.places.count() : 0), 0, subSteps);
        if (step.anchors.length < needed) {
            step.anchors = Arrays.copyOf(step.anchors, Math.max(needed, step.anchors.length * 3 / 2));
        }
    }

    void begin(JointStep step, StepConstants k, Bounds bounds) {
        boolean moved = step.anchorCount > 1;
        if (step.anchorCount == 0 || moved || subSteps != k.subSteps) {
            Arrays.fill(step.anchors, 0, AnchorRow.of(1, 0, k.subSteps), 0f);
            subSteps = k.subSteps;
            step.anchorCount = 1;
            step.anchorsVersion++;
        }
        if (table.places.count() > 0 && (moved || !placed || jumps != places.jumps() || places.anyMoves())) {
            place(step, k, bounds);
            jumps = places.jumps();
            placed = true;
        }
    }

    private void place(JointStep step, StepConstants k, Bounds bounds) {
        int rows = 1;
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (!table.ids.lives(joint) || table.places.body(joint) == AnchorPlaces.WORLD) {
                continue;
            }
            int body = table.places.body(joint);
            float x = table.places.x(joint);
            float y = table.places.y(joint);
            table.rows.setAnchor(joint, places.x(body, x, y, bounds), places.y(body, x, y, bounds));
            if (places.moves(body)) {
                places.fill(step.anchors, rows, body, x, y, k.dt, k.subSteps, bounds);
                table.rows.setAnchorRow(joint, rows++);
            } else {
                table.rows.setAnchorRow(joint, 0);
            }
        }
        if (rows > 1) {
            step.anchorCount = rows;
            step.anchorsVersion++;
        }
    }
}
