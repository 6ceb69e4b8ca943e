package com.example.swarm;

import io.github.circles2d.Backend;
import io.github.circles2d.Events;
import io.github.circles2d.Queries;
import io.github.circles2d.Response;
import io.github.circles2d.Rewind;
import io.github.circles2d.StaleHandles;
import io.github.circles2d.World;
import java.nio.FloatBuffer;
import java.util.ArrayDeque;
import java.util.Deque;

/**
 * The rules of the game: 5,000 chasers hunt the player, who shoots, bombs and turns back time. All that changes is in the world: the
 * score is the player's tag, its health is its radius, and the tag of a chaser is what it is worth. So what rewinds the world rewinds
 * the game.
 */
final class Swarm implements Runnable, AutoCloseable {
    static final float WIDTH = 160;
    static final float HEIGHT = 100;
    static final float TIME_STEP = 1 / 60f;
    static final int MOST_CIRCLES = 6000;
    static final float HEALTHY = 1.8f; // radii of the player
    static final float DEAD = 0.6f;
    static final int BOMB_PRICE = 50; // points
    static final float BOMB_RADIUS = 6;

    private static final int CHASERS = 5000;
    private static final int PLAYER = 0; // kinds
    private static final int CHASER = 1;
    private static final int BULLET = 2;
    private static final float BULLET_SPEED = 70;
    private static final int STEPS_PER_SAVE = 4;

    final World world;
    final Controls controls = new Controls();
    final Deque<Explosion> explosions = new ArrayDeque<>();
    final long player;

    private final Queries queries;
    private final Rewind rewind;
    private final long[] handles = new long[MOST_CIRCLES];
    private final float[] impulses = new float[2 * MOST_CIRCLES];
    private int step;

    Swarm(Backend backend) {
        world = World.builder()
                .bounds(0, 0, WIDTH, HEIGHT)
                .backend(backend)
                .capacity(MOST_CIRCLES)
                .build();
        world.report(Events.BEGIN | Events.WALL);
        world.kind(PLAYER).setDamping(4);
        world.kind(CHASER).setDamping(1).setGreatestSpeed(30);
        world.setResponse(BULLET, BULLET, Response.IGNORE);
        world.setResponse(BULLET, PLAYER, Response.IGNORE);
        queries = world.queries();
        rewind = new Rewind(world, 600 / STEPS_PER_SAVE); // ten seconds

        player = world.add(WIDTH / 2, HEIGHT / 2, HEALTHY, 20);
        for (int k = 1; k <= CHASERS; k++) {
            addChaser(k, spread(k, 0.7548776662) * WIDTH, spread(k, 0.5698402910) * HEIGHT);
        }
        clearPlaceForPlayer();
    }

    private void clearPlaceForPlayer() {
        int near = queries.overlapCircle(WIDTH / 2, HEIGHT / 2, 22, handles);
        System.arraycopy(handles, 1, handles, 0, near - 1); // the player, who was added first, comes first
        world.removeAll(handles, near - 1, StaleHandles.REFUSE);
    }

    long score() {
        return world.tag(player);
    }

    float health() {
        return world.radius(player);
    }

    boolean isOver() {
        return health() <= DEAD;
    }

    int step() {
        return step;
    }

    /** What comes before each step of the world. */
    @Override
    public void run() {
        judge(world.events()); // before it is saved: to go back drops the events
        if (step % STEPS_PER_SAVE == 0) {
            rewind.save(step);
        }
        movePlayer();
        if (controls.bomb) {
            controls.bomb = false;
            bomb();
        }
        chase();
        for (int k = 2 * step; k < 2 * step + 2 && world.size() < CHASERS; k++) {
            addChaser(k, spread(k, 0.7548776662) * WIDTH, k % 2 * HEIGHT);
        }
        step++;
    }

    /** Goes back to the frame that was saved before this one, if it is still there. */
    void rewind() {
        int back = (step - 1) / STEPS_PER_SAVE * STEPS_PER_SAVE;
        if (step > 0 && rewind.has(back)) {
            rewind.restore(back);
            step = back;
            explosions.removeIf(explosion -> explosion.step >= back);
        }
    }

    /** A chaser of fifty is large, and has points for ten. */
    private void addChaser(int number, float x, float y) {
        boolean large = number % 50 == 0;
        long chaser = world.add(x, y, large ? 1.2f : 0.4f, 1, 0, 0, CHASER);
        world.setTag(chaser, large ? 10 : 1);
    }

    /** Numbers that are spread evenly from 0 to 1, in an order that looks random. */
    private static float spread(int k, double ratio) {
        return (float) (k * ratio % 1);
    }

    /** Bullets are what has no points. */
    boolean isBullet(long circle) {
        return circle != player && world.tag(circle) == 0;
    }

    private void judge(Events events) {
        for (int i = 0; i < events.size(); i++) {
            long a = events.a(i);
            long b = events.b(i);
            boolean wall = events.side(i) != null;
            if (!world.contains(a) || !wall && !world.contains(b)) {
                continue; // an event before this one has removed it
            }
            if (isBullet(a)) {
                shoot(a, b);
            } else if (!wall && isBullet(b)) {
                shoot(b, a);
            } else if (!wall && a == player) {
                bite(b);
            }
        }
    }

    private void shoot(long bullet, long chaser) {
        world.remove(bullet);
        if (chaser != 0) {
            kill(chaser);
            world.setRadius(player, Math.min(HEALTHY, health() + 0.002f));
        }
    }

    private void kill(long chaser) {
        long points = world.tag(chaser);
        explode(world.x(chaser), world.y(chaser), points == 1 ? 0.5f : BOMB_RADIUS / 2);
        world.setTag(player, score() + points);
        world.remove(chaser);
    }

    private void bite(long chaser) {
        world.setRadius(player, Math.max(DEAD, health() - 0.02f * world.tag(chaser)));
        kill(chaser);
        explode(world.x(player), world.y(player), BOMB_RADIUS); // throws back those behind it
    }

    /** A picture of an explosion; the game does not depend on it. */
    record Explosion(float x, float y, float radius, int step) {}

    private void explode(float x, float y, float radius) {
        world.explode(x, y, radius, 5 * radius, radius);
        explosions.add(new Explosion(x, y, radius, step));
        if (explosions.size() > 300) {
            explosions.remove();
        }
    }

    /** Bombs the chaser that is nearest to the mouse, with all around it. */
    private void bomb() {
        long target = target();
        if (target == 0 || score() < BOMB_PRICE) {
            return;
        }
        world.setTag(player, score() - BOMB_PRICE);
        float x = world.x(target);
        float y = world.y(target);
        int hit = queries.overlapCircle(x, y, BOMB_RADIUS, handles);
        for (int k = 0; k < hit; k++) {
            if (handles[k] != player && !isBullet(handles[k])) {
                kill(handles[k]);
            }
        }
        explode(x, y, BOMB_RADIUS);
    }

    /** The chaser that is nearest to the mouse, or 0. */
    long target() {
        long[] nearest = new long[1];
        int found = queries.nearest(controls.aimX, controls.aimY, 3, 1, nearest, null);
        return found == 0 || nearest[0] == player || isBullet(nearest[0]) ? 0 : nearest[0];
    }

    private void movePlayer() {
        world.setForce(player, 2000 * controls.moveX, 2000 * controls.moveY);
        if (controls.fire && step % 3 == 0) {
            float x = world.x(player);
            float y = world.y(player);
            float dx = controls.aimX - x;
            float dy = controls.aimY - y;
            float scale = BULLET_SPEED / (float) Math.sqrt(dx * dx + dy * dy + 1e-6f);
            world.add(x, y, 0.3f, 0.1f, scale * dx, scale * dy, BULLET);
        }
    }

    /** All chasers speed up towards the player, and to its left, in one call. */
    private void chase() {
        float playerX = world.x(player);
        float playerY = world.y(player);
        FloatBuffer positions = world.positions();
        world.readHandles(handles);
        int chasers = 0;
        for (int k = 0; k < world.size(); k++) {
            if (handles[k] == player || isBullet(handles[k])) {
                continue;
            }
            float dx = playerX - positions.get(2 * k);
            float dy = playerY - positions.get(2 * k + 1);
            float scale = 8 * TIME_STEP / (float) Math.sqrt(dx * dx + dy * dy + 1e-6f);
            impulses[2 * chasers] = scale * (dx + dy);
            impulses[2 * chasers + 1] = scale * (dy - dx);
            handles[chasers++] = handles[k];
        }
        world.applyImpulses(handles, chasers, impulses, StaleHandles.REFUSE);
    }

    @Override
    public void close() {
        world.close();
    }
}
