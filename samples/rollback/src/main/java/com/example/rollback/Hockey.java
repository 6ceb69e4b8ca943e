package com.example.rollback;

import io.github.circles2d.Backend;
import io.github.circles2d.Edge;
import io.github.circles2d.Events;
import io.github.circles2d.Rollback;
import io.github.circles2d.World;
import java.nio.ByteBuffer;

/** The rules, as one peer computes them: two players push pucks against each other's wall. A puck that is there starts again. */
final class Hockey implements Rollback.Game {
    static final int WIDTH = 600, HEIGHT = 400; // a length of 1 is a pixel, and y points down
    private static final int PUCK = 1, WINDOW = 10; // a kind, and frames that are predicted

    final World world;
    final Rollback rollback;
    final int[] points = new int[2]; // all that decides the game besides the world
    int events;
    long hash; // both of all confirmed frames
    private final long[] players, hashes = new long[WINDOW];

    Hockey(Backend backend) {
        World.Builder builder = World.builder().bounds(0, 0, WIDTH, HEIGHT).edges(Edge.WALL, Edge.WRAP);
        world = builder.restitution(0.9f).backend(backend).build();
        world.reportWalls(PUCK, Events.BEGIN);
        players = new long[] {world.add(WIDTH / 4, HEIGHT / 2, 20, 8), world.add(WIDTH * 3 / 4, HEIGHT / 2, 20, 8)};
        for (int k = 0; k < 16; k++) {
            world.add(WIDTH / 2 + k % 2, 25 * k, 10, 1, 0, 0, PUCK);
        }
        rollback = new Rollback(world, this, 1 / 60f, 2, WINDOW);
    }

    /** An input is where a player wants to be: x in the upper half, and y in the lower. */
    @Override
    public void beforeStep(int frame, long[] inputs) {
        for (int side = 0; side < 2; side++) {
            float x = (inputs[side] >> 32) - world.x(players[side]), y = (int) inputs[side] - world.y(players[side]);
            world.setVelocity(players[side], 5 * x, 5 * y);
        }
    }

    @Override
    public void afterStep(int frame, Events events) {
        for (int i = 0; i < events.size(); i++) {
            points[events.side(i) == Events.Side.LEFT ? 1 : 0]++;
            world.remove(events.a(i)); // if a prediction was wrong, it comes back, and the point goes
            world.add(WIDTH / 2, rollback.randomInt(HEIGHT), 10, 1, 0, 0, PUCK);
        }
        hashes[frame % WINDOW] = 31 * (31 * world.hash() + points[0]) + points[1];
    }

    @Override
    public void save(ByteBuffer to) {
        to.putInt(points[0]).putInt(points[1]);
    }

    @Override
    public void restore(ByteBuffer from) {
        points[0] = from.getInt();
        points[1] = from.getInt();
    }

    @Override
    public void confirmed(int frame, Events ofFrame) {
        events += ofFrame.size(); // a game with sounds plays them here
        hash = 31 * hash + hashes[frame % WINDOW];
    }
}
