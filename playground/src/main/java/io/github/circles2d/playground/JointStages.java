package io.github.circles2d.playground;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Joint;
import io.github.circles2d.Joints;
import io.github.circles2d.World;

/** Stages of circles that joints hold together. */
final class JointStages {
    private JointStages() {}

    /** A bridge between two cliffs, and balls that roll onto it. */
    static void bridge(World world) {
        Stages.wall(world, 2, 60, 33, 52);
        Stages.wall(world, 158, 60, 127, 52);
        Joints joints = world.joints();
        int planks = 40;
        float step = 96f / (planks + 1);
        long[] bridge = new long[planks];
        for (int k = 0; k < planks; k++) {
            bridge[k] = world.add(32 + step * (k + 1), 50, 1, 1.5f);
        }
        Joint link = Joint.distance(step);
        joints.add(bridge[0], 32, 50, link);
        joints.add(bridge[planks - 1], 128, 50, link);
        chain(joints, bridge, link);
        Stages.heap(world, 4, 64, 28, 90, 0.9f, 1.3f, 31);
        Stages.heap(world, 132, 64, 156, 90, 0.9f, 1.3f, 32);
        world.add(60, 70, 4, 24);
        Stages.heap(world, 30, 2, 130, 8, 0.9f, 1.3f, 33);
    }

    /** Soft rings fall down a stair of pegs. */
    static void blobs(World world) {
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 5; column++) {
                float x = 16 + 32 * column + 16 * (row % 2);
                if (x < 156) {
                    world.terrain().addArc(x, 20 + 17 * row, 3, 0, 2 * (float) Math.PI, ArcSide.OUTER);
                }
            }
        }
        for (int k = 0; k < 14; k++) {
            blob(world, 14 + 22 * (k % 7), 76 + 15 * (k / 7), 5.5f);
        }
    }

    private static void blob(World world, float x, float y, float radius) {
        int count = 24;
        long[] ring = new long[count];
        float own = 0.9f * radius * (float) Math.sin(Math.PI / count);
        for (int k = 0; k < count; k++) {
            double angle = 2 * Math.PI * k / count;
            ring[k] = world.add(
                    x + radius * (float) StrictMath.cos(angle),
                    y + radius * (float) StrictMath.sin(angle),
                    own,
                    own * own);
        }
        Joints joints = world.joints();
        Joint skin = Joint.spring(10, 0.7f);
        Joint across = Joint.spring(4, 0.7f);
        for (int k = 0; k < count; k++) {
            joints.add(ring[k], ring[(k + 1) % count], Joint.distance());
            joints.add(ring[k], ring[(k + 2) % count], skin);
            if (k < count / 2) {
                joints.add(ring[k], ring[k + count / 2], across);
            }
        }
    }

    /** A curtain that tears where it is pulled too hard, and a ball that swings into it. */
    static void cloth(World world) {
        int columns = 44;
        int rows = 24;
        float pitch = 2;
        Joints joints = world.joints();
        Joint thread = Joint.distance(pitch).breakingAt(1_200, Float.POSITIVE_INFINITY);
        long[] above = null;
        for (int row = 0; row < rows; row++) {
            long[] now = new long[columns];
            for (int k = 0; k < columns; k++) {
                now[k] = world.add(37 + pitch * k, 96 - pitch * row, 0.55f, 0.1f);
                if (above != null) {
                    joints.add(now[k], above[k], thread);
                } else if (k % 4 == 0 || k == columns - 1) {
                    joints.add(now[k], 37 + pitch * k, 96, Joint.pin());
                }
            }
            chain(joints, now, thread);
            above = now;
        }
        world.add(16, 20, 6, 40);
        world.add(144, 20, 6, 40);
    }

    /** A heavy ball on a chain, held up at the side of a wall of balls until the world begins. */
    static void wreckingBall(World world) {
        Joints joints = world.joints();
        int links = 18;
        long[] chain = new long[links + 1];
        for (int k = 0; k < links; k++) {
            chain[k] = world.add(68 - 2.4f * (k + 1), 90, 0.9f, 1);
        }
        chain[links] = world.add(68 - 2.4f * (links + 1) - 6, 90, 7, 150);
        Joint link = Joint.distance();
        joints.add(chain[0], 68, 90, link);
        chain(joints, chain, link);
        joints.add(chain[links], 68, 90, Joint.rope(2.4f * (links + 1) + 6)); // the chain does not stretch
        for (int column = 0; column < 14; column++) {
            for (int row = 0; row < 16; row++) {
                world.add(90 + 3 * column + (row % 2 == 0 ? 0 : 1.5f), 1.5f + 2.61f * row, 1.5f, 2.25f);
            }
        }
        Stages.wall(world, 86, 0, 86, 8);
    }

    /** Joins each circle to the next one. */
    private static void chain(Joints joints, long[] circles, Joint joint) {
        for (int k = 1; k < circles.length; k++) {
            joints.add(circles[k - 1], circles[k], joint);
        }
    }
}
