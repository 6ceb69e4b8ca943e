package io.github.circles2d.playground;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Bodies;
import io.github.circles2d.Outline;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;

/** Stages of bodies that are pushed. */
final class BodyStages {
    private BodyStages() {}

    /** Crates among balls: light ones float, heavy ones sink. */
    static void crates(World world) {
        world.terrain().addSegment(40, 0, 20, 45, 0.8f, 0);
        world.terrain().addSegment(120, 0, 140, 45, 0.8f, 0);
        Stages.heap(world, 38, 1, 122, 44, 0.8f, 1.2f, 41);
        Outline crate = Outline.box(9, 9);
        for (int k = 0; k < 6; k++) {
            float density = k % 3 == 0 ? 0.1f : k % 3 == 1 ? 0.32f : 1.5f;
            world.bodies().add(crate, 50 + 12 * k, 60 + 4 * (k % 2), 0.3f * k, density * crate.area());
        }
    }

    /** Rows of dominoes, and a ball that rolls into the first. */
    static void dominoes(World world) {
        Bodies bodies = world.bodies();
        Outline domino = Outline.box(1.2f, 9);
        for (int floor = 0; floor < 3; floor++) {
            float y = 6 + 30 * floor;
            boolean right = floor % 2 == 0;
            if (floor > 0) {
                world.terrain().addSegment(right ? 8 : 20, y - 0.8f, right ? 140 : 152, y - 0.8f, 0.8f, 0);
            } else {
                world.terrain().addSegment(0, y - 0.8f, 160, y - 0.8f, 0.8f, 0);
            }
            for (int k = 0; k < 22; k++) {
                float x = right ? 26 + 5 * k : 134 - 5 * k;
                bodies.add(domino, x, y + 4.5f, 0, 0.4f * domino.area());
            }
        }
        world.add(12, 71, 3, 9, 30, 0);
    }

    /** A plank on a wedge; what falls on one end throws what is on the other. */
    static void seeSaw(World world) {
        Bodies bodies = world.bodies();
        for (int k = 0; k < 3; k++) {
            float x = 30 + 50 * k;
            world.terrain().addArc(x, 0, 7, 0, (float) Math.PI, ArcSide.OUTER);
            Outline plank = Outline.box(40, 1.6f);
            bodies.add(plank, x, 7.8f, 0, 0.3f * plank.area());
            Outline crate = Outline.box(4, 4);
            bodies.add(crate, x - 17, 10.7f, 0, 0.2f * crate.area());
            world.add(x + 16, 60 + 15 * k, 4, 30);
        }
    }

    /** A tower of crates, and a heavy ball that is thrown at it. */
    static void tower(World world) {
        Bodies bodies = world.bodies();
        Outline crate = Outline.box(6, 6);
        for (int row = 0; row < 12; row++) {
            for (int k = 0; k < 12 - row; k++) {
                bodies.add(crate, 80 + 6.2f * k + 3.1f * row, 3 + 6 * row, 0, 0.3f * crate.area());
            }
        }
        world.add(8, 30, 5, 300, 130, 22);
    }

    /** Shapes of all sorts in a drum that turns. */
    static void shapes(World world) {
        TerrainBody drum = world.terrain().addBody(80, 50, 0);
        drum.addArc(0, 0, 46, 0, 2 * (float) Math.PI, ArcSide.INNER);
        drum.setAngularVelocity(0.4f);
        Outline[] outlines = {
            Outline.box(6, 6),
            Outline.capsule(5, 2),
            Outline.polygon(0, 0, 7, 0, 3.5f, 6),
            Outline.polygon(-4, -4, 4, -4, 4, -1.5f, -1.5f, -1.5f, -1.5f, 4, -4, 4), // an L
            star(5, 2.6f),
            Outline.box(10, 2)
        };
        for (int row = 0; row < 6; row++) {
            for (int column = 0; column < 6; column++) {
                Outline one = outlines[(row + column) % outlines.length];
                world.bodies().add(one, 55 + 10 * column, 25 + 10 * row, 0.4f * (row * 6 + column), 0.3f * one.area());
            }
        }
    }

    private static Outline star(float outer, float inner) {
        float[] points = new float[20];
        for (int k = 0; k < 10; k++) {
            double angle = k * Math.PI / 5;
            float r = k % 2 == 0 ? outer : inner;
            points[2 * k] = r * (float) StrictMath.cos(angle);
            points[2 * k + 1] = r * (float) StrictMath.sin(angle);
        }
        return Outline.polygon(points);
    }
}
