package io.github.circles2d.playground;

import io.github.circles2d.StaleHandles;
import io.github.circles2d.World;

/** Removes the circles, the bodies and the pieces of terrain that the way of the mouse touches. */
final class EraseTool implements Tool {
    private static final float REACH = 3;

    private long[] found = new long[256];
    private float reach;
    private float lastX;
    private float lastY;

    @Override
    public void press(Sandbox sandbox, float x, float y, float brush) {
        reach = reach(sandbox.grain()) * brush;
        lastX = x;
        lastY = y;
        erase(sandbox, x, y);
    }

    @Override
    public void drag(Sandbox sandbox, float x, float y) {
        int parts = (int) Math.min(1 + Math.hypot(x - lastX, y - lastY) / reach, 1000);
        for (int k = 1; k <= parts; k++) {
            float share = (float) k / parts;
            erase(sandbox, lastX + (x - lastX) * share, lastY + (y - lastY) * share);
        }
        lastX = x;
        lastY = y;
    }

    private void erase(Sandbox sandbox, float x, float y) {
        World world = sandbox.world();
        long body = sandbox.bodyAt(x, y);
        if (body != 0) {
            world.bodies().remove(body);
        }
        int count = world.queries().overlapCircle(x, y, reach, found);
        if (count > found.length) {
            found = new long[2 * count];
            world.queries().overlapCircle(x, y, reach, found);
        }
        world.removeAll(found, count, StaleHandles.REFUSE);
        int pieces = Math.min(world.queries().terrain().overlapCircle(x, y, reach, found), found.length);
        for (int k = 0; k < pieces; k++) {
            world.terrain().remove(found[k]);
        }
    }

    @Override
    public void release(Sandbox sandbox) {}

    @Override
    public float reach(Grain grain) {
        return REACH * grain.radius();
    }
}
