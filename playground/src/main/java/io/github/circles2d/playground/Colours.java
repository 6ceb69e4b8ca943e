package io.github.circles2d.playground;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** The few colours that stand for all colours of some pictures, found by cutting the box of colours at medians (Heckbert, 1982). */
final class Colours {
    /** Bits of red, green and blue that tell two colours apart. */
    private static final int BITS = 5;

    private static final int CELLS = 1 << 3 * BITS;

    private final int[] palette;
    private final byte[] nearest = new byte[CELLS];

    private Colours(int[] palette) {
        this.palette = palette;
        for (int cell = 0; cell < CELLS; cell++) {
            nearest[cell] = (byte) search(colour(cell));
        }
    }

    /** Colours for pictures of which each has these pixels. */
    static Colours of(List<int[]> pictures, int count) {
        long[] weight = new long[CELLS];
        for (int[] pixels : pictures) {
            for (int pixel : pixels) {
                weight[cell(pixel)]++;
            }
        }
        List<int[]> boxes = new ArrayList<>();
        boxes.add(IntStream.range(0, CELLS).filter(cell -> weight[cell] > 0).toArray());
        while (boxes.size() < count) {
            int[] widest = boxes.stream()
                    .filter(box -> box.length > 1)
                    .max(Comparator.comparingDouble(box -> span(box) * Math.sqrt(sum(box, weight))))
                    .orElse(null);
            if (widest == null) {
                break;
            }
            boxes.remove(widest);
            int[] sorted = sorted(widest);
            int cut = median(sorted, weight);
            boxes.add(Arrays.copyOfRange(sorted, 0, cut));
            boxes.add(Arrays.copyOfRange(sorted, cut, sorted.length));
        }
        return new Colours(boxes.stream().mapToInt(box -> mean(box, weight)).toArray());
    }

    /** 0xRRGGBB by number. */
    int[] palette() {
        return palette.clone();
    }

    /** The number of the colour that is nearest. */
    int number(int rgb) {
        return nearest[cell(rgb)] & 0xff;
    }

    private int search(int rgb) {
        int best = 0;
        long least = Long.MAX_VALUE;
        for (int k = 0; k < palette.length; k++) {
            long distance = 0;
            for (int shift = 0; shift <= 16; shift += 8) {
                long d = (rgb >> shift & 0xff) - (palette[k] >> shift & 0xff);
                distance += d * d;
            }
            if (distance < least) {
                least = distance;
                best = k;
            }
        }
        return best;
    }

    private static int cell(int rgb) {
        int drop = 8 - BITS;
        return (rgb >> 16 + drop & 31) << 2 * BITS | (rgb >> 8 + drop & 31) << BITS | rgb >> drop & 31;
    }

    private static int part(int cell, int channel) {
        return cell >> channel * BITS & 31;
    }

    /** The colour in the middle of a cell. */
    private static int colour(int cell) {
        return part(cell, 2) << 19 | part(cell, 1) << 11 | part(cell, 0) << 3 | 0x040404;
    }

    private static int extent(int[] box, int channel) {
        int least = 31;
        int most = 0;
        for (int cell : box) {
            least = Math.min(least, part(cell, channel));
            most = Math.max(most, part(cell, channel));
        }
        return most - least;
    }

    private static int longest(int[] box) {
        int best = 0;
        for (int channel = 1; channel < 3; channel++) {
            if (extent(box, channel) > extent(box, best)) {
                best = channel;
            }
        }
        return best;
    }

    private static int span(int[] box) {
        return extent(box, longest(box));
    }

    private static double sum(int[] box, long[] weight) {
        double sum = 0;
        for (int cell : box) {
            sum += weight[cell];
        }
        return sum;
    }

    private static int[] sorted(int[] box) {
        int channel = longest(box);
        return Arrays.stream(box)
                .boxed()
                .sorted(Comparator.comparingInt(cell -> part(cell, channel)))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    private static int median(int[] sorted, long[] weight) {
        double half = sum(sorted, weight) / 2;
        double passed = 0;
        for (int k = 0; k < sorted.length - 1; k++) {
            passed += weight[sorted[k]];
            if (passed >= half) {
                return k + 1;
            }
        }
        return sorted.length - 1;
    }

    private static int mean(int[] box, long[] weight) {
        double all = sum(box, weight);
        int mean = 0;
        for (int channel = 0; channel < 3; channel++) {
            double sum = 0;
            for (int cell : box) {
                sum += (colour(cell) >> 8 * channel & 0xff) * (double) weight[cell];
            }
            mean |= (int) Math.round(sum / all) << 8 * channel;
        }
        return mean;
    }
}
