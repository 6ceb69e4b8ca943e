package io.github.circles2d.playground;

import io.github.circles2d.Joint;
import io.github.circles2d.World;

/** Pins a circle to the place where it is: of the body of terrain there, or of the world. It may turn there. */
final class PinTool implements Tool {
    @Override
    public void press(Sandbox sandbox, float x, float y, float brush) {
        World world = sandbox.world();
        End circle = End.at(sandbox, x, y);
        if (circle.isLoose(world)) {
            End place = End.ofGround(sandbox, circle.x(), circle.y());
            End.join(world, circle, place, Joint.pin());
        }
    }

    @Override
    public void drag(Sandbox sandbox, float x, float y) {}

    @Override
    public void release(Sandbox sandbox) {}
}
