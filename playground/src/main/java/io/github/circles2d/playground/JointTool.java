package io.github.circles2d.playground;

import io.github.circles2d.Joint;
import io.github.circles2d.Ropes;
import io.github.circles2d.World;
import java.util.List;

/** Joins what is where the button goes down to what is where it goes up: circles, terrain or places. */
final class JointTool implements Tool {
    /** What joins two ends. */
    interface Link {
        void join(Sandbox sandbox, End from, End to);
    }

    /** One spring, which is as long as it is. */
    static final Link SPRING = (sandbox, from, to) -> End.join(sandbox.world(), from, to, Joint.spring(2, 0.2f));

    /** Small circles in a row; between ends that nothing moves it is a bridge. */
    static final Link ROPE = JointTool::rope;

    /** Of a link, in radii of a circle. */
    private static final float LENGTH = 1.6f;

    private static final float THICKNESS = 0.5f;
    private static final int MOST_LINKS = 200;

    private final Link link;
    private End from;
    private float mouseX;
    private float mouseY;

    JointTool(Link link) {
        this.link = link;
    }

    @Override
    public void press(Sandbox sandbox, float x, float y, float brush) {
        drag(sandbox, x, y);
        from = End.at(sandbox, mouseX, mouseY);
    }

    @Override
    public void drag(Sandbox sandbox, float x, float y) {
        Arena arena = Arena.of(sandbox.world());
        mouseX = Math.min(Math.max(x, arena.minX()), arena.maxX());
        mouseY = Math.min(Math.max(y, arena.minY()), arena.maxY());
    }

    @Override
    public void release(Sandbox sandbox) {
        End begun = from;
        from = null;
        if (begun != null && begun.exists(sandbox.world())) {
            End to = End.at(sandbox, mouseX, mouseY);
            if (begun.circle() == 0 || begun.circle() != to.circle()) {
                link.join(sandbox, begun, to);
            }
        }
    }

    @Override
    public void forget() {
        from = null;
    }

    @Override
    public void mark(Sandbox sandbox, List<Mark> marks) {
        World world = sandbox.world();
        if (from == null || !from.exists(world)) {
            return;
        }
        float x = from.worldX(world);
        float y = from.worldY(world);
        if (from.circle() != 0) {
            marks.add(Mark.ring(x, y, world.radius(from.circle()), 1));
        }
        marks.add(Mark.line(x, y, mouseX, mouseY));
    }

    private static void rope(Sandbox sandbox, End from, End to) {
        World world = sandbox.world();
        float unit = sandbox.grain().radius();
        double length = Math.hypot(to.worldX(world) - from.worldX(world), to.worldY(world) - from.worldY(world));
        int circles = (int) Math.min(length / (LENGTH * unit), MOST_LINKS) - 1;
        if (circles < 1 || world.size() + circles > PourTool.GREATEST_WORLD) {
            return;
        }
        float radius = Arena.of(world).radius(THICKNESS * unit);
        float mass = sandbox.grain().mass(radius);
        if (from.isLoose(world) || to.isLoose(world)) {
            Ropes.rope(world, from.ofRope(), to.ofRope(), circles, radius, mass, 0);
        } else {
            Ropes.bridge(world, from.ofRope(), to.ofRope(), circles, radius, mass, 0);
        }
    }
}
