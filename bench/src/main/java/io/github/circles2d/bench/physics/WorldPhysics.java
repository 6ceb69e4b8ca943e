package io.github.circles2d.bench.physics;

import io.github.circles2d.Backend;
import io.github.circles2d.World;

/** This library's engine on one back end. */
record WorldPhysics(Backend backend, int threads) implements Physics {
    @Override
    public String name() {
        return "World";
    }

    @Override
    public Arena open(Setup setup) {
        return new WorldArena(World.builder()
                .bounds(setup.minX(), setup.minY(), setup.maxX(), setup.maxY())
                .gravity(0, -setup.gravity())
                .restitution(setup.restitution())
                .subSteps(setup.subSteps())
                .backend(backend)
                .threads(threads)
                .build());
    }
}
