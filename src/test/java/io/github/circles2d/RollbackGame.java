package io.github.circles2d;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;

/** A game whose frames change whatever a frame can change, and which writes down what became of those that are confirmed. */
class RollbackGame implements Rollback.Game {
    static final float STEP = 1 / 60f;
    static final int PLAYERS = 2;
    private static final int[] TYPES = {0, Events.BEGIN, Events.HIT | Events.WALL, 15};

    final World world;
    final List<String> frames = new ArrayList<>();

    /** By frame: what it has come to when it was last made. */
    private final List<String> made = new ArrayList<>();

    IntUnaryOperator random;
    private long points;
    private long last;
    private int[] extra = {};

    RollbackGame(Backend backend) {
        world = World.builder()
                .backend(backend)
                .bounds(0, 0, 20, 20)
                .gravity(0, -10)
                .restitution(0.6f)
                .build();
        for (int k = 0; k < 120; k++) {
            last = world.add(1 + k % 12 * 1.5f + 0.2f * (k / 12 % 2), 1 + 1.5f * (k / 12), 0.3f + 0.02f * (k % 9), 1);
            world.setKind(last, k % 4);
        }
        world.kind(3).setSensor(true);
        world.report(Events.BEGIN | Events.HIT | Events.END);
        world.report(0, 3, Events.BEGIN | Events.END);
    }

    /** The input of a player in a frame: nothing to do, most of the time. */
    static long input(int player, int frame) {
        long mixed = (frame / 3 + 1) * 0x9e3779b97f4a7c15L ^ (player + 7) * 0xbf58476d1ce4e5b9L;
        mixed = (mixed ^ mixed >>> 30) * 0x94d049bb133111ebL;
        mixed ^= mixed >>> 31;
        return (mixed & 3) == 0 ? mixed >>> 8 : 0;
    }

    @Override
    public void beforeStep(int frame, long[] inputs) {
        for (long input : inputs) {
            if (input != 0) {
                change((int) (input % 12), (int) (input >>> 8 & 0xff), frame);
            }
        }
    }

    private void change(int what, int number, int frame) {
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        long some = handles[number % handles.length];
        switch (what) {
            case 0 -> world.remove(some);
            case 1 -> last = world.add(2 + number % 16, 18, 0.4f, 2, 0, -5, number % 4);
            case 2 -> world.setVelocity(some, number % 30 - 15, 8);
            case 3 -> world.setGravity(number % 5 - 2, -8);
            case 4 -> world.report(TYPES[number % 4]);
            case 5 -> world.report(number % 4, number / 4 % 4, number / 16 % 8);
            case 6 -> world.reportWalls(number % 4, number / 4 % 8);
            case 7 -> world.setHitSpeed(number % 4);
            case 8 -> world.setKind(some, number / 32 % 4);
            case 9 -> world.explode(2 + number % 16, 3, 3, 6, 0);
            case 10 -> world.kind(number % 4).setDamping(number % 3);
            default -> extra = IntStream.rangeClosed(0, number).toArray();
        }
    }

    @Override
    public void afterStep(int frame, Events events) {
        StringBuilder line = new StringBuilder();
        for (int i = 0; i < events.size(); i++) {
            line.append(line(events, i));
            points += events.type(i);
            if (events.type(i) == Events.HIT && world.contains(events.a(i)) && random.applyAsInt(4) == 0) {
                world.applyImpulse(events.a(i), 0, 1);
            }
        }
        if (world.contains(last) && frame % 10 == 0) {
            world.setVelocity(last, random.applyAsInt(10), 5);
        }
        while (made.size() <= frame) {
            made.add(null);
        }
        made.set(frame, String.format("%016x %d %d %d %s", world.hash(), points, last, extra.length, line));
    }

    private static String line(Events events, int i) {
        return String.format(
                "[%d %d %x %x %s %s %s %s %s %s %s %s]",
                events.type(i),
                events.step(i),
                events.a(i),
                events.b(i),
                events.side(i),
                events.speed(i),
                events.slipSpeed(i),
                events.impulse(i),
                events.x(i),
                events.y(i),
                events.normalX(i),
                events.normalY(i));
    }

    @Override
    public void save(ByteBuffer to) {
        to.putLong(points).putLong(last).putInt(extra.length);
        for (int each : extra) {
            to.putInt(each);
        }
    }

    @Override
    public void restore(ByteBuffer from) {
        points = from.getLong();
        last = from.getLong();
        extra = new int[from.getInt()];
        for (int k = 0; k < extra.length; k++) {
            extra[k] = from.getInt();
        }
    }

    @Override
    public void confirmed(int frame, Events events) {
        StringBuilder line = new StringBuilder();
        for (int i = 0; i < events.size(); i++) {
            line.append(line(events, i));
        }
        frames.add(frame + ": " + made.get(frame) + " = " + line);
    }
}
