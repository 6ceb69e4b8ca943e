package io.github.circles2d.playground;

import io.github.circles2d.Outline;
import io.github.circles2d.World;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A body that is pushed, as the mouse draws it around: let go, it falls. A click alone gives a crate. */
final class BodyTool implements Tool {
    /** Between two corners, in radii of a circle; and how far a line may leave the way of the mouse. */
    private static final double LENGTH = 0.7;

    private static final double TOLERANCE = 0.25;

    /** Corners that an outline may have. */
    private static final int MOST = 200;

    private static final int MOST_BODIES = 5_000;

    /** Half of a crate's width, in radii of a circle. */
    private static final float CRATE = 1.8f;

    private final List<float[]> way = new ArrayList<>();
    private float radius;

    @Override
    public void press(Sandbox sandbox, float x, float y, float brush) {
        radius = Arena.of(sandbox.world()).radius(sandbox.grain().radius() * brush);
        way.clear();
        way.add(new float[] {x, y});
    }

    @Override
    public void drag(Sandbox sandbox, float x, float y) {
        if (!way.isEmpty() && way.size() < MOST && far(way.get(way.size() - 1), x, y)) {
            way.add(new float[] {x, y});
        }
    }

    private boolean far(float[] last, float x, float y) {
        return Math.hypot(x - last[0], y - last[1]) > LENGTH * radius;
    }

    @Override
    public void release(Sandbox sandbox) {
        World world = sandbox.world();
        List<float[]> drawn = List.copyOf(way);
        way.clear();
        if (drawn.isEmpty() || world.bodies().size() >= MOST_BODIES) {
            return;
        }
        float[] first = drawn.get(0);
        if (drawn.size() < 3) {
            add(sandbox, Outline.box(2 * CRATE * radius, 2 * CRATE * radius), first[0], first[1]);
            return;
        }
        float[] corners = new float[2 * drawn.size()];
        int count = 0;
        for (float[] corner : Simplified.of(drawn, TOLERANCE * radius)) {
            corners[count++] = corner[0];
            corners[count++] = corner[1];
        }
        Outline outline;
        try {
            outline = Outline.polygon(Arrays.copyOf(corners, count));
        } catch (IllegalArgumentException e) { // it crosses itself, or is too thin
            sandbox.say("no body: " + e.getMessage());
            return;
        }
        add(sandbox, outline, outline.centroidX(), outline.centroidY());
    }

    private void add(Sandbox sandbox, Outline outline, float x, float y) {
        Arena arena = Arena.of(sandbox.world());
        if (arena.contains(x, y)) {
            sandbox.world().bodies().add(outline, x, y, 0, sandbox.grain().massOf(outline.area()));
        }
    }

    @Override
    public void mark(Sandbox sandbox, List<Mark> marks) {
        for (int k = 1; k < way.size(); k++) {
            float[] from = way.get(k - 1);
            marks.add(Mark.line(from[0], from[1], way.get(k)[0], way.get(k)[1]));
        }
    }

    @Override
    public void forget() {
        way.clear();
    }

    @Override
    public float reach(Grain grain) {
        return CRATE * grain.radius();
    }
}
