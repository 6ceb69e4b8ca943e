package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.KeptContacts.CORNER_ON_LINE;
import static io.github.circles2d.world.bodies.KeptContacts.SWAPPED;

import io.github.circles2d.world.bodies.KeptContacts;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * The contacts of rigid bodies: a corner of one thing, A, and a line or corner of another, B. The normal points from B to A. A contact begins if the
 * corner is over the line, and the line's normal, reversed, is in the corner's cone; or if the way between two corners is in both cones.
 */
final class RigidContacts {
    private final RigidPairs near;
    private final Team team;

    /** By worker. */
    private final RigidFeatures[] finders;

    /** By piece of the work: how many pairs have contacts, and how many contacts; then the first ones among all. */
    private int[] ofPiece = new int[0];

    /** In the order of the keys of {@link KeptContacts}. */
    RigidContact[] all = {};

    int count;

    /** Those that have contacts, in order. */
    RigidPair[] pairs = {};

    int pairCount;

    /** The contact that has been measured last by {@link #probe}. */
    private final RigidContact probed = new RigidContact();

    /** By contact of the step before: whether another one has its impulses. */
    private boolean[] used = new boolean[0];

    // within a step
    private RigidStep step;
    private StepConstants k;

    private final Team.Work findFeatures = this::findFeatures;
    private final Team.Work fill = this::fill;
    private final Team.Share keep = this::keep;

    RigidContacts(RigidPairs near, Team team) {
        this.near = near;
        this.team = team;
        finders = new RigidFeatures[team.most()];
        for (int worker = 0; worker < finders.length; worker++) {
            finders[worker] = new RigidFeatures();
        }
    }

    // ---- finding

    /** Finds the contacts of all pairs, measures them, and gives them what they had. */
    void find(RigidStep bodies, StepConstants constants) {
        step = bodies;
        k = constants;
        int pieces = team.pieces();
        if (ofPiece.length < 2 * pieces) {
            ofPiece = new int[2 * pieces];
        }
        if (used.length < step.contacts.count) {
            used = new boolean[step.contacts.count + (step.contacts.count >> 1)];
        }
        team.together(findFeatures);
        pairCount = 0;
        count = 0;
        for (int piece = 0; piece < 2 * pieces; piece += 2) {
            int itsPairs = ofPiece[piece];
            int itsContacts = ofPiece[piece + 1];
            ofPiece[piece] = pairCount;
            ofPiece[piece + 1] = count;
            pairCount += itsPairs;
            count += itsContacts;
        }
        if (pairs.length < pairCount) {
            pairs = new RigidPair[pairCount + (pairCount >> 1)];
        }
        if (all.length < count) {
            all = new RigidContact[count + (count >> 1)];
        }
        team.together(fill);
    }

    private void findFeatures(int worker) {
        RigidFeatures finder = finders[worker];
        finder.begin(step.contacts, k.dt);
        for (int round = 0; round < team.rounds(); round++) {
            int piece = 2 * team.piece(worker, round);
            int before = finder.count;
            ofPiece[piece] =
                    findFeatures(finder, team.from(near.count, worker, round), team.to(near.count, worker, round));
            ofPiece[piece + 1] = finder.count - before;
        }
    }

    /** Returns how many pairs have contacts. */
    private int findFeatures(RigidFeatures finder, int from, int to) {
        int some = 0;
        int old = from < to ? firstOld(near.all[from]) : 0;
        for (int p = from; p < to; p++) {
            RigidPair pair = near.all[p];
            while (old < step.contacts.count && compare(old, pair) < 0) {
                old++;
            }
            pair.firstOld = old;
            while (old < step.contacts.count && compare(old, pair) == 0) {
                old++;
            }
            pair.endOld = old;
            pair.begin = finder.count;
            finder.find(pair);
            pair.end = finder.count;
            some += pair.end > pair.begin ? 1 : 0;
        }
        return some;
    }

    /** The first contact of the step before that is not before a pair. */
    private int firstOld(RigidPair pair) {
        int low = 0;
        int high = step.contacts.count;
        while (low < high) {
            int middle = low + high >>> 1;
            if (compare(middle, pair) < 0) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** An old contact and a pair, by their keys. */
    private int compare(int old, RigidPair pair) {
        return step.contacts.compare(old, pair.b.type, pair.a.id, pair.b.id);
    }

    /** Brings what a worker has found to its place among all. */
    private void fill(int worker) {
        RigidContact[] found = finders[worker].found;
        for (int round = 0; round < team.rounds(); round++) {
            int piece = 2 * team.piece(worker, round);
            int p = ofPiece[piece];
            int c = ofPiece[piece + 1];
            int to = team.to(near.count, worker, round);
            for (int n = team.from(near.count, worker, round); n < to; n++) {
                RigidPair pair = near.all[n];
                if (pair.end > pair.begin) {
                    pairs[p++] = pair;
                    int contacts = pair.end - pair.begin;
                    System.arraycopy(found, pair.begin, all, c, contacts);
                    pair.begin = c;
                    c += contacts;
                    pair.end = c;
                    begin(pair);
                }
            }
        }
    }

    /** Whether two contacts of a pair share a corner or a line. */
    private static boolean shareFeature(int first, int second, RigidContact other) {
        int form = KeptContacts.form(first);
        boolean same = KeptContacts.feature(first) == KeptContacts.feature(other.first);
        return same && (form == SWAPPED) == (other.form() == SWAPPED)
                || second == other.second && (form == CORNER_ON_LINE) == (other.form() == CORNER_ON_LINE);
    }

    // ---- impulses

    /** Measures the contacts of a pair, and gives them the impulses of the step before. */
    private void begin(RigidPair pair) {
        KeptContacts known = step.contacts;
        Arrays.fill(used, pair.firstOld, pair.endOld, false);
        for (int n = pair.begin; n < pair.end; n++) {
            RigidContact c = all[n];
            c.begin(pair);
            c.measure(k.h);
            for (int o = pair.firstOld; o < pair.endOld; o++) {
                if (known.formAndFeature(o) == c.first && known.featureOfB(o) == c.second) {
                    take(c, o);
                }
            }
        }
        // a corner that has gone on to another feature takes along what it had
        for (int n = pair.begin; n < pair.end; n++) {
            RigidContact c = all[n];
            for (int o = pair.firstOld; o < pair.endOld && c.impulse == 0f; o++) {
                if (!used[o]
                        && known.impulse(o) > 0f
                        && shareFeature(known.formAndFeature(o), known.featureOfB(o), c)) {
                    take(c, o);
                }
            }
        }
    }

    private void take(RigidContact c, int old) {
        c.impulse = k.warmScale * step.contacts.impulse(old);
        c.grip = k.warmScale * step.contacts.grip(old);
        used[old] = true;
    }

    /** Keeps the contacts for the next step, and those of what rests. */
    void keep(RigidResting rests) {
        step.contacts.ensure(count + rests.kept.count);
        if (rests.kept.count == 0) {
            step.contacts.count = count;
            team.share(pairCount, 0, keep);
        } else {
            keepAmong(rests);
        }
    }

    private void keepAmong(RigidResting rests) {
        step.contacts.count = 0;
        int rest = 0;
        for (int p = 0; p < pairCount; p++) {
            RigidPair pair = pairs[p];
            rest = rests.keepBefore(step, rest, pair.b.type, pair.a.id, pair.b.id);
            keep(pair, step.contacts.count);
            step.contacts.count += pair.end - pair.begin;
        }
        rests.keepBefore(step, rest, Integer.MAX_VALUE, 0, 0);
    }

    private void keep(int worker, int from, int end) {
        for (int p = from; p < end; p++) {
            keep(pairs[p], pairs[p].begin);
        }
    }

    /** Keeps the contacts of a pair at a place and behind it. */
    private void keep(RigidPair pair, int place) {
        for (int n = pair.begin; n < pair.end; n++) {
            RigidContact c = all[n];
            int to = place + n - pair.begin;
            step.contacts.set(to, pair.b.type, pair.a.id, pair.b.id, c.first, c.second, c.impulse, c.grip);
        }
    }

    /** Measures a contact of the step before that no pair has now; null if a thing has no such feature. It counts until the next call. */
    RigidContact probe(KeptContacts of, int o) {
        RigidPair pair = near.probe(of.a(o), of.type(o), of.b(o));
        RigidContact c = probed;
        c.first = of.formAndFeature(o);
        c.second = of.featureOfB(o);
        boolean onLine = c.form() == CORNER_ON_LINE;
        if (c.second < 0 || c.second >= (onLine ? pair.b.lineCount : pair.b.cornerCount)) {
            return null;
        }
        int feature = KeptContacts.feature(c.first);
        boolean swapped = c.form() == SWAPPED;
        c.corner = swapped ? pair.b.corners[c.second] : pair.a.corners[feature];
        c.line = swapped ? pair.a.lines[feature] : onLine ? pair.b.lines[c.second] : null;
        c.itsCorner = c.line == null ? pair.b.corners[c.second] : null;
        c.begin(pair);
        c.measure(k.h);
        c.impulse = of.impulse(o);
        c.grip = of.grip(o);
        return c;
    }

    /** Leaves out the contacts that are not to begin, before they have impulses of the step. */
    void removeCovered() {
        int to = 0;
        int toPair = 0;
        for (int p = 0; p < pairCount; p++) {
            RigidPair pair = pairs[p];
            int begin = to;
            for (int n = pair.begin; n < pair.end; n++) {
                if (!all[n].covered) {
                    all[to++] = all[n];
                }
            }
            pair.begin = begin;
            pair.end = to;
            if (to > begin) {
                pairs[toPair++] = pair;
            }
        }
        pairCount = toPair;
        count = to;
    }

    long bytes() {
        long sum = 4L * (ofPiece.length + all.length + pairs.length) + used.length;
        for (RigidFeatures each : finders) {
            sum += each.bytes();
        }
        return sum;
    }
}
