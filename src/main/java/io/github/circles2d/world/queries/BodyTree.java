package io.github.circles2d.world.queries;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.terrain.BoxTree;

/** A tree over the bodies that are pushed, where they are. */
final class BodyTree extends BoxTree {
    /** More than what boxes lose by rounding, of coordinates and extents. */
    private static final float MARGIN = 0x1p-21f;

    private RigidStep bodies;
    private int nodes;

    BodyTree() {}

    int nodes() {
        return nodes;
    }

    /** Builds it anew. If memory is short, it must not be searched until it has been built. */
    void build(RigidStep of) {
        ensure(of.count);
        bodies = of;
        int n = 0;
        for (int body = 0; body < of.end; body++) {
            if (of.outline[body] != null) {
                put(n++, body, of.x[body], of.y[body]);
            }
        }
        nodes = nodesOf(n);
        build(0, n);
        refit(0, nodes);
    }

    /** The box around that of the outline, as it is turned. */
    @Override
    protected void fit(int body, int at) {
        OutlineShape outline = bodies.outline[body];
        double cos = Rotation.cos(bodies.angle[body]);
        double sin = Rotation.sin(bodies.angle[body]);
        float x = (float) (bodies.x[body] + cos * outline.middleX() - sin * outline.middleY());
        float y = (float) (bodies.y[body] + sin * outline.middleX() + cos * outline.middleY());
        float halfX = (float) (Math.abs(cos) * outline.halfX() + Math.abs(sin) * outline.halfY());
        float halfY = (float) (Math.abs(sin) * outline.halfX() + Math.abs(cos) * outline.halfY());
        halfX += (Math.abs(x) + halfX) * MARGIN;
        halfY += (Math.abs(y) + halfY) * MARGIN;
        boxes[at + MIN_X] = x - halfX;
        boxes[at + MIN_Y] = y - halfY;
        boxes[at + MAX_X] = x + halfX;
        boxes[at + MAX_Y] = y + halfY;
    }
}
