package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.RigidStep.BOTH;
import static io.github.circles2d.world.bodies.RigidStep.CORNER_ON_LINE;
import static io.github.circles2d.world.bodies.RigidStep.FEATURE;
import static io.github.circles2d.world.bodies.RigidStep.SWAPPED;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * The contacts of rigid bodies: a corner of one thing, A, and a line or corner of another, B. The normal points from B to A. A contact begins if the
 * corner is over the line, and the line's normal, reversed, is in the corner's cone; or if the way between two corners is in both cones.
 */
final class RigidContacts {
    /** Ints of a pair in {@link #foundPairs}: its number, the end of its contacts, and its contacts of the step before. */
    private static final int PAIR_STRIDE = 4;

    private final RigidPairs pairs;
    private final RigidThings things;
    private final Team team;
    final RigidMeasures measures;

    /** By worker. */
    private final RigidFeatures[] finders;

    /** By worker: the pairs that have contacts, by {@link #PAIR_STRIDE}. */
    private final int[][] foundPairs;

    private final int[] foundCount;

    // by piece of the work: its first pair and contact among those of its worker, and among all
    private int[] firstFound = new int[0];
    private int[] firstPair = new int[0];

    int count;

    /** Things: who has the corner, and the other. */
    int[] a = new int[0];

    int[] b = new int[0];

    /** As {@link RigidFeatures} has found them. */
    private int[] features = new int[0];

    /** The numbers of a contact, by {@link RigidRow}. */
    float[] rows = new float[0];

    /** By pair: its first contact; behind the last pair, the number of contacts. */
    int[] firstOf = new int[1];

    /** By pair that has contacts: its number in {@link RigidPairs}. */
    int[] pair = new int[0];

    int pairCount;

    private boolean[] used = new boolean[0];

    // within a step
    private RigidStep step;
    private StepConstants k;

    private final Team.Work findFeatures = this::findFeatures;
    private final Team.Work fill = this::fill;
    private final Team.Share keep = this::keep;

    RigidContacts(RigidPairs pairs, Team team) {
        this.pairs = pairs;
        this.team = team;
        things = pairs.things;
        measures = new RigidMeasures(this, things);
        finders = new RigidFeatures[team.most()];
        foundPairs = new int[team.most()][0];
        foundCount = new int[team.most()];
        for (int worker = 0; worker < finders.length; worker++) {
            finders[worker] = new RigidFeatures(pairs);
        }
    }

    // ---- finding

    /** Finds the contacts of all pairs, measures them, and gives them what they had. */
    void find(RigidStep bodies, StepConstants constants) {
        step = bodies;
        k = constants;
        measures.begin(k.h);
        int pieces = team.pieces();
        if (firstPair.length < 2 * (pieces + 1)) {
            firstFound = new int[2 * (pieces + 1)];
            firstPair = new int[2 * (pieces + 1)];
        }
        if (used.length < step.contacts) {
            used = new boolean[step.contactKeys.length / RigidStep.KEYS];
        }
        team.together(findFeatures);
        pairCount = 0;
        count = 0;
        for (int piece = 0; piece < pieces; piece++) {
            int itsPairs = firstPair[2 * piece];
            int itsContacts = firstPair[2 * piece + 1];
            firstPair[2 * piece] = pairCount;
            firstPair[2 * piece + 1] = count;
            pairCount += itsPairs;
            count += itsContacts;
        }
        if (pair.length < pairCount) {
            pair = new int[pairCount + (pairCount >> 1)];
            firstOf = new int[pair.length + 1];
        }
        grow(count);
        firstOf[pairCount] = count;
        team.together(fill);
    }

    private void findFeatures(int worker) {
        RigidFeatures finder = finders[worker];
        finder.begin(step, k.dt);
        foundCount[worker] = 0;
        for (int round = 0; round < team.rounds(); round++) {
            int piece = 2 * team.piece(worker, round);
            int beforePairs = foundCount[worker];
            int beforeContacts = finder.count;
            findFeatures(worker, team.from(pairs.count, worker, round), team.to(pairs.count, worker, round));
            firstFound[piece] = beforePairs;
            firstFound[piece + 1] = beforeContacts;
            firstPair[piece] = foundCount[worker] - beforePairs;
            firstPair[piece + 1] = finder.count - beforeContacts;
        }
    }

    private void findFeatures(int worker, int from, int to) {
        RigidFeatures finder = finders[worker];
        int old = from < to ? firstOld(pairs.a[from], pairs.b[from]) : 0;
        for (int p = from; p < to; p++) {
            int t = pairs.a[p];
            int other = pairs.b[p];
            while (old < step.contacts && compare(old, t, other) < 0) {
                old++;
            }
            int end = old;
            while (end < step.contacts && compare(end, t, other) == 0) {
                end++;
            }
            int before = finder.count;
            finder.find(p, old, end);
            if (finder.count > before) {
                note(worker, p, finder.count, old, end);
            }
            old = end;
        }
    }

    private void note(int worker, int p, int end, int old, int oldEnd) {
        int at = PAIR_STRIDE * foundCount[worker]++;
        if (at == foundPairs[worker].length) {
            foundPairs[worker] = Arrays.copyOf(foundPairs[worker], Math.max(64 * PAIR_STRIDE, 2 * at));
        }
        int[] to = foundPairs[worker];
        to[at] = p;
        to[at + 1] = end;
        to[at + 2] = old;
        to[at + 3] = oldEnd;
    }

    /** The first contact of the step before that is not before a pair. */
    private int firstOld(int t, int other) {
        int low = 0;
        int high = step.contacts;
        while (low < high) {
            int middle = low + high >>> 1;
            if (compare(middle, t, other) < 0) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** An old contact and a pair, by their keys. */
    private int compare(int old, int t, int other) {
        return RigidStep.compare(
                step.contactKeys, RigidStep.KEYS * old, things.type[other], things.id[t], things.id[other]);
    }

    /** Makes room for contacts, and keeps those that are there. */
    private void grow(int needed) {
        if (a.length < needed) {
            int n = needed + (needed >> 1);
            a = Arrays.copyOf(a, n);
            b = Arrays.copyOf(b, n);
            features = Arrays.copyOf(features, RigidFeatures.STRIDE * n);
            rows = Arrays.copyOf(rows, RigidRow.of(n));
        }
    }

    /** Brings what a worker has found to its place among all. */
    private void fill(int worker) {
        for (int round = 0; round < team.rounds(); round++) {
            int piece = 2 * team.piece(worker, round);
            int from = PAIR_STRIDE * firstFound[piece];
            int end = round + 1 < team.rounds()
                    ? PAIR_STRIDE * firstFound[2 * team.piece(worker, round + 1)]
                    : PAIR_STRIDE * foundCount[worker];
            int p = firstPair[piece];
            int c = firstPair[piece + 1];
            int f = firstFound[piece + 1];
            for (int at = from; at < end; at += PAIR_STRIDE) {
                int[] of = foundPairs[worker];
                pair[p] = of[at];
                firstOf[p++] = c;
                int begin = c;
                while (f < of[at + 1]) {
                    int[] found = finders[worker].found;
                    System.arraycopy(
                            found,
                            RigidFeatures.STRIDE * f++,
                            features,
                            RigidFeatures.STRIDE * c,
                            RigidFeatures.STRIDE);
                    place(c++, of[at]);
                }
                Arrays.fill(used, of[at + 2], of[at + 3], false);
                take(begin, c, of[at + 2], of[at + 3]);
            }
        }
    }

    /** Places a contact of a pair, whose features are known. */
    private void place(int c, int p) {
        boolean swapped = RigidFeatures.form(first(c)) == SWAPPED;
        a[c] = swapped ? pairs.b[p] : pairs.a[p];
        b[c] = swapped ? pairs.a[p] : pairs.b[p];
        int row = RigidRow.of(c);
        Arrays.fill(rows, row, row + RigidRow.STRIDE, 0f);
        rows[row + RigidRow.OX] = swapped ? -pairs.ox[p] : pairs.ox[p];
        rows[row + RigidRow.OY] = swapped ? -pairs.oy[p] : pairs.oy[p];
    }

    /** A number of a contact, by {@link RigidRow}. */
    float value(int c, int which) {
        return rows[RigidRow.of(c) + which];
    }

    /** The corner of A. */
    int corner(int c) {
        return features[RigidFeatures.STRIDE * c + RigidFeatures.CORNER];
    }

    /** The line of B, or its corner. */
    int feature(int c) {
        return features[RigidFeatures.STRIDE * c + RigidFeatures.OTHER];
    }

    boolean isLine(int c) {
        return RigidFeatures.form(first(c)) != BOTH;
    }

    private int first(int c) {
        return features[RigidFeatures.STRIDE * c + RigidFeatures.FIRST];
    }

    private int second(int c) {
        return features[RigidFeatures.STRIDE * c + RigidFeatures.SECOND];
    }

    /** Whether two contacts of a pair share a corner or a line. */
    private static boolean shareFeature(int first, int second, int otherFirst, int otherSecond) {
        int form = RigidFeatures.form(first);
        int otherForm = RigidFeatures.form(otherFirst);
        boolean same = (first & FEATURE) == (otherFirst & FEATURE);
        return same && (form == SWAPPED) == (otherForm == SWAPPED)
                || second == otherSecond && (form == CORNER_ON_LINE) == (otherForm == CORNER_ON_LINE);
    }

    // ---- impulses

    /** Measures the contacts of a pair, and gives them the impulses of the step before. */
    private void take(int from, int to, int old, int end) {
        for (int c = from; c < to; c++) {
            measures.measure(c);
            for (int o = old; o < end; o++) {
                int at = RigidStep.KEYS * o + RigidStep.B;
                if (step.contactKeys[at + 1] == first(c) && step.contactKeys[at + 2] == second(c)) {
                    take(c, o);
                }
            }
        }
        // a corner that has gone on to another feature takes along what it had
        for (int c = from; c < to; c++) {
            for (int o = old; o < end && rows[RigidRow.of(c) + RigidRow.IMPULSE] == 0f; o++) {
                int at = RigidStep.KEYS * o + RigidStep.B;
                if (!used[o]
                        && step.contactImpulses[RigidStep.IMPULSES * o + RigidStep.NORMAL] > 0f
                        && shareFeature(step.contactKeys[at + 1], step.contactKeys[at + 2], first(c), second(c))) {
                    take(c, o);
                }
            }
        }
    }

    private void take(int c, int old) {
        int row = RigidRow.of(c);
        float scale = k.warmScale;
        rows[row + RigidRow.IMPULSE] = scale * step.contactImpulses[RigidStep.IMPULSES * old + RigidStep.NORMAL];
        rows[row + RigidRow.GRIP] = scale * step.contactImpulses[RigidStep.IMPULSES * old + RigidStep.NORMAL + 1];
        used[old] = true;
    }

    /** Keeps the contacts for the next step, and those of what rests. */
    void keep(RigidResting rests) {
        step.ensureContacts(count + rests.count);
        if (rests.count == 0) {
            step.contacts = count;
            team.share(pairCount, 0, keep);
        } else {
            keepAmong(rests);
        }
    }

    private void keepAmong(RigidResting rests) {
        step.contacts = 0;
        int rest = 0;
        for (int p = 0; p < pairCount; p++) {
            int t = pairs.a[pair[p]];
            int other = pairs.b[pair[p]];
            rest = rests.keepBefore(step, rest, things.type[other], things.id[t], things.id[other]);
            for (int c = firstOf[p]; c < firstOf[p + 1]; c++) {
                keep(c, t, other, step.contacts++);
            }
        }
        rests.keepBefore(step, rest, Integer.MAX_VALUE, 0, 0);
    }

    private void keep(int worker, int from, int end) {
        for (int p = from; p < end; p++) {
            int t = pairs.a[pair[p]];
            int other = pairs.b[pair[p]];
            for (int c = firstOf[p]; c < firstOf[p + 1]; c++) {
                keep(c, t, other, c);
            }
        }
    }

    private void keep(int c, int t, int other, int place) {
        int at = RigidStep.KEYS * place;
        step.contactKeys[at + RigidStep.TYPE] = things.type[other];
        step.contactKeys[at + RigidStep.A] = things.id[t];
        step.contactKeys[at + RigidStep.B] = things.id[other];
        step.contactKeys[at + RigidStep.FORM_AND_FEATURE] = first(c);
        step.contactKeys[at + RigidStep.FEATURE_OF_B] = second(c);
        int to = RigidStep.IMPULSES * place + RigidStep.NORMAL;
        step.contactImpulses[to] = rows[RigidRow.of(c) + RigidRow.IMPULSE];
        step.contactImpulses[to + 1] = rows[RigidRow.of(c) + RigidRow.GRIP];
    }

    /** Measures a contact of the step before that no pair has now, behind all others, without counting it; false if a thing has no such feature. */
    boolean probe(RigidStep of, int o) {
        int at = RigidStep.KEYS * o;
        int form = RigidFeatures.form(of.contactKeys[at + RigidStep.FORM_AND_FEATURE]);
        int ofOther = of.contactKeys[at + RigidStep.FEATURE_OF_B];
        pairs.probe(
                of.contactKeys[at + RigidStep.A],
                of.contactKeys[at + RigidStep.TYPE],
                of.contactKeys[at + RigidStep.B]);
        int t = pairs.a[pairs.count];
        int other = pairs.b[pairs.count];
        boolean line = form == CORNER_ON_LINE;
        if (ofOther < 0 || ofOther >= (line ? things.lines[other] : things.corners[other])) {
            return false;
        }
        int c = count;
        grow(c + 1);
        int ofA = (form == SWAPPED ? things.firstLine[t] : things.firstCorner[t])
                + (of.contactKeys[at + RigidStep.FORM_AND_FEATURE] & FEATURE);
        int ofB = (line ? things.firstLine[other] : things.firstCorner[other]) + ofOther;
        int its = RigidFeatures.STRIDE * c;
        features[its + RigidFeatures.CORNER] = form == SWAPPED ? ofB : ofA;
        features[its + RigidFeatures.OTHER] = form == SWAPPED ? ofA : ofB;
        features[its + RigidFeatures.FIRST] = of.contactKeys[at + RigidStep.FORM_AND_FEATURE];
        features[its + RigidFeatures.SECOND] = ofOther;
        place(c, pairs.count);
        measures.measure(c);
        int from = RigidStep.IMPULSES * o + RigidStep.NORMAL;
        rows[RigidRow.of(c) + RigidRow.IMPULSE] = of.contactImpulses[from];
        rows[RigidRow.of(c) + RigidRow.GRIP] = of.contactImpulses[from + 1];
        return true;
    }

    /** Leaves out contacts, before they have impulses of the step. */
    void removeMarked(boolean[] gone) {
        int to = 0;
        int toPair = 0;
        int from = 0; // of a run of contacts that stay
        int run = 0; // where it goes
        for (int p = 0; p < pairCount; p++) {
            int begin = to;
            for (int c = firstOf[p]; c < firstOf[p + 1]; c++) {
                if (gone[c]) {
                    move(from, run, c - from);
                    from = c + 1;
                    run = to;
                } else {
                    to++;
                }
            }
            if (to > begin) {
                pair[toPair] = pair[p];
                firstOf[toPair++] = begin;
            }
        }
        move(from, run, count - from);
        pairCount = toPair;
        count = to;
        firstOf[pairCount] = count;
    }

    private void move(int from, int to, int n) {
        if (from == to || n == 0) {
            return;
        }
        System.arraycopy(a, from, a, to, n);
        System.arraycopy(b, from, b, to, n);
        int stride = RigidFeatures.STRIDE;
        System.arraycopy(features, stride * from, features, stride * to, stride * n);
        System.arraycopy(rows, RigidRow.of(from), rows, RigidRow.of(to), RigidRow.of(n));
    }

    long bytes() {
        long sum = 4L * (firstFound.length + firstPair.length);
        for (int worker = 0; worker < finders.length; worker++) {
            sum += finders[worker].bytes() + 4L * foundPairs[worker].length;
        }
        return sum + 4L * (2L + RigidFeatures.STRIDE + RigidRow.STRIDE) * a.length + 8L * pair.length + used.length;
    }
}
