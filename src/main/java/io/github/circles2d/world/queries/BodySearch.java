package io.github.circles2d.world.queries;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.terrain.BoxTree;

/** The searches among bodies that are pushed. */
public final class BodySearch extends BoxSearch<BodyShape> {
    private final Tree tree = new Tree();
    private RigidStep bodies;

    public BodySearch() {
        super(new BodyShape());
    }

    /** Says which bodies the searches to come look at, as they are now; moved: whether they are others than at the last call, or elsewhere. */
    public void show(RigidStep of, boolean moved, Bounds bounds) {
        bodies = of;
        if (moved) {
            tree.build();
        }
        show(tree.nodes, tree.boxes, tree.links, of.end, bounds);
    }

    @Override
    void take(int body, double byX, double byY) {
        shape.take(bodies.outline[body], bodies.x[body] + byX, bodies.y[body] + byY, bodies.angle[body]);
    }

    /** A tree over the bodies, where they are. */
    private final class Tree extends BoxTree {
        /** More than what boxes lose by rounding, of coordinates and extents. */
        private static final float MARGIN = 0x1p-21f;

        int nodes;

        /** Builds it anew. If memory is short, it must not be searched until it has been built. */
        void build() {
            ensure(bodies.count);
            int n = 0;
            for (int body = 0; body < bodies.end; body++) {
                if (bodies.outline[body] != null) {
                    put(n++, body, bodies.x[body], bodies.y[body]);
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
}
