package io.github.circles2d.playground;

import io.github.circles2d.Joints;

/** Removes the joints that the way of the mouse crosses or comes near. */
final class CutTool implements Tool {
    private float reach;
    private float lastX;
    private float lastY;

    @Override
    public void press(Sandbox sandbox, float x, float y, float brush) {
        reach = reach(sandbox.grain()) * brush;
        lastX = x;
        lastY = y;
        cut(sandbox, x, y);
    }

    @Override
    public void drag(Sandbox sandbox, float x, float y) {
        int parts = (int) Math.min(1 + Math.hypot(x - lastX, y - lastY) / reach, 1000);
        for (int k = 1; k <= parts; k++) {
            float share = (float) k / parts;
            cut(sandbox, lastX + (x - lastX) * share, lastY + (y - lastY) * share);
        }
        lastX = x;
        lastY = y;
    }

    private void cut(Sandbox sandbox, float x, float y) {
        Joints joints = sandbox.world().joints();
        for (long found = joints.pick(x, y, reach); found != 0; found = joints.pick(x, y, reach)) {
            joints.remove(found);
        }
    }

    @Override
    public void release(Sandbox sandbox) {}

    @Override
    public float reach(Grain grain) {
        return 0.7f * grain.radius();
    }
}
