package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.RigidStep;
import java.util.Arrays;

/**
 * In which order the pairs of a pass are visited: by colours, of which each body has one pair at most. Pairs choose the least colour that is free, in
 * the order of a hash of their ids, which spreads what lies side by side.
 */
final class RigidOrder {
    private static final int BITS_LOG = 6;

    /** Bits of a digit by which hashes are sorted. */
    private static final int DIGIT_BITS = 8;

    private final RigidContacts contacts;
    private final RigidPairs pairs;

    /** The pairs of contacts without circles, in order. */
    int[] order = new int[0];

    int count;

    /** The first pair with a circle; pairs with circles come last. */
    int firstWithCircle;

    /** Of the last step. */
    int colours;

    // while pairs are sorted: their hashes, so that signed numbers ascend, and their numbers; and room for the same
    private int[] hashes = new int[0];

    private int[] numbers = new int[0];
    private int[] otherHashes = new int[0];
    private int[] otherNumbers = new int[0];
    private final int[] starts = new int[1 << DIGIT_BITS];

    private int[] colour = new int[0];

    /** By colour: the number of pairs with less, then where the next one goes. */
    private int[] ofColour = new int[0];

    /** By thing: the number of its pairs, and the colours that they have. */
    private int[] degree = new int[0];

    private long[] taken = new long[0];

    RigidOrder(RigidContacts contacts, RigidPairs pairs) {
        this.contacts = contacts;
        this.pairs = pairs;
    }

    private static int hash(int a, int b) {
        int h = a * 0x9E3779B1 ^ b * 0x85EBCA77;
        h ^= h >>> 15;
        h *= 0x2C1B3C6D;
        h ^= h >>> 12;
        h *= 0x297A2D39;
        return h ^ h >>> 15;
    }

    void find() {
        RigidThings things = pairs.things;
        int n = contacts.pairCount;
        if (order.length < n) {
            order = new int[2 * n];
            hashes = new int[2 * n];
            numbers = new int[2 * n];
            otherHashes = new int[2 * n];
            otherNumbers = new int[2 * n];
            colour = new int[2 * n];
        }
        if (degree.length < things.count) {
            degree = new int[2 * things.count];
        }
        Arrays.fill(degree, 0, things.count, 0);
        count = 0;
        int most = 0;
        while (count < n && things.type[second(count)] != RigidStep.BODY_CIRCLE) {
            int a = first(count);
            int b = second(count);
            degree[a]++;
            degree[b]++;
            most = Math.max(most, Math.max(degree[a], things.w[b] > 0f ? degree[b] : 0));
            // ids, with the type: those of pieces and bodies are numbers of their own
            hashes[count] = hash(things.id[a], things.id[b] + (things.type[b] << 28)) ^ Integer.MIN_VALUE;
            numbers[count] = count;
            count++;
        }
        firstWithCircle = count;
        for (int shift = 0; shift < Integer.SIZE; shift += DIGIT_BITS) {
            sort(shift);
        }
        int words = (2 * most >> BITS_LOG) + 1;
        if (taken.length < words * things.count) {
            taken = new long[2 * words * things.count];
        }
        Arrays.fill(taken, 0, words * things.count, 0L);
        colours = 0;
        for (int k = 0; k < count; k++) {
            int p = numbers[k];
            int a = first(p);
            int b = second(p);
            colour[p] = least(words, things.gives(a), a, things.gives(b), b);
            colours = Math.max(colours, colour[p] + 1);
        }
        byColours();
    }

    /** Sorts the hashes by a digit; those that have the same stay as they lie. */
    private void sort(int shift) {
        int mask = starts.length - 1;
        Arrays.fill(starts, 0);
        for (int k = 0; k < count; k++) {
            starts[hashes[k] >>> shift & mask]++;
        }
        int sum = 0;
        for (int digit = 0; digit < starts.length; digit++) {
            int its = starts[digit];
            starts[digit] = sum;
            sum += its;
        }
        for (int k = 0; k < count; k++) {
            int to = starts[hashes[k] >>> shift & mask]++;
            otherHashes[to] = hashes[k];
            otherNumbers[to] = numbers[k];
        }
        int[] keptHashes = hashes;
        int[] keptNumbers = numbers;
        hashes = otherHashes;
        numbers = otherNumbers;
        otherHashes = keptHashes;
        otherNumbers = keptNumbers;
    }

    /** Whether a thing has pairs in the order. */
    boolean isOrdered(int t) {
        return degree[t] > 0;
    }

    /** Where the pairs of a colour begin in the order. */
    int begin(int itsColour) {
        return itsColour == 0 ? 0 : ofColour[itsColour - 1];
    }

    /** Where they end. */
    int end(int itsColour) {
        return ofColour[itsColour];
    }

    /** Sorts the pairs by colours, and those of one by their numbers. */
    private void byColours() {
        if (ofColour.length <= colours) {
            ofColour = new int[2 * (colours + 1)];
        }
        Arrays.fill(ofColour, 0, colours + 1, 0);
        for (int p = 0; p < count; p++) {
            ofColour[colour[p] + 1]++;
        }
        for (int c = 0; c < colours; c++) {
            ofColour[c + 1] += ofColour[c];
        }
        for (int p = 0; p < count; p++) {
            order[ofColour[colour[p]]++] = p;
        }
    }

    private int first(int p) {
        return pairs.a[contacts.pair[p]];
    }

    private int second(int p) {
        return pairs.b[contacts.pair[p]];
    }

    private int least(int words, boolean movesA, int a, boolean movesB, int b) {
        int word = 0;
        long free = free(words, word, movesA, a, movesB, b);
        while (free == 0L) {
            word++;
            free = free(words, word, movesA, a, movesB, b);
        }
        long bit = Long.lowestOneBit(free);
        if (movesA) {
            taken[words * a + word] |= bit;
        }
        if (movesB) {
            taken[words * b + word] |= bit;
        }
        return (word << BITS_LOG) + Long.numberOfTrailingZeros(bit);
    }

    private long free(int words, int word, boolean movesA, int a, boolean movesB, int b) {
        return ~((movesA ? taken[words * a + word] : 0L) | (movesB ? taken[words * b + word] : 0L));
    }

    long bytes() {
        return 24L * order.length + 4L * starts.length + 4L * (degree.length + ofColour.length) + 8L * taken.length;
    }
}
