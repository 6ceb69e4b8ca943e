package io.github.circles2d.playground;

import io.github.circles2d.World;

/** Static circles along the way of the mouse, so near to each other that nothing falls through. */
final class WallTool implements Tool {
    private static final double PITCH = 1.1;

    private float lastX;
    private float lastY;
    private float radius;

    @Override
    public void press(Sandbox sandbox, float x, float y, float brush) {
        radius = Arena.of(sandbox.world()).radius(sandbox.grain().radius() * brush);
        lastX = x;
        lastY = y;
        add(sandbox.world(), x, y);
    }

    @Override
    public void drag(Sandbox sandbox, float x, float y) {
        double pitch = PITCH * radius;
        double length = Math.hypot(x - lastX, y - lastY);
        int count = (int) Math.min(length / pitch, 10_000);
        float fromX = lastX;
        float fromY = lastY;
        for (int k = 1; k <= count; k++) {
            lastX = (float) (fromX + (x - fromX) * (k * pitch / length));
            lastY = (float) (fromY + (y - fromY) * (k * pitch / length));
            add(sandbox.world(), lastX, lastY);
        }
    }

    private void add(World world, float x, float y) {
        if (Arena.of(world).contains(x, y) && world.size() < PourTool.GREATEST_WORLD) {
            world.add(x, y, radius, Float.POSITIVE_INFINITY);
        }
    }

    @Override
    public void release(Sandbox sandbox) {}

    @Override
    public float reach(Grain grain) {
        return grain.radius();
    }
}
