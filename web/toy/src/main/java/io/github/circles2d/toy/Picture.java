package io.github.circles2d.toy;

import io.github.circles2d.Joints;
import io.github.circles2d.Terrain;
import io.github.circles2d.World;
import java.util.Arrays;
import org.teavm.jso.typedarrays.Float32Array;
import org.teavm.jso.typedarrays.Int32Array;

/**
 * What the page draws: five numbers a circle, which are x, y, radius, shade, and the angle by which it has turned; terrain; and joints. The page
 * keeps circles that sleep, so it is told only of those that fall asleep or wake.
 */
final class Picture {
    static final int PLAIN = 0;
    static final int SPEED = 1;
    static final int PRESSURE = 2;

    /** Numbers a circle. */
    private static final int STRIDE = 5;

    /** Numbers a joint. */
    private static final int JOINT_STRIDE = 5;

    /** The shade of a circle that nothing moves. */
    private static final float STATIC = -1;

    /** The same of one whose surface moves. */
    private static final float BELT = -2;

    private static final int TINTS = 8;

    /** The speed that has the last colour, as a part of one that is high in the world. */
    private static final float FAST = 0.5f;

    /** Of the mean pressure, so that some circles have the last colour. */
    private static final float RANGE = 3;

    private final float fast;
    private float[] circles = new float[0];
    private float[] more = new float[0];
    private float[] angles = new float[0];
    private int[] kinds = new int[0];

    /** Whether a circle has turned. */
    private boolean turns;

    // A bit an id.
    private long[] awake = new long[0];
    private long[] living = new long[0];
    private long[] resting = new long[0]; // falls asleep by this picture
    private long[] waking = new long[0];
    private long[] shown = new long[0]; // sleeps, and the page has it

    private Float32Array rested = new Float32Array(0);
    private Int32Array woken = new Int32Array(0);
    private int modeOfShown = PLAIN;

    // Of the last picture.
    private int awakeOfShown;
    private int sleepers;

    private float[] pieces = new float[0];
    private float[] ends = new float[0];
    private float[] shades = new float[0];
    private final BlobShapes blobs = new BlobShapes();
    private final BodyShapes bodies = new BodyShapes();
    private float meanPressure;
    private float meanTension;

    Picture(Grain grain) {
        fast = FAST * grain.highSpeed();
    }

    /** The pieces of terrain as they are, with a shade in place of the kind. */
    Float32Array terrainOf(World world) {
        Terrain terrain = world.terrain();
        pieces = atLeast(pieces, Terrain.PIECE_STRIDE * terrain.size());
        int length = Terrain.PIECE_STRIDE * terrain.readPieces(pieces, null);
        Float32Array rows = new Float32Array(length);
        for (int k = 0; k < length; k++) {
            boolean isKind = k % Terrain.PIECE_STRIDE == Terrain.KIND;
            rows.set(k, isKind ? world.kind((int) pieces[k]).beltSpeed() != 0 ? BELT : STATIC : pieces[k]);
        }
        return rows;
    }

    /** The outlines of soft bodies, and of bodies that are pushed: x, y and the number of the body for each point. */
    Float32Array blobsOf(World world) {
        return bodies.append(blobs.of(world), world.bodies());
    }

    /** The ends of the joints as they are, and a shade of the force of each. Those within a soft body are left out: it is filled. */
    Float32Array jointsOf(World world) {
        Joints joints = world.joints();
        ends = atLeast(ends, 4 * joints.size());
        shades = atLeast(shades, joints.size());
        int count = joints.readEnds(ends);
        float sum = 0;
        int at = 0;
        int drawn = 0;
        for (int id = 0; at < count; id++) {
            long joint = joints.handle(id);
            if (joint != 0) {
                float force = Math.abs(joints.force(joint));
                sum += force;
                long other = joints.other(joint);
                if (other == 0 || !blobs.join(World.id(joints.circle(joint)), World.id(other))) {
                    shades[drawn] = meanTension == 0 ? 0 : Math.min(force / (RANGE * meanTension), 1);
                    System.arraycopy(ends, 4 * at, ends, 4 * drawn++, 4);
                }
                at++;
            }
        }
        if (sum > 0) {
            float mean = sum / count;
            meanTension = meanTension == 0 ? mean : meanTension + 0.05f * (mean - meanTension);
        }
        Float32Array rows = new Float32Array(JOINT_STRIDE * drawn);
        for (int k = 0; k < drawn; k++) {
            for (int end = 0; end < 4; end++) {
                rows.set(JOINT_STRIDE * k + end, ends[4 * k + end]);
            }
            rows.set(JOINT_STRIDE * k + 4, shades[k]);
        }
        return rows;
    }

    /** Draws the circles that do not sleep, as they are, and finds those that have fallen asleep or woken since the last picture. */
    Float32Array of(World world, int mode) {
        int ids = world.idLimit();
        if (mode != modeOfShown) {
            Arrays.fill(shown, 0);
            sleepers = 0;
            modeOfShown = mode;
        }
        ensure(ids);
        world.readAwakeById(awake);
        if (awakeOfShown == 0 && sleepers == world.size() && count(awake) == 0) {
            rested = new Float32Array(0); // all slept, and do
            woken = new Int32Array(0);
            return rested;
        }
        read(world, mode);
        for (int word = 0; word < shown.length; word++) {
            long asleep = living[word] & ~awake[word];
            resting[word] = asleep & ~shown[word];
            waking[word] = shown[word] & ~asleep;
            shown[word] = asleep;
        }
        turns = turns(ids);
        int moving = count(awake);
        sleepers = world.size() - moving;
        rested = new Float32Array((STRIDE + 1) * count(resting));
        int at = 0;
        for (int id = next(resting, 0); id >= 0; id = next(resting, id + 1)) {
            rested.set(at, id);
            draw(rested, at + 1, world, id, mode);
            at += STRIDE + 1;
        }
        woken = new Int32Array(count(waking));
        at = 0;
        for (int id = next(waking, 0); id >= 0; id = next(waking, id + 1)) {
            woken.set(at++, id);
        }
        Float32Array picture = new Float32Array(STRIDE * moving);
        at = 0;
        awakeOfShown = 0;
        for (int id = next(awake, 0); id >= 0; id = next(awake, id + 1)) {
            draw(picture, at, world, id, mode);
            at += STRIDE;
            awakeOfShown += isStatic(id) ? 0 : 1;
        }
        if (mode == PRESSURE) {
            follow(ids);
        }
        return picture;
    }

    /** How many circles neither slept nor were static in the last picture. */
    int awake() {
        return awakeOfShown;
    }

    /** The circles that have fallen asleep by the last picture: an id and five numbers each. */
    Float32Array rested() {
        return rested;
    }

    /** The ids of those that slept and do not sleep any more. */
    Int32Array woken() {
        return woken;
    }

    private void ensure(int ids) {
        circles = atLeast(circles, 4 * ids);
        more = atLeast(more, 2 * ids);
        angles = atLeast(angles, ids);
        if (kinds.length < ids) {
            kinds = new int[ids + ids / 2];
        }
        int words = (ids + 63) / 64;
        if (awake.length < words) {
            int room = words + words / 2;
            awake = new long[room];
            living = new long[room];
            resting = new long[room];
            waking = new long[room];
            shown = Arrays.copyOf(shown, room);
        }
    }

    private void read(World world, int mode) {
        Arrays.fill(living, 0);
        world.readById(circles, living);
        world.readAnglesById(angles, null);
        world.readKindsById(kinds, null);
        if (mode == SPEED) {
            world.readVelocitiesById(more, null);
        } else if (mode == PRESSURE) {
            world.readLoadsById(more, null);
        }
    }

    private static int count(long[] bits) {
        int sum = 0;
        for (long word : bits) {
            sum += Long.bitCount(word);
        }
        return sum;
    }

    /** The first id from one on whose bit is set; -1 if there is none. */
    private static int next(long[] bits, int from) {
        for (int word = from >> 6; word < bits.length; word++) {
            long left = word == from >> 6 ? bits[word] & -1L << from : bits[word];
            if (left != 0) {
                return 64 * word + Long.numberOfTrailingZeros(left);
            }
        }
        return -1;
    }

    private boolean isStatic(int id) {
        return circles[4 * id + 3] == Float.POSITIVE_INFINITY;
    }

    private void draw(Float32Array picture, int at, World world, int id, int mode) {
        boolean isStatic = isStatic(id);
        boolean isBelt = isStatic && world.kind(kinds[id]).beltSpeed() != 0;
        for (int k = 0; k < 3; k++) {
            picture.set(at + k, circles[4 * id + k]);
        }
        picture.set(at + 3, isBelt ? BELT : isStatic ? STATIC : shade(id, mode));
        boolean isMarked = turns && (!isStatic || angles[id] != 0);
        picture.set(at + 4, isMarked ? angles[id] : Float.NaN);
    }

    /** Whether a circle has turned. */
    private boolean turns(int ids) {
        for (int id = 0; id < ids; id++) {
            if (angles[id] != 0 && !Float.isNaN(angles[id])) {
                return true;
            }
        }
        return false;
    }

    private static float[] atLeast(float[] array, int length) {
        return array.length >= length ? array : new float[length + length / 2];
    }

    /** From 0 to 1. */
    private float shade(int id, int mode) {
        float a = more[2 * id];
        float b = more[2 * id + 1];
        return switch (mode) {
            case SPEED -> Math.min((float) Math.sqrt(Math.hypot(a, b) / fast), 1);
            case PRESSURE -> meanPressure == 0 ? 0 : Math.min(b / (RANGE * meanPressure), 1);
            default -> (id * 5 + (id >>> 3)) % TINTS / (float) (TINTS - 1);
        };
    }

    /** The scale follows the mean, slowly. */
    private void follow(int ids) {
        float sum = 0;
        int pressed = 0;
        for (int id = 0; id < ids; id++) {
            if (more[2 * id + 1] > 0) {
                sum += more[2 * id + 1];
                pressed++;
            }
        }
        if (pressed > 0) {
            float mean = sum / pressed;
            meanPressure = meanPressure == 0 ? mean : meanPressure + 0.05f * (mean - meanPressure);
        }
    }
}
