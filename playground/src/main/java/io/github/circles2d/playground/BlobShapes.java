package io.github.circles2d.playground;

import io.github.circles2d.JointedCircles;
import io.github.circles2d.World;
import java.nio.FloatBuffer;

/**
 * Soft bodies that are drawn filled. Their circles have tags, which go with a world into files: the number of the body, and a mark. The
 * circles of a body are around its outline, in the order of their ids.
 */
final class BlobShapes {
    /** In the upper half of a tag. */
    private static final long MARK = 0x424C4F42L << Integer.SIZE;

    private long[] tags = new long[0];
    private int ids;
    private int count;

    /** Tags the circles of a body, which stand around it in their order. */
    static void tag(World world, JointedCircles body, int number) {
        for (long circle : body.circles()) {
            world.setTag(circle, MARK | number);
        }
    }

    /** Reads which circles are of bodies. */
    void read(World world) {
        ids = world.idLimit();
        if (tags.length < ids) {
            tags = new long[ids + (ids >> 1)];
        }
        world.readTagsById(tags, null);
        count = 0;
        for (int id = 0; id < ids; id++) {
            count += isOfBody(id) ? 1 : 0;
        }
    }

    private boolean isOfBody(int id) {
        return id < ids && tags[id] >>> Integer.SIZE == MARK >>> Integer.SIZE;
    }

    /** Whether there is a body. */
    boolean any() {
        return count > 0;
    }

    /** Whether two circles are of one body. */
    boolean join(int id, int other) {
        return isOfBody(id) && other < ids && tags[id] == tags[other];
    }

    /** Fills the bodies of a frame, where their circles are between two steps. */
    void show(Polygons into, FloatBuffer positions, float[] circles) {
        into.clear();
        for (int id = 0; id < ids; id++) {
            if (isOfBody(id)) {
                if (into.count() == 0 || into.colour(into.count() - 1) != colour(id)) {
                    into.begin(colour(id));
                }
                boolean between = 2 * id < positions.limit() && positions.get(2 * id) == positions.get(2 * id);
                into.add(
                        between ? positions.get(2 * id) : circles[4 * id],
                        between ? positions.get(2 * id + 1) : circles[4 * id + 1]);
            }
        }
    }

    /** Bodies that follow each other differ. */
    private int colour(int id) {
        return Shades.tint((int) tags[id]);
    }
}
