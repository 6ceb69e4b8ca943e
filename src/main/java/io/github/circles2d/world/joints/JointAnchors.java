package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.AnchorRow;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.terrain.BodyAnchors;
import io.github.circles2d.world.terrain.BodyPoses;
import io.github.circles2d.world.terrain.BodyTable;
import io.github.circles2d.world.terrain.TerrainTables;
import java.util.Arrays;

/** Where the anchors of joints are. Those on bodies of terrain go along with these, and steps are told how they move. */
public final class JointAnchors {
    private final JointTable table;
    private final TerrainTables terrain;
    private final BodyTable bodies;
    private final BodyAnchors onBodies;

    /** Bodies have not jumped since this number was theirs. */
    private int jumps;

    private boolean placed;

    /** The number of sub-steps that row 0 is of. */
    private int subSteps;

    JointAnchors(JointTable table, TerrainTables terrain) {
        this.table = table;
        this.terrain = terrain;
        bodies = terrain.bodies;
        onBodies = new BodyAnchors(bodies);
    }

    /** Where the anchor of a joint is: now, or with bodies in such poses if they are not null. */
    public float x(int joint, BodyPoses poses) {
        int body = table.places.body(joint);
        if (body == AnchorPlaces.WORLD) {
            return table.value(joint, JointRow.ANCHOR_X);
        }
        float x = table.places.x(joint);
        float y = table.places.y(joint);
        return poses == null
                ? onBodies.x(body, x, y, terrain.bounds())
                : onBodies.x(poses, body, x, y, terrain.bounds());
    }

    public float y(int joint, BodyPoses poses) {
        int body = table.places.body(joint);
        if (body == AnchorPlaces.WORLD) {
            return table.value(joint, JointRow.ANCHOR_Y);
        }
        float x = table.places.x(joint);
        float y = table.places.y(joint);
        return poses == null
                ? onBodies.y(body, x, y, terrain.bounds())
                : onBodies.y(poses, body, x, y, terrain.bounds());
    }

    /** Gives a joint without another circle a place, in the world or on the body that it has. Returns whether that is another one. */
    boolean set(int joint, float x, float y) {
        if (table.places.body(joint) == AnchorPlaces.WORLD) {
            Bounds bounds = terrain.bounds();
            float placeX = bounds.placeX(x + 0f);
            float placeY = bounds.placeY(y + 0f);
            boolean changes =
                    placeX != table.value(joint, JointRow.ANCHOR_X) || placeY != table.value(joint, JointRow.ANCHOR_Y);
            table.setAnchor(joint, placeX, placeY);
            return changes;
        }
        boolean changes = x != table.places.x(joint) || y != table.places.y(joint);
        table.places.set(joint, x, y);
        changed();
        return changes;
    }

    /** An anchor has come, or is another one. */
    void changed() {
        placed = false;
    }

    /** Makes room for {@link #begin}. If there is none, nothing has changed. */
    void makeRoom(JointStep step, int subSteps) {
        int needed = AnchorRow.of(1 + (bodies.anyMoves() ? table.places.count() : 0), 0, subSteps);
        if (step.anchors.length < needed) {
            step.anchors = Arrays.copyOf(step.anchors, Math.max(needed, step.anchors.length * 3 / 2));
        }
    }

    void begin(JointStep step, StepConstants k) {
        boolean moved = step.anchorCount > 1;
        if (step.anchorCount == 0 || moved || subSteps != k.subSteps) {
            Arrays.fill(step.anchors, 0, AnchorRow.of(1, 0, k.subSteps), 0f);
            subSteps = k.subSteps;
            step.anchorCount = 1;
            step.anchorsVersion++;
        }
        if (table.places.count() > 0 && (moved || !placed || jumps != bodies.jumps() || bodies.anyMoves())) {
            place(step, k);
            jumps = bodies.jumps();
            placed = true;
        }
    }

    private void place(JointStep step, StepConstants k) {
        Bounds bounds = terrain.bounds();
        int rows = 1;
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (!table.ids.lives(joint) || table.places.body(joint) == AnchorPlaces.WORLD) {
                continue;
            }
            int body = table.places.body(joint);
            float x = table.places.x(joint);
            float y = table.places.y(joint);
            table.setAnchor(joint, onBodies.x(body, x, y, bounds), onBodies.y(body, x, y, bounds));
            if (bodies.moves(body)) {
                onBodies.fill(step.anchors, rows, body, x, y, k.dt, k.subSteps, bounds);
                setRow(joint, rows++);
            } else {
                setRow(joint, 0);
            }
        }
        if (rows > 1) {
            step.anchorCount = rows;
            step.anchorsVersion++;
        }
    }

    private void setRow(int joint, int row) {
        if (table.trait(joint, JointRow.ANCHOR) != row) {
            table.setTrait(joint, JointRow.ANCHOR, row);
        }
    }
}
