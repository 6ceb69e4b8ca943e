package io.github.circles2d.playground;

import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;

/** Thick segments along the way of the mouse, which are one body; a click alone gives a static circle. */
final class WallTool implements Tool {
    /** Of a segment, in radii of a circle. */
    private static final double LENGTH = 1.5;

    private static final float THICKNESS = 0.6f;

    private TerrainBody body;
    private int pieces;
    private float lastX;
    private float lastY;
    private float radius;

    @Override
    public void press(Sandbox sandbox, float x, float y, float brush) {
        radius = Arena.of(sandbox.world()).radius(sandbox.grain().radius() * brush);
        body = null;
        pieces = 0;
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
        if (body == null || !body.exists()) { // the first one, or the world has gone back in time
            body = world.terrain().addBody(lastX, lastY, 0);
        }
        float px = body.x();
        float py = body.y();
        body.addSegment(lastX - px, lastY - py, x - px, y - py, THICKNESS * radius, 0);
        pieces++;
        lastX = x;
        lastY = y;
    }

    @Override
    public void release(Sandbox sandbox) {
        World world = sandbox.world();
        if (pieces == 0 && Arena.of(world).contains(lastX, lastY) && world.size() < PourTool.GREATEST_WORLD) {
            world.add(lastX, lastY, radius, Float.POSITIVE_INFINITY);
        }
    }

    @Override
    public float reach(Grain grain) {
        return grain.radius();
    }
}
