package io.github.circles2d;

import io.github.circles2d.calibration.Crowd;
import io.github.circles2d.opencl.Device;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Calibrates this machine, and holds what AUTO takes against the times of all back ends, for crowds between those that a calibration
 * measures. Takes some minutes. Run by hand, since no test measures time.
 */
public final class CalibrationPicks {
    private static final int[] SIZES = {500, 1_700, 5_500, 17_000, 55_000};
    private static final double[] RATIOS = {1, 2, 5, 30};

    /** Of so many measurements the median counts. */
    private static final int ROUNDS = 3;

    private CalibrationPicks() {}

    public static void main(String[] args) throws Exception {
        Path file = Files.createTempDirectory("picks").resolve("calibration.txt");
        System.setProperty("circles2d.calibration", file.toString());
        long start = System.nanoTime();
        System.out.println(Calibration.run());
        System.out.printf("took %.0f s%n%n", (System.nanoTime() - start) / 1e9);
        FrameMeter meter = new FrameMeter();
        double worst = 1;
        for (double ratio : RATIOS) {
            for (int circles : SIZES) {
                worst = Math.max(worst, compare(meter, new Crowd(circles, Math.max(ratio, Crowd.LIKE))));
            }
        }
        System.out.printf("%nthe worst pick takes %.2f times as long as the best%n", worst);
    }

    /** Prints the times, and returns that of the pick over that of the best. */
    private static double compare(FrameMeter meter, Crowd crowd) {
        Map<String, Double> millis = new LinkedHashMap<>();
        millis.put("JVM", median(meter, Optional.empty(), crowd));
        for (Device device : Calibration.devices()) {
            if (OpenClChoice.isCandidate(device)) {
                millis.put(device.toString(), median(meter, Optional.of(device), crowd));
            }
        }
        String pick;
        World.Builder builder = World.builder()
                .capacity(crowd.circles())
                .radii(1, (float) crowd.ratio())
                .moving(false);
        try (World world = builder.build()) {
            WorldStats stats = world.stats();
            pick = stats.backend() == Backend.JVM ? "JVM" : stats.device();
        }
        double best = millis.values().stream().min(Double::compare).orElseThrow();
        double over = millis.get(pick) / best;
        System.out.printf("%6d of 1:%-4.3g %s, taken: %s, %.2f%n", crowd.circles(), crowd.ratio(), millis, pick, over);
        return over;
    }

    private static double median(FrameMeter meter, Optional<Device> device, Crowd crowd) {
        double[] millis = new double[ROUNDS];
        for (int round = 0; round < ROUNDS; round++) {
            millis[round] = meter.world(device, crowd).median();
        }
        return Arrays.stream(millis).sorted().toArray()[ROUNDS / 2];
    }
}
