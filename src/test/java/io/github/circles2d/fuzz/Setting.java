package io.github.circles2d.fuzz;

import io.github.circles2d.Bodies;
import io.github.circles2d.Edge;
import io.github.circles2d.Wall;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** What the world of a program is built with, and from which ranges its calls have their values. */
final class Setting {
    private static final float[] FILLS = {0.05f, 0.2f, 0.5f, 0.8f, 1.3f};
    private static final int[] RATIOS = {1, 1, 3, 10, 100, 1000};

    final float minX;
    final float minY;
    final float maxX;
    final float maxY;

    /** The length of the arena. */
    final float size;

    /** The least radius, the ratio of the greatest one to it, and the greatest speed. */
    final float radius;

    final int ratio;
    final float speed;

    /** Whether values may be out of their ranges. */
    final boolean hostile;

    /** Whether some things are far away from the others. */
    final boolean far;

    /** Whether everything is reported at first. */
    final boolean reports;

    /** How many circles there are at first. */
    final int circles;

    /** Whether circles fall asleep. */
    final boolean sleeps;

    /** Whether there may be bodies that are pushed. */
    final boolean bodies;

    final boolean recorded;

    /** Of a recording, and of a rewind and a rollback. */
    final int hashEvery;

    final int frames;

    /** 0: the default capacity; 1: none; 2: another one in each world. */
    final int capacities;

    /** The calls of the builder: a name and arguments each. */
    final List<Object[]> calls = new ArrayList<>();

    Setting(Random random) {
        hostile = random.nextInt(3) > 0;
        far = random.nextInt(5) == 0;
        reports = random.nextInt(2) == 0;
        size = random.nextInt(6) == 0 ? (float) StrictMath.pow(10, random.nextInt(13) - 4) : 100;
        float off = random.nextInt(6) == 0 ? (2 * random.nextFloat() - 1) * size * 100 : 0;
        off = Math.abs(off) > 4e8f ? 0 : off;
        float aspect = random.nextInt(4) == 0 ? 0.05f + 0.95f * random.nextFloat() : 1;
        minX = off;
        minY = random.nextInt(5) == 0 ? 0f - off : off;
        maxX = minX + size;
        maxY = minY + size * aspect;
        ratio = RATIOS[random.nextInt(RATIOS.length)];
        circles = random.nextInt(12) == 0 ? 200 + random.nextInt(1000) : 1 + random.nextInt(120);
        float fill = FILLS[random.nextInt(FILLS.length)];
        float usual = (float) Math.sqrt(fill * size * size * aspect / circles / Math.PI);
        float most = Math.min(maxX - minX, maxY - minY) / 24;
        radius = Math.min(usual, most) / (ratio > 10 ? ratio / 10f : 1);
        speed = Math.min(
                1e9f,
                switch (random.nextInt(6)) {
                    case 0 -> size * 60;
                    case 1 -> 1e9f;
                    default -> size;
                });
        recorded = random.nextInt(3) == 0;
        hashEvery = 1 + random.nextInt(4);
        frames = 2 + random.nextInt(7);
        capacities = random.nextInt(3);
        call("bounds", minX, minY, maxX, maxY);
        call("edges", edge(random), edge(random));
        drawGravity(random);
        drawContacts(random);
        drawSurfaces(random);
        sleeps = random.nextInt(3) == 0;
        if (sleeps) {
            call("sleep", true);
        }
        call("moving", circles % 2 == 0); // no word on back ends that are named
        bodies = random.nextInt(3) == 0;
    }

    /** Whether programs of such a world make a call. */
    boolean mayHave(Entry entry) {
        Method method = entry.method();
        boolean adds =
                method.getDeclaringClass() == Bodies.class && method.getName().startsWith("add");
        return bodies || !adds;
    }

    private static Edge edge(Random random) {
        return random.nextInt(2) == 0 ? Edge.WALL : Edge.values()[random.nextInt(3)];
    }

    private void drawGravity(Random random) {
        float g = Math.min(
                1e9f,
                switch (random.nextInt(6)) {
                    case 0 -> 0;
                    case 1 -> 1e6f;
                    case 2 -> size * 100;
                    default -> size / 10;
                });
        call("gravity", random.nextInt(3) == 0 ? g / 3 : 0f, -g);
    }

    private void drawContacts(Random random) {
        call("restitution", random.nextInt(4) == 0 ? 1f : random.nextFloat());
        call("subSteps", random.nextInt(3) == 0 ? 1 + random.nextInt(16) : 4);
        switch (random.nextInt(16)) {
            case 0 -> call("restitutionThreshold", 0f);
            case 1 -> call("contactFrequency", 10_000f);
            case 2 -> call("contactDamping", 0f);
            case 3 -> call("greatestPushOutSpeed", Math.min(size, 100));
            case 5 -> call("profiling", true);
            default -> {}
        }
    }

    private void drawSurfaces(Random random) {
        int surfaces = random.nextInt(5);
        if (surfaces > 2) {
            call("friction", 2 * random.nextFloat());
        }
        if (surfaces == 4) {
            call("rollingResistance", 0.2f * random.nextFloat());
            call("wallSurface", Wall.values()[random.nextInt(4)], 1f, 0.01f, 10 * random.nextFloat() - 5);
        }
    }

    private void call(Object... nameAndArguments) {
        calls.add(nameAndArguments);
    }

    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("World.builder()");
        for (Object[] call : calls) {
            text.append('.').append(call[0]).append('(');
            for (int k = 1; k < call.length; k++) {
                text.append(k == 1 ? "" : ", ").append(Text.of(call[k]));
            }
            text.append(')');
        }
        return text + "; capacities " + capacities + ", rewind and rollback of " + frames + " frames"
                + (recorded ? ", recorded, a hash every " + hashEvery : "");
    }
}
