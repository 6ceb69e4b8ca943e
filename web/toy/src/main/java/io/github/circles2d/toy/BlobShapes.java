package io.github.circles2d.toy;

import io.github.circles2d.JointedCircles;
import io.github.circles2d.World;
import org.teavm.jso.typedarrays.Float32Array;

/**
 * Soft bodies that are drawn filled. Their circles have tags as those of the playground, which go with a world into files: the number of the
 * body, and a mark. The circles of a body are around its outline, in the order of their ids.
 */
final class BlobShapes {
    /** In the upper half of a tag. */
    private static final long MARK = 0x424C4F42L << Integer.SIZE;

    /** Numbers a point: x, y, and the number of its body. */
    private static final int STRIDE = 3;

    private long[] tags = new long[0];
    private int ids;

    /** Tags the circles of a body, which stand around it in their order. */
    static void tag(World world, JointedCircles body, int number) {
        for (long circle : body.circles()) {
            world.setTag(circle, MARK | number);
        }
    }

    /** The outlines, one behind the other. Bodies that follow each other have other numbers. */
    Float32Array of(World world) {
        ids = world.joints().size() == 0 ? 0 : world.idLimit(); // joints hold bodies together
        if (tags.length < ids) {
            tags = new long[ids + ids / 2];
        }
        if (ids > 0) {
            world.readTagsById(tags, null);
        }
        int count = 0;
        for (int id = 0; id < ids; id++) {
            count += isOfBody(id) ? 1 : 0;
        }
        Float32Array points = new Float32Array(STRIDE * count);
        int at = 0;
        for (int id = 0; id < ids && at < STRIDE * count; id++) {
            if (isOfBody(id)) {
                long circle = world.handle(id);
                points.set(at++, world.x(circle));
                points.set(at++, world.y(circle));
                points.set(at++, (int) tags[id]);
            }
        }
        return points;
    }

    /** Whether two circles are of one body. */
    boolean join(int id, int other) {
        return isOfBody(id) && other < ids && tags[id] == tags[other];
    }

    private boolean isOfBody(int id) {
        return id < ids && tags[id] >>> Integer.SIZE == MARK >>> Integer.SIZE;
    }
}
