package io.github.circles2d.fuzz;

import static io.github.circles2d.WorldScenes.snapshot;

import io.github.circles2d.Joint;
import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import java.nio.ByteBuffer;

/** Makes worlds ready for all that programs may need of a device. */
@FunctionalInterface
interface Ready {
    /** Leaves a world as it is, so that a device compiles kernels when the world begins to need them. */
    Ready AS_NEEDED = world -> {};

    /**
     * Has a world restore one with all features, and then itself. So worlds share kernels, which a driver takes long to compile.
     */
    Ready FOR_ALL = world -> {
        ByteBuffer own = snapshot(world);
        try (World all = WorldScenes.jvm()
                .threads(1)
                .friction(0.5f)
                .greatestPushOutSpeed(7)
                .build()) {
            long one = all.add(0.2f, 0.5f, 0.1f, 1);
            all.setAngularVelocity(one, 1);
            all.joints().add(one, 0.2f, 0.6f, Joint.pin());
            all.terrain().addSegment(0, 0.1f, 1, 0.1f, 0, 0);
            all.step(0.01f);
            world.restore(snapshot(all));
        }
        world.restore(own);
    };

    /** Makes a world ready. */
    void make(World world);
}
