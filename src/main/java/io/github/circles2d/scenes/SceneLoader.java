package io.github.circles2d.scenes;

import java.util.function.IntConsumer;

/**
 * Loads scenes: it hands the numbers of a scene to whatever takes them, a World or another engine whose calls are like those of
 * World, as method references.
 *
 * <pre>{@code
 * World.Builder builder = World.builder();
 * SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
 * World world = builder.build();
 * SceneLoader.circles(scene, world::add, world::setRestitution);
 * }</pre>
 */
public final class SceneLoader {
    private SceneLoader() {}

    /** Takes the walls. */
    @FunctionalInterface
    public interface Bounds {
        /**
         * Takes the walls.
         *
         * @param minX left wall
         * @param minY lower wall
         * @param maxX right wall
         * @param maxY upper wall
         */
        void set(float minX, float minY, float maxX, float maxY);
    }

    /** Takes gravity. */
    @FunctionalInterface
    public interface Gravity {
        /**
         * Takes gravity.
         *
         * @param x acceleration
         * @param y acceleration, negative downwards
         */
        void set(float x, float y);
    }

    /** Takes the restitution that new circles get. */
    @FunctionalInterface
    public interface Restitution {
        /**
         * Takes the restitution that new circles get.
         *
         * @param restitution 0 to 1
         */
        void set(float restitution);
    }

    /** Takes circles. */
    @FunctionalInterface
    public interface Circles {
        /**
         * Takes a circle.
         *
         * @param x x of the centre
         * @param y y of the centre
         * @param radius radius
         * @param mass mass; positive infinity for a static circle
         * @param vx velocity
         * @param vy velocity
         * @return its handle
         */
        long add(float x, float y, float radius, float mass, float vx, float vy);
    }

    /** Takes the restitution of a circle that has another than the scene. */
    @FunctionalInterface
    public interface CircleRestitution {
        /**
         * Takes the restitution of a circle.
         *
         * @param handle the circle
         * @param restitution 0 to 1
         */
        void set(long handle, float restitution);
    }

    /**
     * Hands over what a scene has besides circles.
     *
     * @param scene the scene
     * @param bounds takes the walls
     * @param gravity takes gravity
     * @param restitution takes the scene's restitution
     * @param capacity takes the number of circles to come
     */
    public static void parameters(
            Scene scene, Bounds bounds, Gravity gravity, Restitution restitution, IntConsumer capacity) {
        bounds.set(scene.minX(), scene.minY(), scene.maxX(), scene.maxY());
        gravity.set(scene.gravityX(), scene.gravityY());
        restitution.set(scene.restitution());
        capacity.accept(scene.size());
    }

    /**
     * Hands over a scene's circles, in the scene's order.
     *
     * @param scene the scene
     * @param circles takes each circle, which then has the scene's restitution
     * @param restitution takes the restitution of each circle that has another
     */
    public static void circles(Scene scene, Circles circles, CircleRestitution restitution) {
        for (int i = 0; i < scene.size(); i++) {
            float mass = scene.fixed(i) ? Float.POSITIVE_INFINITY : scene.mass(i);
            long handle = circles.add(scene.x(i), scene.y(i), scene.radius(i), mass, scene.vx(i), scene.vy(i));
            if (scene.restitution(i) != scene.restitution()) {
                restitution.set(handle, scene.restitution(i));
            }
        }
    }
}
