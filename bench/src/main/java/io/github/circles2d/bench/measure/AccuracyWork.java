package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.Table;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenClException;
import java.io.IOException;
import java.util.List;
import java.util.Map;

/** Counts the wrong slots of the computed indexing on a device: at some sizes, and the first size that has any. */
record AccuracyWork(String name, Device device, List<Integer> sizes, double maxSeconds, ResultsFolder folder)
        implements Work {
    /** Value of column n for the row that tells the first wrong size. */
    static final String FIRST = "first wrong";

    /** Up to this n the engine's collision buffer fits everywhere, so that its own count can be asked for. */
    private static final int LARGEST_CHECKED = 15_000;

    @Override
    public String label() {
        return name + " index accuracy";
    }

    @Override
    public double seconds(Pace pace) {
        return maxSeconds;
    }

    @Override
    public String run(Pace pace, double secondsLeft) throws IOException {
        try (WrongSlots slots = new WrongSlots(device)) {
            for (int n : sizes) {
                long wrong = slots.count(n);
                if (n <= LARGEST_CHECKED && wrong != slots.countOfEngine(n)) {
                    throw new IllegalStateException("Circles2D counts " + slots.countOfEngine(n)
                            + " wrong slots at n = " + n + ", not " + wrong);
                }
                put(Integer.toString(n), n, Long.toString(wrong), "ok");
            }
            long end = System.nanoTime() + (long) (1e9 * Math.min(maxSeconds, secondsLeft));
            int n = 2;
            while (slots.count(n) == 0) {
                n++;
                if (System.nanoTime() > end || n > sizes.get(sizes.size() - 1)) {
                    put(FIRST, n - 1, "", "none up to " + (n - 1));
                    return "no wrong slot up to n = " + Numbers.whole(n - 1);
                }
            }
            put(FIRST, n, Long.toString(slots.count(n)), "ok");
            return "first wrong slot at n = " + Numbers.whole(n);
        } catch (OpenClException e) {
            put(FIRST, 2, "", "failed: " + e.getMessage());
            return "failed: " + e.getMessage();
        }
    }

    private void put(String key, int n, String wrong, String status) throws IOException {
        String slots = Long.toString(n * (n - 1L) / 2);
        Map<String, String> row =
                Table.columns("device", name, "n", key, "circles", Integer.toString(n), "slots", slots);
        row.putAll(Table.columns("wrong_slots", wrong, "status", status));
        folder.put(ResultsFolder.Kind.ACCURACY, row);
    }
}
