package io.github.circles2d.fuzz;

import io.github.circles2d.World;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Random;

/** A world's setting and calls, all of which follow from a seed. Its lines do not depend on what the calls give, so each can be left out. */
final class Program {
    private static final int FEWEST = 25;
    private static final int MOST = 130;

    /** Calls that build up the world, before any of all. */
    private static final int FIRST = 14;

    /** Changes that wait for the next step, in a world in which each call is made. */
    private static final int CHANGES = 3;

    final long seed;
    final Setting setting;
    final List<Line> lines = new ArrayList<>();

    /** The number of lines that build up the world. */
    final int built;

    Program(long seed) {
        this(seed, false);
    }

    /** A program that, once its world is built up, makes each call of the tables instead of any. */
    static Program ofEachCall(long seed) {
        return new Program(seed, true);
    }

    private Program(long seed, boolean each) {
        this.seed = seed;
        setting = new Setting(random(seed, 0));
        Draw draw = draw(1);
        if (setting.reports) {
            lines.add(reports(draw));
        }
        lines.add(crowd(draw));
        int first = draw.below(FIRST);
        for (int k = 0; k < first; k++) {
            lines.add(building(draw(2 + k)));
        }
        if (each) {
            lines.add(Table.draw(draw(100), World.class, "step", 2));
            for (String request : new String[] {"requestPositions", "requestEvents"}) {
                lines.add(Table.draw(draw(101), World.class, request, 0));
            }
            lines.add(Table.draw(draw(102), World.class, "step", 1));
            for (int k = 0; k < CHANGES; k++) {
                lines.add(building(draw(103 + k)));
            }
        }
        built = lines.size();
        if (each) {
            Table.ALL.stream().filter(setting::mayHave).forEach(entry -> lines.add(entry.draw(draw(lines.size()))));
            return;
        }
        int count = FEWEST + draw.below(MOST - FEWEST);
        for (int k = 0; k < count; k++) {
            lines.add(Table.draw(draw(1000 + k)));
        }
    }

    private Draw draw(int number) {
        return new Draw(random(seed, number), setting);
    }

    static Random random(long seed, int number) {
        Random random = new Random(seed * 0x9E3779B97F4A7C15L + number * 0xBF58476D1CE4E5B9L);
        random.nextInt(); // the first numbers of like seeds are alike
        return random;
    }

    private Line crowd(Draw draw) {
        Value[] crowd = CircleTable.crowd(draw, setting.circles);
        Line line = Table.draw(draw, World.class, "addAll", 4);
        Value[] arguments = {crowd[0], crowd[1], crowd[2], new Values.Constant(null)};
        return new Line(line.method(), line.receiver(), arguments, false);
    }

    /** Reports all that can be. */
    private static Line reports(Draw draw) {
        Line line = Table.draw(draw, World.class, "report", 1);
        return new Line(line.method(), line.receiver(), TerrainTable.values(15), false);
    }

    /** Something for circles to meet, or to be held by. */
    private static Line building(Draw draw) {
        Line line = Table.draw(draw);
        for (int k = 0; k < 100 && !line.method().getName().startsWith("add"); k++) {
            line = Table.draw(draw);
        }
        return line;
    }

    /** All lines. */
    BitSet all() {
        BitSet all = new BitSet();
        all.set(0, lines.size());
        return all;
    }

    /** The program with some of its lines, to read and to paste. */
    String text(BitSet kept) {
        StringBuilder text = new StringBuilder("seed " + seed + ": " + setting + "\n");
        kept.stream()
                .forEach(k -> text.append(k).append(": ").append(lines.get(k)).append('\n'));
        return text.toString();
    }
}
