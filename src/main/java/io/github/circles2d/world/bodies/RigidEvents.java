package io.github.circles2d.world.bodies;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdTable;

/**
 * Compares what bodies touch in a step with what they touched in the one before, and tells of what has begun and ended. It does nothing until somebody
 * asks for it. Pairs are in ascending order of their keys.
 */
public final class RigidEvents implements RigidStep.Listener {
    private static final int HANDLES = 2;

    private final RigidStep step;
    private final IdTable bodies;
    private final HandleTable circles;
    private final IdTable pieces;
    private final RigidTouches told = new RigidTouches();

    // the pairs that touched in the last step: keys by RigidStep.TOUCH_KEYS, and handles
    private int touching;

    /** How many of them only sense each other, which come last. */
    private int sensed;

    private int[] keys = new int[0];
    private long[] handles = new long[0];

    private int[] nextKeys = new int[0];
    private long[] nextHandles = new long[0];

    // within a step: how many touch now, and the first pair at rest that is not before what is looked at
    private int count;
    private int rest;

    /** Tells of nothing yet. */
    RigidEvents(RigidStep step, IdTable bodies, HandleTable circles, IdTable pieces) {
        this.step = step;
        this.bodies = bodies;
        this.circles = circles;
        this.pieces = pieces;
    }

    /** Whether somebody is told. */
    public boolean isOn() {
        return step.listener != null;
    }

    /** Sets whether somebody is told from now on. What has not been taken is forgotten if not. */
    public void turn(boolean on) {
        if (on != isOn()) {
            step.listener = on ? this : null;
            touching = 0;
            sensed = 0;
            told.clear();
        }
    }

    /** Gives what has been told since the last call. */
    public void take(RigidTouches to) {
        to.clear();
        to.ensure(touching); // as after each step, so that what goes finds room
        told.moveTo(to);
    }

    /** Writes the handles of what touches a body, but walls, as far as there is room; returns how many there are. */
    public int list(int body, long[] to) {
        int n = 0;
        for (int k = 0; k < touching; k++) {
            int at = RigidStep.TOUCH_KEYS * k;
            int type = typeAt(keys, at);
            boolean isA = keys[at + RigidStep.A] == body;
            boolean isB = type == RigidStep.BODY_BODY && keys[at + RigidStep.B] == body;
            if (type != RigidStep.BODY_WALL && (isA || isB)) {
                if (n < to.length) {
                    to[n] = handles[HANDLES * k + (isA ? 1 : 0)];
                }
                n++;
            }
        }
        return n;
    }

    // ---- what goes

    /** A body goes. */
    void bodyGoes(int body) {
        end(RigidStep.BODY_BODY, body);
    }

    /** A circle goes. */
    void circleGoes(int circle) {
        end(RigidStep.BODY_CIRCLE, circle);
    }

    /** A piece of terrain goes. */
    void pieceGoes(int piece) {
        end(RigidStep.BODY_PIECE, piece);
    }

    /** All bodies go. */
    void bodiesGo() {
        end(RigidStep.BODY_BODY, -1);
    }

    /** All circles go. */
    void circlesGo() {
        end(RigidStep.BODY_CIRCLE, -1);
    }

    /** Ends the pairs of something, or of all such things. */
    private void end(int of, int id) {
        int kept = 0;
        for (int k = 0; k < touching; k++) {
            if (isOf(RigidStep.TOUCH_KEYS * k, of, id)) {
                end(k);
            } else {
                System.arraycopy(
                        keys, RigidStep.TOUCH_KEYS * k, keys, RigidStep.TOUCH_KEYS * kept, RigidStep.TOUCH_KEYS);
                System.arraycopy(handles, HANDLES * k, handles, HANDLES * kept, HANDLES);
                kept++;
            }
        }
        touching = kept;
    }

    private boolean isOf(int at, int of, int id) {
        int type = typeAt(keys, at);
        boolean isA = of == RigidStep.BODY_BODY && (id < 0 || keys[at + RigidStep.A] == id);
        return isA || type == of && (id < 0 || keys[at + RigidStep.B] == id);
    }

    // ---- steps

    @Override
    public boolean touched(int type, int a, int b) {
        int low = 0;
        int high = touching;
        while (low < high) {
            int middle = low + high >>> 1;
            int order = RigidStep.compare(keys, RigidStep.TOUCH_KEYS * middle, type, a, b);
            if (order == 0) {
                return true;
            }
            low = order < 0 ? middle + 1 : low;
            high = order < 0 ? high : middle;
        }
        return false;
    }

    @Override
    public void stepped() {
        int next = step.touches;
        if (step.touchesStay && next == 0 && sensed == 0) {
            return;
        }
        ensureNext(next + touching);
        told.ensure(2 * (touching + next));
        int before = 0;
        rest = 0;
        count = 0;
        sensed = 0;
        for (int k = 0; k < next; k++) {
            int at = RigidStep.TOUCH_KEYS * k;
            while (before < touching && compare(keys, RigidStep.TOUCH_KEYS * before, step.touchKeys, at) < 0) {
                leave(before++);
            }
            System.arraycopy(step.touchKeys, at, nextKeys, RigidStep.TOUCH_KEYS * count, RigidStep.TOUCH_KEYS);
            nextHandles[HANDLES * count] = bodies.handle(step.touchKeys[at + RigidStep.A]);
            nextHandles[HANDLES * count + 1] = other(step.touchKeys, at);
            sensed += isSensed(step.touchKeys, at) ? 1 : 0;
            if (before < touching && compare(keys, RigidStep.TOUCH_KEYS * before, step.touchKeys, at) == 0) {
                before++;
            } else {
                told.begin(
                        typeAt(step.touchKeys, at),
                        nextHandles[HANDLES * count],
                        nextHandles[HANDLES * count + 1],
                        step.touchValues,
                        RigidStep.TOUCH_VALUES * k);
            }
            count++;
        }
        while (before < touching) {
            leave(before++);
        }
        takeNext();
        touching = count;
    }

    private void takeNext() {
        int[] ofKeys = keys;
        long[] ofHandles = handles;
        keys = nextKeys;
        handles = nextHandles;
        nextKeys = ofKeys;
        nextHandles = ofHandles;
    }

    /** A pair is not among those of the step: it goes on to touch without an event if both rest, or all, else it ends. */
    private void leave(int pair) {
        int at = RigidStep.TOUCH_KEYS * pair;
        while (rest < step.resting.count && compare(step.resting.keys, KeptContacts.KEYS * rest, keys, at) < 0) {
            rest++;
        }
        boolean rests =
                rest < step.resting.count && compare(step.resting.keys, KeptContacts.KEYS * rest, keys, at) == 0;
        if (rests || step.touchesStay && !isSensed(keys, at)) {
            System.arraycopy(keys, at, nextKeys, RigidStep.TOUCH_KEYS * count, RigidStep.TOUCH_KEYS);
            System.arraycopy(handles, HANDLES * pair, nextHandles, HANDLES * count, HANDLES);
            count++;
        } else {
            end(pair);
        }
    }

    private void end(int pair) {
        told.end(typeAt(keys, RigidStep.TOUCH_KEYS * pair), handles[HANDLES * pair], handles[HANDLES * pair + 1]);
    }

    /** The type of a pair, whether it pushes or is sensed. */
    private static int typeAt(int[] of, int at) {
        return of[at + RigidStep.TYPE] % RigidStep.SENSED;
    }

    private static boolean isSensed(int[] of, int at) {
        return of[at + RigidStep.TYPE] >= RigidStep.SENSED;
    }

    private static int compare(int[] a, int atA, int[] b, int atB) {
        return RigidStep.compare(a, atA, b[atB + RigidStep.TYPE], b[atB + RigidStep.A], b[atB + RigidStep.B]);
    }

    /** The handle of what a body touches, or the number of a wall. */
    private long other(int[] of, int at) {
        int id = of[at + RigidStep.B];
        return switch (typeAt(of, at)) {
            case RigidStep.BODY_BODY -> bodies.handle(id);
            case RigidStep.BODY_PIECE -> pieces.handle(id);
            case RigidStep.BODY_CIRCLE -> circles.handle(id);
            default -> id;
        };
    }

    private void ensureNext(int pairs) {
        if (nextKeys.length < RigidStep.TOUCH_KEYS * pairs || nextHandles.length < HANDLES * pairs) {
            int c = Math.max(16, pairs + (pairs >> 1));
            nextHandles = new long[HANDLES * c];
            nextKeys = new int[RigidStep.TOUCH_KEYS * c];
        }
    }

    // ---- states

    void save(SavedRigids to) {
        to.setTouching(touching);
        System.arraycopy(keys, 0, to.touchingKeys, 0, RigidStep.TOUCH_KEYS * touching);
    }

    /** Makes room for {@link #load}. If there is none, nothing has changed. */
    void makeRoom(SavedRigids from) {
        if (isOn()) {
            ensureNext(from.touching);
            told.ensure(from.touching);
        }
    }

    /** Takes over saved pairs; bodies, circles and pieces are there. What has not been taken is forgotten. There is room. */
    void load(SavedRigids from) {
        told.clear();
        touching = isOn() ? from.touching : 0;
        System.arraycopy(from.touchingKeys, 0, nextKeys, 0, RigidStep.TOUCH_KEYS * touching);
        sensed = 0;
        for (int k = 0; k < touching; k++) {
            sensed += isSensed(nextKeys, RigidStep.TOUCH_KEYS * k) ? 1 : 0;
            nextHandles[HANDLES * k] = bodies.handle(nextKeys[RigidStep.TOUCH_KEYS * k + RigidStep.A]);
            nextHandles[HANDLES * k + 1] = other(nextKeys, RigidStep.TOUCH_KEYS * k);
        }
        takeNext();
    }

    long bytes() {
        return 4L * (keys.length + nextKeys.length) + 8L * (handles.length + nextHandles.length) + told.bytes();
    }
}
