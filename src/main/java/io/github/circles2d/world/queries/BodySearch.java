package io.github.circles2d.world.queries;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.model.Bounds;

/** The searches among bodies that are pushed. */
public final class BodySearch extends BoxSearch {
    private final BodyShape shape;
    private final BodyTree tree = new BodyTree();
    private RigidStep bodies;

    public BodySearch() {
        this(new BodyShape());
    }

    private BodySearch(BodyShape shape) {
        super(shape);
        this.shape = shape;
    }

    /** Says which bodies the searches to come look at, as they are now; moved: whether they are others than at the last call, or elsewhere. */
    public void show(RigidStep of, boolean moved, Bounds bounds) {
        bodies = of;
        if (moved) {
            tree.build(of);
        }
        show(tree.nodes(), tree.boxes, tree.links, of.end, bounds);
    }

    @Override
    void take(int body, double byX, double byY) {
        shape.take(bodies.outline[body], bodies.x[body] + byX, bodies.y[body] + byY, bodies.angle[body]);
    }
}
