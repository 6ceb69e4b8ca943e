package io.github.circles2d.fuzz;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;

/** The methods that programs call, by topic. */
abstract class Table {
    static final List<Entry> ALL = all();

    private static final int[] UP_TO = sums();

    final List<Entry> entries = new ArrayList<>();

    private static List<Entry> all() {
        List<Entry> all = new ArrayList<>();
        for (Table table : List.of(
                new CircleTable(),
                new WorldTable(),
                new ReadTable(),
                new QueryTable(),
                new TerrainTable(),
                new JointTable(),
                new NetTable(),
                new BodiesTable(),
                new LoopTable())) {
            all.addAll(table.entries);
        }
        return all;
    }

    private static int[] sums() {
        int[] weights = ALL.stream().mapToInt(Entry::weight).toArray();
        Arrays.parallelPrefix(weights, Integer::sum);
        return weights;
    }

    /** Draws a call of any method, by the weights. */
    static Line draw(Draw draw) {
        Entry entry;
        do {
            int at = Arrays.binarySearch(UP_TO, draw.below(UP_TO[UP_TO.length - 1]) + 1);
            entry = ALL.get(at < 0 ? -at - 1 : at);
        } while (!draw.setting.mayHave(entry));
        return entry.draw(draw);
    }

    /** Draws a call of a certain method. */
    static Line draw(Draw draw, Class<?> of, String name, int parameters) {
        return ALL.stream()
                .filter(entry -> entry.method().getDeclaringClass() == of
                        && entry.method().getName().equals(name)
                        && entry.parameters().length == parameters)
                .findFirst()
                .orElseThrow()
                .draw(draw);
    }

    /** Declares a method of a class. */
    void call(int weight, Function<Draw, Value> receiver, Class<?> of, String name, Drawn... parameters) {
        Class<?>[] types = Arrays.stream(parameters).map(Drawn::type).toArray(Class<?>[]::new);
        try {
            entries.add(new Entry(weight, of.getMethod(name, types), receiver, parameters));
        } catch (NoSuchMethodException e) {
            throw new IllegalStateException(e);
        }
    }

    /** The receiver that each world has one of. */
    static Function<Draw, Value> own(String text, Function<Player, Object> object) {
        return draw -> new Values.Own(text, object);
    }
}
