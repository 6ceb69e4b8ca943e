package io.github.circles2d.playground;

import java.util.ArrayList;
import java.util.List;

/** An explosion at each click, and a ring that runs out from it. */
final class ExplodeTool implements Tool {
    private static final float REACH = 18;

    /** Part of the reach in which the whole impulse acts. */
    private static final float CORE = 0.25f;

    /** Of the speed that is high in the world, for a circle of usual mass. */
    private static final float SPEED = 2;

    private static final int FRAMES = 24;

    private record Blast(float x, float y, float reach, int age) {}

    private final List<Blast> blasts = new ArrayList<>();

    @Override
    public void press(Sandbox sandbox, float x, float y, float brush) {
        Grain grain = sandbox.grain();
        float reach = reach(grain) * brush;
        float impulse = SPEED * grain.highSpeed() * grain.mass(grain.radius());
        sandbox.world().explode(x, y, CORE * reach, impulse, (1 - CORE) * reach);
        blasts.add(new Blast(x, y, reach, 0));
    }

    @Override
    public void drag(Sandbox sandbox, float x, float y) {}

    @Override
    public void release(Sandbox sandbox) {}

    @Override
    public float reach(Grain grain) {
        return REACH * grain.radius();
    }

    @Override
    public void mark(Sandbox sandbox, List<Mark> marks) {
        for (Blast blast : blasts) {
            float part = (blast.age() + 1f) / FRAMES;
            marks.add(Mark.ring(blast.x(), blast.y(), blast.reach() * part * (2 - part), 1 - part));
        }
        blasts.replaceAll(blast -> new Blast(blast.x(), blast.y(), blast.reach(), blast.age() + 1));
        blasts.removeIf(blast -> blast.age() >= FRAMES);
    }
}
