package io.github.circles2d.world.model;

/**
 * What a visit of a joint does to its impulses. m is an effective mass, v the speed of B against A, c how far B is from where it should be, along the
 * same line.
 */
public final class JointMath {
    /** So that what cannot be satisfied stays finite; more than the greatest mass at the greatest speed. */
    public static final float GREATEST_IMPULSE = 1e20f;

    public static final float RADIANS_PER_UNIT = 1.4629181e-9f;

    private static final int QUARTER_LOG = 30;
    private static final int QUARTER = 1 << QUARTER_LOG;
    private static final int EIGHTH = 1 << 29;

    private JointMath() {}

    public static float keptImpulse(float impulse) {
        return CircleMath.clamp(impulse, -GREATEST_IMPULSE, GREATEST_IMPULSE);
    }

    /** One over a sum of inverse masses; 0 if nothing moves. */
    public static float jointMass(float inverse) {
        return inverse > 0f ? 1f / inverse : 0f;
    }

    /** By how much a circle counts as lighter for a spring: as much of its share as keeps the spring stable. */
    public static float springShare(float share, float split) {
        return CircleMath.max(split * share, 1f);
    }

    /** Whether a joint that is so far from what it is to keep loads a circle. */
    public static boolean jointLoads(float strain, float radius) {
        return strain > Tuning.JOINT_STRAIN * radius;
    }

    /** With bias, by an implicit spring, or of a fixed angle. */
    public static float solvedImpulse(
            float impulse, float m, float v, float c, float massScale, float biasRate, float impulseScale) {
        return keptImpulse((impulse - m * (massScale * v + massScale * (biasRate * c))) - impulseScale * impulse);
    }

    /** The greatest speed by which a joint corrects where its ends are; radius: the lesser one of its circles. */
    public static float greatestPush(float radius, float inverseH) {
        return Tuning.JOINT_PUSH * radius * inverseH;
    }

    private static float heldUnkept(float impulse, float m, float v, float c, Softness s, float most) {
        float soft = m * (s.massScale * (s.biasRate * c)) + s.impulseScale * impulse;
        return (impulse - m * (s.massScale * v)) - CircleMath.clamp(soft, -1f * (m * most), m * most);
    }

    /** With bias, of what is rigid; most: {@link #greatestPush}. */
    public static float heldImpulse(float impulse, float m, float v, float c, Softness s, float most) {
        return keptImpulse(heldUnkept(impulse, m, v, c, s, most));
    }

    /** Without bias. */
    public static float relaxedImpulse(float impulse, float m, float v) {
        return keptImpulse(impulse - m * v);
    }

    /** By an exact spring; begun: the speed as the sub-step began. */
    public static float springImpulse(float m, float v, float begun, float c, float now, float ofBegun, float way) {
        return keptImpulse(-1f * (m * ((now * v + ofBegun * begun) + way * c)));
    }

    /** Of a limit, from which B is away by gap, with bias; v is positive if B goes away from it. */
    public static float solvedLimit(
            float impulse, float m, float v, float gap, float inverseH, Softness s, float most) {
        float next = gap > 0f ? impulse - m * (v + gap * inverseH) : heldUnkept(impulse, m, v, gap, s, most);
        return CircleMath.clamp(next, 0f, GREATEST_IMPULSE);
    }

    /** The same without bias. */
    public static float relaxedLimit(float impulse, float m, float v, float gap, float inverseH) {
        float next = impulse - m * (gap > 0f ? v + gap * inverseH : v);
        return CircleMath.clamp(next, 0f, GREATEST_IMPULSE);
    }

    /** How far A has turned against B since the reference angles, in radians; turned: in the step, in radians. */
    public static float turnedAway(
            int angleA, int referenceA, float turnedA, int angleB, int referenceB, float turnedB) {
        int units = (angleA - referenceA) - (angleB - referenceB);
        return (float) units * RADIANS_PER_UNIT + (turnedA - turnedB);
    }

    /** The mean of how far A and B have turned since the reference angles, in units. */
    public static int meanTurn(int angleA, int referenceA, float turnedA, int angleB, int referenceB, float turnedB) {
        int a = angleA - referenceA;
        int b = angleB - referenceB;
        float half = 0.5f * (turnedA + turnedB) * Surface.UNITS_PER_RADIAN;
        return b + ((a - b) >> 1) + (int) (long) CircleMath.clamp(half, -Surface.MOST_UNITS, Surface.MOST_UNITS);
    }

    private static float sinOfEighth(float x) {
        float z = x * x;
        return x + x * (z * (-1.6666667e-1f + z * (8.3333310e-3f + z * -1.9840874e-4f)));
    }

    private static float cosOfEighth(float x) {
        float z = x * x;
        return 1f - z * (0.5f - z * (4.1666666e-2f + z * (-1.3888397e-3f + z * 2.4760495e-5f)));
    }

    /** To 1e-7; by sums and products alone. */
    public static float sinOfUnits(int units) {
        int quarter = units + EIGHTH >>> QUARTER_LOG;
        float x = (float) (units - (quarter << QUARTER_LOG)) * RADIANS_PER_UNIT;
        float value = (quarter & 1) == 0 ? sinOfEighth(x) : cosOfEighth(x);
        return (quarter & 2) == 0 ? value : -1f * value;
    }

    public static float cosOfUnits(int units) {
        return sinOfUnits(units + QUARTER);
    }
}
