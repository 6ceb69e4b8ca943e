package io.github.circles2d.playground;

import io.github.circles2d.Chain;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;

/** A body of terrain between the place where the button went down and the mouse, made anew whenever the mouse moves. */
final class ShapeTool implements Tool {
    /** What the body is, from (-x, -y) to (x, y) around its pivot. */
    interface Shape {
        void add(TerrainBody body, float x, float y, float thickness);
    }

    /** A segment. */
    static final Shape LINE = (body, x, y, thickness) -> body.addSegment(-x, -y, x, y, thickness, 0);

    /** Half a pipe. Drawn to the right it is open at the top. */
    static final Shape ARC =
            (body, x, y, thickness) -> body.addChain(Chain.from(x, y).arcTo(0, 0, -(float) Math.PI));

    private static final float THICKNESS = 0.6f;

    private final Shape shape;
    private TerrainBody body;
    private float startX;
    private float startY;
    private float radius;

    ShapeTool(Shape shape) {
        this.shape = shape;
    }

    @Override
    public void press(Sandbox sandbox, float x, float y, float brush) {
        radius = Arena.of(sandbox.world()).radius(sandbox.grain().radius() * brush);
        body = null;
        startX = x;
        startY = y;
    }

    @Override
    public void drag(Sandbox sandbox, float x, float y) {
        World world = sandbox.world();
        if (body != null && body.exists()) {
            body.remove();
        }
        body = null;
        float halfX = (x - startX) / 2;
        float halfY = (y - startY) / 2;
        if (Math.hypot(halfX, halfY) > radius && world.terrain().size() < PourTool.GREATEST_WORLD) {
            body = world.terrain().addBody(startX + halfX, startY + halfY, 0);
            shape.add(body, halfX, halfY, THICKNESS * radius);
        }
    }

    @Override
    public void release(Sandbox sandbox) {
        body = null;
    }

    @Override
    public float reach(Grain grain) {
        return grain.radius();
    }
}
