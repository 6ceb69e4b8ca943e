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
    private final RigidThings things;

    /** The pairs of contacts without circles, in order. */
    RigidPair[] order = {};

    int count;

    /** The first pair with a circle; pairs with circles come last. */
    int firstWithCircle;

    /** Of the last step. */
    int colours;

    // while pairs are sorted by their hashes: those, and room for the same
    private RigidPair[] sorted = {};

    private RigidPair[] other = {};
    private final int[] starts = new int[1 << DIGIT_BITS];

    /** By colour: the number of pairs with less, then where the next one goes. */
    private int[] ofColour = new int[0];

    /** By thing: the colours that its pairs have. */
    private long[] taken = new long[0];

    RigidOrder(RigidContacts contacts, RigidThings things) {
        this.contacts = contacts;
        this.things = things;
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
        int n = contacts.pairCount;
        if (order.length < n) {
            order = new RigidPair[2 * n];
            sorted = new RigidPair[2 * n];
            other = new RigidPair[2 * n];
        }
        for (int t = 0; t < things.count; t++) {
            things.all[t].degree = 0;
        }
        count = 0;
        int most = 0;
        while (count < n && contacts.pairs[count].b.type != RigidStep.BODY_CIRCLE) {
            RigidPair pair = contacts.pairs[count];
            RigidThing a = pair.a;
            RigidThing b = pair.b;
            a.degree++;
            b.degree++;
            most = Math.max(most, Math.max(a.degree, b.w > 0f ? b.degree : 0));
            // ids, with the type: those of pieces and bodies are numbers of their own; so that signed numbers ascend
            pair.hash = hash(a.id, b.id + (b.type << 28)) ^ Integer.MIN_VALUE;
            sorted[count++] = pair;
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
            sorted[k].colour = least(words, sorted[k].a, sorted[k].b);
            colours = Math.max(colours, sorted[k].colour + 1);
        }
        byColours();
    }

    /** Sorts by a digit of the hashes; those that have the same stay as they lie. */
    private void sort(int shift) {
        int mask = starts.length - 1;
        Arrays.fill(starts, 0);
        for (int k = 0; k < count; k++) {
            starts[sorted[k].hash >>> shift & mask]++;
        }
        int sum = 0;
        for (int digit = 0; digit < starts.length; digit++) {
            int its = starts[digit];
            starts[digit] = sum;
            sum += its;
        }
        for (int k = 0; k < count; k++) {
            other[starts[sorted[k].hash >>> shift & mask]++] = sorted[k];
        }
        RigidPair[] kept = sorted;
        sorted = other;
        other = kept;
    }

    /** Whether a thing has pairs in the order. */
    static boolean isOrdered(RigidThing t) {
        return t.degree > 0;
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
            ofColour[contacts.pairs[p].colour + 1]++;
        }
        for (int c = 0; c < colours; c++) {
            ofColour[c + 1] += ofColour[c];
        }
        for (int p = 0; p < count; p++) {
            order[ofColour[contacts.pairs[p].colour]++] = contacts.pairs[p];
        }
    }

    /** The least colour that neither of two has which give way; both have it now. */
    private int least(int words, RigidThing a, RigidThing b) {
        int word = 0;
        while ((taken(words, word, a) | taken(words, word, b)) == -1L) {
            word++;
        }
        long bit = Long.lowestOneBit(~(taken(words, word, a) | taken(words, word, b)));
        take(words, word, a, bit);
        take(words, word, b, bit);
        return (word << BITS_LOG) + Long.numberOfTrailingZeros(bit);
    }

    private long taken(int words, int word, RigidThing t) {
        return t.gives() ? taken[words * t.number + word] : 0L;
    }

    private void take(int words, int word, RigidThing t, long bit) {
        if (t.gives()) {
            taken[words * t.number + word] |= bit;
        }
    }

    long bytes() {
        return 12L * order.length + 4L * (starts.length + ofColour.length) + 8L * taken.length;
    }
}
