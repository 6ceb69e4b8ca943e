package io.github.circles2d.fuzz;

import static io.github.circles2d.fuzz.Drawn.filled;
import static io.github.circles2d.fuzz.Drawn.living;
import static io.github.circles2d.fuzz.Drawn.number;
import static io.github.circles2d.fuzz.Drawn.real;
import static io.github.circles2d.fuzz.Drawn.whole;

import io.github.circles2d.FixedStep;
import io.github.circles2d.Recording;
import io.github.circles2d.Rewind;
import io.github.circles2d.Rollback;
import io.github.circles2d.Terrain;
import io.github.circles2d.TerrainBody;

/** Game loops, rewinds, rollbacks and recordings. */
final class LoopTable extends Table {
    private static final int FRAMES = 12;

    LoopTable() {
        fixedStep();
        rewind();
        rollback();
        for (String name : new String[] {"steps", "bytes", "hasFailed"}) {
            call(1, own("recording", player -> player.recording), Recording.class, name);
        }
    }

    private void fixedStep() {
        loop(14, "advance", real(0, 0.06f), new Drawn(Runnable.class, LoopTable::beforeStep));
        loop(1, "setMaxSteps", whole(draw -> draw.count(4)));
        loop(1, "setSpeed", real(0, 2));
        loop(2, "reset");
        loop(2, "alpha");
        loop(2, "droppedSteps");
        loop(4, "positions", living());
        loop(3, "radii");
        loop(3, "angles");
        String pieces = "world.terrain().size()";
        loop(
                4,
                "pieces",
                filled(
                        float[].class,
                        "PIECE_STRIDE * " + pieces,
                        p -> Terrain.PIECE_STRIDE * p.world.terrain().size()),
                filled(long[].class, pieces, player -> player.world.terrain().size()));
        loop(3, "pose", new Drawn(TerrainBody.class, Drawn::body), filled(float[].class, "3", player -> 3));
        loop(
                4,
                "jointEnds",
                filled(
                        float[].class,
                        "4 * world.joints().size()",
                        player -> 4 * player.world.joints().size()),
                filled(long[].class, "world.joints().size()", player -> player.world
                        .joints()
                        .size()));
    }

    private void loop(int weight, String name, Drawn... parameters) {
        call(weight, own("fixedStep", player -> player.fixedStep), FixedStep.class, name, parameters);
    }

    /** Null, or a push of the first circle. */
    private static Value beforeStep(Draw draw) {
        float push = draw.plain(-100, 100);
        return draw.oneOf(2)
                ? new Values.Constant(null)
                : new Values.Own("() -> push(" + Text.of(push) + ")", player -> (Runnable) () -> push(player, push));
    }

    private static void push(Player player, float by) {
        long handle = player.world.idLimit() == 0 ? 0 : player.world.handle(0);
        if (handle != 0) {
            player.world.applyImpulse(handle, by, 1);
        }
    }

    private void rewind() {
        Drawn frame = whole(draw -> draw.below(FRAMES));
        rewind(10, "save", frame);
        rewind(12, "restore", frame);
        rewind(1, "clear");
        rewind(1, "has", frame);
        rewind(1, "size");
        rewind(1, "oldest");
        rewind(1, "newest");
        rewind(1, "bytes");
    }

    private void rewind(int weight, String name, Drawn... parameters) {
        call(weight, own("rewind", player -> player.rewind), Rewind.class, name, parameters);
    }

    private void rollback() {
        rollback(12, "advance");
        rollback(8, "setInput", whole(draw -> draw.below(2)), whole(draw -> draw.below(FRAMES)), number());
        rollback(4, "reconcile");
        rollback(1, "frame");
        rollback(1, "confirmedFrames");
        rollback(1, "canAdvance");
        rollback(1, "rollbacks");
        rollback(1, "repeatedFrames");
        rollback(1, "bytes");
        rollback(1, "seed", number());
        rollback(1, "randomLong");
        rollback(1, "randomInt", whole(draw -> draw.count(9)));
        rollback(1, "randomFloat");
    }

    private void rollback(int weight, String name, Drawn... parameters) {
        call(weight, own("rollback", player -> player.rollback), Rollback.class, name, parameters);
    }
}
