package io.github.circles2d.bench.physics;

import io.github.circles2d.scenes.Scene;

/** What World did well before, and is to keep. */
final class Kept {
    private Kept() {}

    static Row today() {
        return Row.of(
                18,
                "what was good before: not worse by more than a tenth",
                kept(
                                "packed, 1,250: settled after 3,000 steps",
                                KeptPiles::packed,
                                "mean depth, r",
                                0,
                                "deepest pair, r",
                                0,
                                "creep in 3,000 more steps, r",
                                0.01)
                        .harnessOnly(),
                kept("column of 10 in a tube", (p, seed, e) -> KeptPiles.column(p, 10), "sag, r", 0.001),
                kept("column of 20 in a tube", (p, seed, e) -> KeptPiles.column(p, 20), "sag, r", 0.001),
                kept("column of 50 in a tube", (p, seed, e) -> KeptPiles.column(p, 50), "sag, r", 0.001),
                kept(
                        "piston of 1,000 masses on 200 circles",
                        KeptPiles::piston,
                        "mean depth, r",
                        0,
                        "deepest pair, r",
                        0),
                kept("Newton's cradle of 5, 10,000 steps", KeptEnergy::cradle, "energy lost or gained, share", 1e-3),
                kept("billiard break, e = 1, 2,000 steps", KeptEnergy::billiards, "energy lost or gained, share", 1e-4),
                kept(
                        "drops from 10 m, e = 0.5 to 1",
                        KeptEnergy::bounceHeights,
                        "greatest error of the height, share of the drop",
                        0.006),
                kept("gas of 2,000, 10,000 steps", KeptEnergy::gas, "energy lost or gained, share", 1e-4)
                        .harnessOnly(),
                kept(
                        "pile of 1,250, all lengths x 0.001",
                        (p, seed, e) -> KeptPiles.scaled(p, 0.001, seed),
                        "mean depth, r",
                        0),
                kept("pile of 1,250", (p, seed, e) -> KeptPiles.scaled(p, 1, seed), "mean depth, r", 0),
                kept(
                        "pile of 1,250, all lengths x 1,000",
                        (p, seed, e) -> KeptPiles.scaled(p, 1000, seed),
                        "mean depth, r",
                        0));
    }

    /** A case whose figures are bounded by the baseline; figures are pairs of a name and what is good enough. */
    private static Case kept(String name, Case.Run run, Object... figures) {
        Measure[] measures = new Measure[figures.length / 2];
        for (int i = 0; i < measures.length; i++) {
            double good = ((Number) figures[2 * i + 1]).doubleValue();
            measures[i] = Baseline.measure(name, (String) figures[2 * i], good);
        }
        return Case.random(name, run, measures).holds();
    }

    /** Fills an arena with one of the published scenes. */
    static Arena load(Scene scene, Physics physics) {
        Setup setup = new Setup(
                scene.minX(),
                scene.minY(),
                scene.maxX(),
                scene.maxY(),
                -scene.gravityY(),
                scene.restitution(),
                4,
                false);
        Arena arena = physics.open(setup);
        for (int i = 0; i < scene.size(); i++) {
            arena.add(scene.x(i), scene.y(i), scene.radius(i), scene.mass(i), scene.vx(i), scene.vy(i));
        }
        return arena;
    }
}
