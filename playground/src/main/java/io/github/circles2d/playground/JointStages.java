package io.github.circles2d.playground;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Blobs;
import io.github.circles2d.Joint;
import io.github.circles2d.JointedCircles;
import io.github.circles2d.Joints;
import io.github.circles2d.Ropes;
import io.github.circles2d.World;

/** Stages of circles that joints hold together. */
final class JointStages {
    private JointStages() {}

    /** A bridge between two cliffs, and balls that roll onto it. */
    static void bridge(World world) {
        Stages.wall(world, 2, 60, 33, 52);
        Stages.wall(world, 158, 60, 127, 52);
        Ropes.bridge(world, Ropes.at(32, 50), Ropes.at(128, 50), 40, 1, 1.5f, 0);
        Stages.heap(world, 4, 64, 28, 90, 0.9f, 1.3f, 31);
        Stages.heap(world, 132, 64, 156, 90, 0.9f, 1.3f, 32);
        world.add(60, 70, 4, 24);
        Stages.heap(world, 30, 2, 130, 8, 0.9f, 1.3f, 33);
    }

    /** Soft rings fall down a stair of pegs. */
    static void blobs(World world) {
        for (int row = 0; row < 3; row++) {
            for (int x = 16 + 16 * (row % 2); x < 156; x += 32) {
                world.terrain().addArc(x, 20 + 17 * row, 3, 0, 2 * (float) Math.PI, ArcSide.OUTER);
            }
        }
        int count = 24;
        float side = 2 * 5.5f * (float) StrictMath.sin(Math.PI / count); // from circle to circle
        for (int k = 0; k < 14; k++) {
            float y = 76 + 15 * (k / 7);
            JointedCircles blob = Blobs.ring(world, 14 + 22 * (k % 7), y, 5.5f, count, 0.45f * side, 0.4f, 10, 0.7f);
            for (int skin = 0; skin < count; skin++) { // nothing slips between its circles
                world.joints().setLimits(blob.joints()[skin], side, side);
            }
            BlobShapes.tag(world, blob, k);
        }
    }

    /** A curtain that tears where it is pulled too hard, and two balls to throw. */
    static void cloth(World world) {
        int columns = 36;
        int rows = 20;
        float spacing = 2.4f;
        Joints joints = world.joints();
        JointedCircles cloth = Blobs.cloth(world, 80, 73, columns, rows, spacing, 0.6f, 0.1f, 20, 0.7f);
        for (long thread : cloth.joints()) {
            joints.setBreaking(thread, 1_200, Float.POSITIVE_INFINITY);
        }
        for (int k = 0; k < columns; k += 5) {
            long hook = cloth.circles()[columns * (rows - 1) + k];
            joints.add(hook, world.x(hook), world.y(hook), Joint.pin());
        }
        world.add(16, 20, 6, 40);
        world.add(144, 20, 6, 40);
    }

    /** A heavy ball on a chain swings into a wall of balls. */
    static void wreckingBall(World world) {
        long ball = world.add(16, 90, 7, 150);
        Ropes.rope(world, Ropes.at(68, 90), Ropes.circle(ball), 18, 0.9f, 1, 0);
        for (int column = 0; column < 14; column++) {
            for (int row = 0; row < 16; row++) {
                world.add(90 + 3 * column + (row % 2 == 0 ? 0 : 1.5f), 1.5f + 2.61f * row, 1.5f, 2.25f);
            }
        }
        Stages.wall(world, 86, 0, 86, 8);
    }
}
