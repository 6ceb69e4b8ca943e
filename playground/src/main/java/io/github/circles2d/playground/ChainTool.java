package io.github.circles2d.playground;

import io.github.circles2d.Chain;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;

/** Smooth ground along the way of the mouse: circles are on its right, above if it is drawn to the left. */
final class ChainTool implements Tool {
    /** Of a line, in radii of a circle. */
    private static final double LENGTH = 2;

    private TerrainBody body;
    private Chain chain;
    private float startX;
    private float startY;
    private float lastX;
    private float lastY;
    private float radius;

    @Override
    public void press(Sandbox sandbox, float x, float y, float brush) {
        radius = Arena.of(sandbox.world()).radius(sandbox.grain().radius() * brush);
        body = null;
        chain = Chain.from(0, 0);
        startX = x;
        startY = y;
        lastX = x;
        lastY = y;
    }

    @Override
    public void drag(Sandbox sandbox, float x, float y) {
        World world = sandbox.world();
        if (Math.hypot(x - lastX, y - lastY) < LENGTH * radius
                || world.terrain().size() >= PourTool.GREATEST_WORLD) {
            return;
        }
        chain.lineTo(x - startX, y - startY);
        lastX = x;
        lastY = y;
        if (body != null && body.exists()) {
            body.remove();
        }
        body = world.terrain().addBody(startX, startY, 0);
        body.addChain(chain);
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
