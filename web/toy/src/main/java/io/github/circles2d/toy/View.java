package io.github.circles2d.toy;

import io.github.circles2d.Edge;
import io.github.circles2d.Terrain;
import io.github.circles2d.World;

/**
 * The part of a world that the page shows: all between its edges, and along an axis that is open all that is there at first.
 *
 * @param minX the least x
 * @param minY the least y
 * @param maxX the greatest x
 * @param maxY the greatest y
 */
record View(float minX, float minY, float maxX, float maxY) {
    static View of(World world) {
        View bounds = new View(world.minX(), world.minY(), world.maxX(), world.maxY());
        if (world.edgeX() != Edge.OPEN && world.edgeY() != Edge.OPEN) {
            return bounds;
        }
        View all = around(world);
        boolean openX = world.edgeX() == Edge.OPEN && all.minX < all.maxX;
        boolean openY = world.edgeY() == Edge.OPEN && all.minY < all.maxY;
        return new View(
                openX ? all.minX : bounds.minX,
                openY ? all.minY : bounds.minY,
                openX ? all.maxX : bounds.maxX,
                openY ? all.maxY : bounds.maxY);
    }

    /** The same view after walls may have moved. */
    View now(World world) {
        boolean openX = world.edgeX() == Edge.OPEN;
        boolean openY = world.edgeY() == Edge.OPEN;
        return new View(
                openX ? minX : world.minX(),
                openY ? minY : world.minY(),
                openX ? maxX : world.maxX(),
                openY ? maxY : world.maxY());
    }

    /** All circles and terrain; turned around if there is nothing. */
    private static View around(World world) {
        float infinity = Float.POSITIVE_INFINITY;
        View all = new View(infinity, infinity, -infinity, -infinity);
        float[] circles = new float[4 * world.size()];
        world.read(circles);
        for (int k = 0; k < circles.length; k += 4) {
            all = all.with(circles[k], circles[k + 1], circles[k + 2]);
        }
        float[] pieces = new float[Terrain.PIECE_STRIDE * world.terrain().size()];
        world.terrain().readPieces(pieces, null);
        for (int k = 0; k < pieces.length; k += Terrain.PIECE_STRIDE) {
            if (pieces[k + Terrain.FORM] == Terrain.ARC) {
                all = all.with(pieces[k + Terrain.CENTRE_X], pieces[k + Terrain.CENTRE_Y], pieces[k + Terrain.RADIUS]);
            } else {
                all = all.with(pieces[k + Terrain.X1], pieces[k + Terrain.Y1], 0)
                        .with(pieces[k + Terrain.X2], pieces[k + Terrain.Y2], 0);
            }
        }
        return all;
    }

    private View with(float x, float y, float radius) {
        return new View(
                Math.min(minX, x - radius),
                Math.min(minY, y - radius),
                Math.max(maxX, x + radius),
                Math.max(maxY, y + radius));
    }

    boolean holds(float x, float y, float radius) {
        return x - radius > minX && x + radius < maxX && y - radius > minY && y + radius < maxY;
    }

    float nearestX(float x) {
        return Math.max(minX, Math.min(x, maxX));
    }

    float nearestY(float y) {
        return Math.max(minY, Math.min(y, maxY));
    }
}
