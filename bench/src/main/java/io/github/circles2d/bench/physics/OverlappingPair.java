package io.github.circles2d.bench.physics;

/** Two elastic circles that overlap without gravity. */
final class OverlappingPair {
    private static final double RADIUS = 1;
    private static final double CENTRES = 0.2;

    /** Less counts as apart: piles at rest overlap as much. */
    private static final double TOUCHING = 0.005;

    private OverlappingPair() {}

    static Row parts() {
        return Row.of(
                16,
                "two elastic circles without gravity, r = 1, centres 0.2 apart",
                parts("relative speed 0", 0),
                parts("parting at 1e-6 m/s", 1e-6),
                parts("parting at 1e-3 m/s", 1e-3),
                parts("closing at 1e-6 m/s", -1e-6),
                parts("closing at 1e-3 m/s", -1e-3));
    }

    private static Case parts(String name, double speed) {
        return Case.fixed(
                        name,
                        (physics, effort) -> run(physics, speed),
                        Measure.atMost("overlap after 1 s, r", TOUCHING),
                        Measure.atMost("relative speed gained after 2 s, r/s", 0.01),
                        Measure.shown("greatest relative speed on the way, r/s"))
                .holds();
    }

    private static double[] run(Physics physics, double speed) {
        Setup setup = Setup.around(50, 50).withRestitution(1);
        try (Arena arena = physics.open(setup)) {
            arena.add(-CENTRES / 2, 0, RADIUS, Scenery.mass(RADIUS), -speed / 2, 0);
            arena.add(CENTRES / 2, 0, RADIUS, Scenery.mass(RADIUS), speed / 2, 0);
            double overlap = 0;
            double greatest = 0;
            for (int step = 1; step <= 2 * Scenery.SECOND; step++) {
                arena.step(1);
                State state = arena.state();
                greatest = Math.max(greatest, relativeSpeed(state));
                if (step == Scenery.SECOND) {
                    overlap = Math.max(state.overlap(0, 1), 0);
                }
            }
            double gained = Math.max(relativeSpeed(arena.state()) - Math.abs(speed), 0);
            return new double[] {overlap / RADIUS, gained / RADIUS, greatest / RADIUS};
        }
    }

    private static double relativeSpeed(State state) {
        return Math.hypot(state.vx[1] - state.vx[0], state.vy[1] - state.vy[0]);
    }
}
