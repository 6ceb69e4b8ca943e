package io.github.circles2d.playground;

import io.github.circles2d.Joint;
import io.github.circles2d.Ropes;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;

/**
 * What a joint holds at a place.
 *
 * @param circle the circle there; 0 if there is none
 * @param body   else the body of terrain there, to which x and y belong then; null for the world
 * @param x      where it is: a circle is held by its centre
 * @param y      likewise
 */
record End(long circle, TerrainBody body, float x, float y) {
    /** How many radii beside a circle or a piece a click may be. */
    private static final float NEAR = 1.5f;

    static End at(Sandbox sandbox, float x, float y) {
        World world = sandbox.world();
        long[] found = {world.queries().pick(x, y)};
        if (found[0] == 0) {
            world.queries().nearest(x, y, NEAR * sandbox.grain().radius(), 1, found, null);
        }
        return found[0] != 0 ? new End(found[0], null, world.x(found[0]), world.y(found[0])) : ofGround(sandbox, x, y);
    }

    /** The same, whatever circles are there. */
    static End ofGround(Sandbox sandbox, float x, float y) {
        World world = sandbox.world();
        long piece = world.queries().terrain().pick(x, y, NEAR * sandbox.grain().radius());
        TerrainBody body = piece == 0 ? null : world.terrain().bodyOf(piece);
        if (body == null || body == world.terrain().ground()) {
            return new End(0, null, x, y);
        }
        double cos = Math.cos(body.angle());
        double sin = Math.sin(body.angle());
        double dx = (double) x - body.x();
        double dy = (double) y - body.y();
        return new End(0, body, (float) (cos * dx + sin * dy), (float) (cos * dy - sin * dx));
    }

    /** Whether it is still there: a world that goes back in time may lose it. */
    boolean exists(World world) {
        return circle != 0 ? world.contains(circle) : body == null || body.exists();
    }

    float worldX(World world) {
        return circle != 0
                ? world.x(circle)
                : body == null ? x : (float) (body.x() + Math.cos(body.angle()) * x - Math.sin(body.angle()) * y);
    }

    float worldY(World world) {
        return circle != 0
                ? world.y(circle)
                : body == null ? y : (float) (body.y() + Math.sin(body.angle()) * x + Math.cos(body.angle()) * y);
    }

    /** Whether a joint can move it. */
    boolean isLoose(World world) {
        return circle != 0 && world.mass(circle) < Float.POSITIVE_INFINITY;
    }

    Ropes.End ofRope() {
        return circle != 0 ? Ropes.circle(circle) : body != null ? Ropes.on(body, x, y) : Ropes.at(x, y);
    }

    /** Joins two ends; false if nothing could move, or if both are one circle. */
    static boolean join(World world, End from, End to, Joint joint) {
        End first = from.isLoose(world) ? from : to;
        End second = first == from ? to : from;
        if (!first.isLoose(world) || first.circle == second.circle) {
            return false;
        }
        if (second.circle != 0) {
            world.joints().add(first.circle, second.circle, joint);
        } else if (second.body != null) {
            world.joints().add(first.circle, second.body, second.x, second.y, joint);
        } else {
            world.joints().add(first.circle, second.x, second.y, joint);
        }
        return true;
    }
}
