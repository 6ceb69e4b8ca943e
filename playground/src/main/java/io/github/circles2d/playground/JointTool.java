package io.github.circles2d.playground;

import io.github.circles2d.Joint;
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

    /** Small circles in a row, and a joint from end to end that keeps them from stretching. */
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
        from = End.at(sandbox, x, y);
        drag(sandbox, x, y);
    }

    @Override
    public void drag(Sandbox sandbox, float x, float y) {
        mouseX = x;
        mouseY = y;
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
        Arena arena = Arena.of(world);
        float x = from.worldX(world);
        float y = from.worldY(world);
        float dx = to.worldX(world) - x;
        float dy = to.worldY(world) - y;
        float length = (float) Math.hypot(dx, dy);
        float unit = sandbox.grain().radius();
        int links = (int) Math.min(length / (LENGTH * unit), MOST_LINKS);
        if (links < 2 || world.size() + links > PourTool.GREATEST_WORLD || !arena.contains(x, y)) {
            return;
        }
        float radius = arena.radius(THICKNESS * unit);
        Joint joint = Joint.distance(length / links);
        End last = from;
        for (int k = 1; k < links; k++) {
            float share = (float) k / links;
            float linkX = Math.min(Math.max(x + share * dx, arena.minX()), arena.maxX());
            float linkY = Math.min(Math.max(y + share * dy, arena.minY()), arena.maxY());
            long circle = world.add(linkX, linkY, radius, sandbox.grain().mass(radius));
            End next = new End(circle, null, linkX, linkY);
            End.join(world, next, last, joint);
            last = next;
        }
        End.join(world, last, to, joint);
        End.join(world, from, to, Joint.rope(length));
    }
}
