package io.github.circles2d.bench.physics;

import com.badlogic.gdx.utils.GdxNativesLoader;

/**
 * libGDX's binding of Box2D 2.3.1 (C++): no friction, rotation locked, no sleeping, one step with 8 velocity and 3
 * position iterations as its manual advises. Its constants are left alone, so slower impacts than 1 m/s do not bounce, and
 * nothing moves farther than 2 m in a step.
 */
record Box2dPhysics() implements Physics {
    /** World's number of sub-steps that a step of Box2D is compared with. */
    private static final int SUB_STEPS = 4;

    static {
        // A game's backend does this; there is none here.
        GdxNativesLoader.load();
    }

    @Override
    public String name() {
        return "Box2D";
    }

    @Override
    public Arena open(Setup setup) {
        if (setup.subSteps() != SUB_STEPS) {
            throw new UnsupportedOperationException(
                    "Box2D has no sub-steps, and World has " + setup.subSteps() + " here");
        }
        return new Box2dArena(setup);
    }
}
