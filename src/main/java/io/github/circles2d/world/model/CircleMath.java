package io.github.circles2d.world.model;

/**
 * Every floating-point formula of the World engine except a visit of a contact or a wall ({@link Constraints}), in small functions
 * of scalars. The files in {@code kernels/world/shared} have the same functions under the same names, and both give the same bits:
 * they use {@code + - * /}, square roots, floors, comparisons and integer operations, in one fixed bracketing, and no contraction.
 *
 * <p>Units: lengths, masses and seconds are the caller's. n is the contact normal, a unit vector from the circle of the
 * lower id to that of the higher; s the separation of two surfaces, negative if they overlap; vn the relative speed
 * along n, negative if they approach; w an inverse mass, 0 for a static circle.
 */
public final class CircleMath {
    private CircleMath() {}

    // ---- geometry
    // ----------------------------------------------------------------------------------------------------

    /**
     * Length of a vector.
     *
     * @param x component
     * @param y component
     * @return the length
     */
    public static float norm(float x, float y) {
        return (float) Math.sqrt(x * x + y * y);
    }

    /**
     * The lesser of two numbers; the second where they are equal.
     *
     * @param a a number, not NaN
     * @param b a number, not NaN
     * @return the lesser
     */
    public static float least(float a, float b) {
        return a < b ? a : b;
    }

    /**
     * The greater of two numbers; the second where they are equal.
     *
     * @param a a number, not NaN
     * @param b a number, not NaN
     * @return the greater
     */
    public static float greatest(float a, float b) {
        return a > b ? a : b;
    }

    /**
     * A number brought into a range.
     *
     * @param a a number, not NaN
     * @param low the least result
     * @param high the greatest result; where it is less than low, low wins
     * @return a, or the end of the range nearest to it
     */
    public static float bounded(float a, float low, float high) {
        return greatest(least(a, high), low);
    }

    /**
     * Difference of two positions, each given as a base that stays for a step and a displacement since.
     *
     * @param base difference of the bases
     * @param from displacement of the first
     * @param to displacement of the second
     * @return second minus first
     */
    public static float difference(float base, float from, float to) {
        return base + (to - from);
    }

    /**
     * A difference of two coordinates the short way round.
     *
     * @param d the difference
     * @param period of the axis; infinite if it does not wrap, and then the difference stays as it is
     * @return d, or d and a period
     */
    public static float shortWay(float d, float period) {
        float half = 0.5f * period;
        return d > half ? d - period : d < -half ? d + period : d;
    }

    /**
     * How many periods a coordinate is from the first one.
     *
     * @param x coordinate
     * @param min where the first period begins
     * @param period of the axis; infinite if it does not wrap
     * @return a whole number, 0 if the axis does not wrap
     */
    public static float laps(float x, float min, float period) {
        return (float) Math.floor((x - min) / period); // the floor of a float is exact
    }

    /**
     * The share of a path that a circle goes at most along an axis that wraps: an eighth of the period. So two circles can meet in a step
     * the short way round alone.
     *
     * @param p component of the path
     * @param period of the axis; infinite if it does not wrap
     * @return 1, or less
     */
    public static float shareOfPeriod(float p, float period) {
        float most = 0.125f * period;
        float way = Math.abs(p);
        return way > most ? most / way : 1f;
    }

    /**
     * What the sum of a base and a displacement lost by rounding (the exact error of an addition, after Knuth).
     *
     * @param base a
     * @param displacement b
     * @param sum fl(a + b)
     * @return a + b - fl(a + b), exactly
     */
    public static float lostByRounding(float base, float displacement, float sum) {
        float part = sum - base;
        return (base - (sum - part)) + (displacement - part);
    }

    /**
     * Inverse mass.
     *
     * @param mass greater than 0; infinite for a static circle
     * @return 1 / mass, exactly 0 for a static circle
     */
    public static float inverseMass(float mass) {
        return 1f / mass;
    }

    /**
     * One component of a velocity after an impulse.
     *
     * @param v before
     * @param w inverse mass
     * @param impulse component of the impulse
     * @return after
     */
    public static float afterImpulse(float v, float w, float impulse) {
        return limitSpeed(v + w * impulse);
    }

    /**
     * A component of a velocity, kept below the greatest speed.
     *
     * @param v component
     * @return the component
     */
    public static float limitSpeed(float v) {
        return bounded(v, -Tuning.GREATEST_SPEED, Tuning.GREATEST_SPEED);
    }

    /**
     * A component of a velocity before impulses: after what acts in a sub-step, and the damping.
     *
     * @param v before
     * @param gain what gravity and a force add in a sub-step
     * @param dampingFactor 1 without damping, which changes no bit
     * @return after
     */
    public static float beforeImpulse(float v, float gain, float dampingFactor) {
        return (v + gain) * dampingFactor;
    }

    /**
     * What a vector is multiplied by so that it is not longer than a length.
     *
     * @param x component
     * @param y component
     * @param most greatest length, may be infinite
     * @return 1 if it is not longer
     */
    public static float shareWithin(float x, float y, float most) {
        float length = norm(x, y);
        return length > most ? most / length : 1f;
    }

    /**
     * What gravity and a force add to a component of a velocity in a sub-step.
     *
     * @param gravityGain what gravity adds
     * @param force component of the force; 0 for none, which changes no bit
     * @param w inverse mass
     * @param h length of a sub-step
     * @return a speed
     */
    public static float gain(float gravityGain, float force, float w, float h) {
        return force == 0f ? gravityGain : limitSpeed(gravityGain + force * w * h);
    }

    // ---- broad phase
    // -------------------------------------------------------------------------------------------------

    /**
     * What a circle moves in a step if nothing comes in its way, one component.
     *
     * @param v velocity
     * @param dt length of the step
     * @param fall what gravity adds in the sub-steps of a step
     * @return a displacement
     */
    public static float plan(float v, float dt, float fall) {
        return v * dt + fall;
    }

    /**
     * A component of the velocity of a circle that is to be somewhere else at the end of a step.
     *
     * @param from coordinate
     * @param to coordinate at the end
     * @param dt length of the step
     * @param period of the axis; infinite if it does not wrap
     * @return the component, which may be too small if the way is very long
     */
    public static float travelSpeed(float from, float to, float dt, float period) {
        return limitSpeed(shortWay(to - from, period) / dt);
    }

    /**
     * How far from its centre a circle looks for contacts: its radius, a margin, and what it moves in a step, up to a limit.
     * Two circles are listed as a contact where the distance of their centres is less than the sum of their speculative distances.
     *
     * @param r radius
     * @param path length of what it moves in a step
     * @return the speculative distance
     */
    public static float speculativeDistance(float r, float path) {
        return (r + Tuning.MARGIN * r) + least(path, Tuning.CAP * r);
    }

    /**
     * Whether a circle is fast: it moves farther in a step than its speculative distance covers, so it might come upon another
     * unseen.
     *
     * @param path length of what it moves in a step
     * @param r radius
     * @return true where it is
     */
    public static boolean isFast(float path, float r) {
        return path > Tuning.CAP * r;
    }

    /**
     * A component of a path, without what leads into a wall that the circle is at.
     *
     * @param x coordinate
     * @param p component of the path
     * @param r radius
     * @param min lower wall
     * @param max upper wall
     * @return the component, or 0
     */
    public static float besideWalls(float x, float p, float r, float min, float max) {
        float slack = r + Tuning.MARGIN * r;
        return p < 0f && x - min < slack || p > 0f && max - x < slack ? 0f : p;
    }

    /**
     * The share of a component of its path after which a circle touches a wall that it moves to.
     *
     * @param x coordinate
     * @param p component of the path
     * @param r radius
     * @param min lower wall at the end of the step
     * @param max upper wall at the end of the step
     * @param travelMin what the lower wall comes in during the step, at least 0
     * @param travelMax what the upper wall comes in during the step, at least 0
     * @return the share, negative where the circle is in the wall; 1 where it does not touch it
     */
    public static float timeOfWall(float x, float p, float r, float min, float max, float travelMin, float travelMax) {
        float low = ((min - travelMin) + r) - x;
        float high = ((max + travelMax) - r) - x;
        float toMin = p - travelMin; // against the wall
        float toMax = p - (0f - travelMax); // for no travel p itself, a zero with its sign
        return toMin < 0f && toMin < low ? low / toMin : toMax > 0f && toMax > high ? high / toMax : 1f;
    }

    /**
     * The share of its path that a circle goes at most.
     *
     * @param path length of what it moves in a step
     * @param r radius
     * @return 1, or less for a path of very many radii
     */
    public static float travelShare(float path, float r) {
        float most = Tuning.TRAVEL * r;
        return path > most ? most / path : 1f;
    }

    /**
     * How far from its path a fast circle looks for others: as far as circles can be that it touches or comes near to, and an
     * eighth for what the rounding of coordinates takes away. So the cells that it looks at never decide.
     *
     * @param r radius
     * @param path length of what it moves in a step
     * @param top greatest radius of the others
     * @return a length
     */
    public static float sightMargin(float r, float path, float top) {
        return 1.125f * ((r + top) + greatest(path, Tuning.CAP * top));
    }

    /**
     * The greatest length of the path of a circle that is not static and that a static one looks out for.
     *
     * @param path length of the static circle's path
     * @param longest at least the length of the longest path of all circles that are not static
     * @param top greatest radius of the others
     * @return a length
     */
    public static float carriedPath(float path, float longest, float top) {
        return least(path, longest) + Tuning.CAP * top;
    }

    /**
     * The least coordinate of the part of a straight path that is between two values of the other coordinate; of a path without such
     * a part, that of one of its ends.
     *
     * @param x where the path begins
     * @param px path
     * @param y where the path begins, the other coordinate
     * @param py path
     * @param low least other coordinate
     * @param high greatest other coordinate
     * @return the least coordinate
     */
    public static float leastBetween(float x, float px, float y, float py, float low, float high) {
        float from = py == 0f ? 0f : bounded((low - y) / py, 0f, 1f);
        float to = py == 0f ? 1f : bounded((high - y) / py, 0f, 1f);
        return x + least(from * px, to * px);
    }

    /**
     * As {@link #leastBetween}, the greatest coordinate.
     *
     * @param x where the path begins
     * @param px path
     * @param y where the path begins, the other coordinate
     * @param py path
     * @param low least other coordinate
     * @param high greatest other coordinate
     * @return the greatest coordinate
     */
    public static float greatestBetween(float x, float px, float y, float py, float low, float high) {
        return -leastBetween(-x, -px, y, py, low, high);
    }

    /**
     * Whether a fast circle looks out for another that is not static: not for one so much smaller that it would push it aside.
     *
     * @param r radius of the fast circle
     * @param other radius of the other
     * @return true where it does
     */
    public static boolean sweeps(float r, float other) {
        return other * Tuning.SWEEP_RATIO >= r;
    }

    /**
     * Whether a vector is longer than a length.
     *
     * @param ux vector
     * @param uy vector
     * @param length the length
     * @return true where they do
     */
    public static boolean isLonger(float ux, float uy, float length) {
        return ux * ux + uy * uy > length * length;
    }

    /**
     * Whether some path in a range differs from a given one by more than a length.
     *
     * @param px the path
     * @param py the path
     * @param lowX least x in the range
     * @param highX greatest x
     * @param lowY least y
     * @param highY greatest y
     * @param length the length
     * @return false where none can; false for an empty range, whose least is greater than its greatest
     */
    public static boolean differ(float px, float py, float lowX, float highX, float lowY, float highY, float length) {
        if (lowX > highX) {
            return false;
        }
        float ux = greatest(px - lowX, highX - px);
        float uy = greatest(py - lowY, highY - py);
        return ux * ux + uy * uy > length * length;
    }

    /**
     * When two circles touch that move evenly, as the share of their motion, or a number greater than 1 where they do not.
     *
     * @param dx second position minus first
     * @param dy second position minus first
     * @param ux motion of the first minus that of the second
     * @param uy motion of the first minus that of the second
     * @param sum sum of the radii
     * @return the share, at least 0
     */
    public static float timeOfTouch(float dx, float dy, float ux, float uy, float sum) {
        float b = dx * ux + dy * uy;
        float a = ux * ux + uy * uy;
        float c = (dx * dx + dy * dy) - sum * sum;
        float disc = b * b - a * c;
        if (!(b > 0f) || !(disc >= 0f)) {
            return 2f;
        }
        return greatest(c, 0f) / (b + (float) Math.sqrt(disc));
    }

    /**
     * When two circles touch that move evenly, as {@link #timeOfTouch}, if they would do more than graze each other.
     *
     * @param dx second position minus first
     * @param dy second position minus first
     * @param ux motion of the first minus that of the second
     * @param uy motion of the first minus that of the second
     * @param sum sum of the radii
     * @return the share, at least 0; 1 or more where they do not within their motion
     */
    public static float timeOfImpact(float dx, float dy, float ux, float uy, float sum) {
        float deep = timeOfTouch(dx, dy, ux, uy, sum - Tuning.GRAZE * sum);
        return deep < 1f ? timeOfTouch(dx, dy, ux, uy, sum) : 2f;
    }

    /**
     * When a static circle that moves takes another along, which goes a share of its path and waits there: when they touch, if they
     * do so on its way, or if the static circle runs over it where it waits. At the end of the step, if it would be run over only
     * if something stopped it at once.
     *
     * @param dx position of the other minus that of the static circle
     * @param dy position of the other minus that of the static circle
     * @param px path of the static circle
     * @param py path of the static circle
     * @param pathX path of the other
     * @param pathY path of the other
     * @param share how much of it the other goes
     * @param r radius of the other
     * @param sum sum of the radii
     * @return the share of the step, at least 0; more than 1 where it takes it along not at all
     */
    public static float timeOfCarry(
            float dx, float dy, float px, float py, float pathX, float pathY, float share, float r, float sum) {
        float t = timeOfImpact(dx, dy, px - pathX, py - pathY, sum);
        if (t < share) {
            return t;
        }
        float x = dx + share * pathX;
        float y = dy + share * pathY;
        t = greatest(timeOfImpact(x, y, px, py, sum), share);
        if (t < 1f && isRunOver(x, y, px, py, r, sum)) {
            return t;
        }
        boolean meets = timeOfImpact(dx, dy, px, py, sum) < 1f;
        return meets && isRunOver(dx, dy, px, py, r, sum) ? 1f : 2f;
    }

    /**
     * Whether a circle that does not move is deep in a static one or behind it when that has moved.
     *
     * @param dx position minus that of the static circle before
     * @param dy position minus that of the static circle before
     * @param px path of the static circle
     * @param py path of the static circle
     * @param r radius
     * @param sum sum of the radii
     * @return true where it is
     */
    public static boolean isRunOver(float dx, float dy, float px, float py, float r, float sum) {
        float x = dx - px;
        float y = dy - py;
        return x * px + y * py < 0f || !isLonger(x, y, sum - Tuning.RUN_OVER * r);
    }

    /**
     * How far a circle that meets another at once may leave its path: as far as it flies back, but no farther than its radius,
     * and hardly at all where a static circle or a smaller one is in its way.
     *
     * @param r radius
     * @param path length of what it moves in a step
     * @param other radius of the other
     * @param isStatic whether the other is static
     * @return a length
     */
    public static float holdAllowance(float r, float path, float other, boolean isStatic) {
        if (isStatic) {
            return Tuning.CLAMP_ALLOWANCE * r;
        }
        return other < r ? Tuning.CLAMP_ALLOWANCE * other : bounded(path, Tuning.CLAMP_ALLOWANCE * r, r);
    }

    /**
     * Where on a path a displacement is nearest, as a share of the path.
     *
     * @param dx displacement
     * @param dy displacement
     * @param px path
     * @param py path
     * @return 0 to 1
     */
    public static float nearest(float dx, float dy, float px, float py) {
        float square = px * px + py * py;
        return square > 0f ? bounded((dx * px + dy * py) / square, 0f, 1f) : 0f;
    }

    /**
     * How far along a path a displacement leads, as a share of the path.
     *
     * @param dx displacement
     * @param dy displacement
     * @param px path
     * @param py path
     * @return the share, which may be negative or more than 1
     */
    public static float alongPath(float dx, float dy, float px, float py) {
        float square = px * px + py * py;
        return square > 0f ? (dx * px + dy * py) / square : 0f;
    }

    /**
     * The size class of a radius: class k holds radii in (rmax / 2^(k+1), rmax / 2^k], the last class all smaller ones too.
     *
     * @param r radius
     * @param rmax greatest radius of all circles
     * @return 0 to {@link GridLevels#COUNT} - 1
     */
    public static int sizeClass(float r, float rmax) {
        int k = 0;
        float half = rmax * 0.5f;
        while (r <= half && k < GridLevels.COUNT - 1) {
            k++;
            half *= 0.5f;
        }
        return k;
    }

    /**
     * The number of the grid column (or row) of a coordinate.
     *
     * @param x coordinate, not less than min
     * @param min where column 0 begins
     * @param inverseEdge 1 / the edge of a cell
     * @return the column, at least 0
     */
    public static int cell(float x, float min, float inverseEdge) {
        return (int) greatest((x - min) * inverseEdge, 0f);
    }

    /**
     * The first of two columns (or rows) that are equal or next to each other on a ring.
     *
     * @param a a column
     * @param b a column
     * @param size columns of the ring, at least 4
     * @return b where a follows b, else a
     */
    public static int ringFirst(int a, int b, int size) {
        return (b + 1 == size ? 0 : b + 1) == a ? b : a;
    }

    /**
     * A well-mixed number of a pair of ids (the finalizer of MurmurHash3, twice).
     *
     * @param lo the lower id
     * @param hi the higher id
     * @return 32 mixed bits
     */
    public static int pairHash(int lo, int hi) {
        return mix(mix(lo) + hi);
    }

    private static int mix(int h) {
        h = (h ^ (h >>> 16)) * 0x85ebca6b;
        h = (h ^ (h >>> 13)) * 0xc2b2ae35;
        return h ^ (h >>> 16);
    }

    /**
     * Whether a pair in a crowd is kept: all pairs where one of the two has few candidates, else a share of them, drawn by the
     * hash of the pair. So one point that holds all circles has a number of contacts that grows with theirs, not with its
     * square.
     *
     * @param hash the hash of the pair
     * @param fewer the number of candidates of the one that has fewer
     * @return true where it is kept
     */
    public static boolean keeps(int hash, int fewer) {
        return fewer <= Tuning.CROWD || (hash >>> 16) * (long) fewer < (long) Tuning.CROWD << 16;
    }

    /**
     * x of the direction in which two circles with one centre part; not of unit length, never zero.
     *
     * @param hash the hash of the pair
     * @return a number from -511.5 to 511.5
     */
    public static float partingX(int hash) {
        return (float) (hash & 1023) - 511.5f;
    }

    /**
     * y of the direction in which two circles with one centre part.
     *
     * @param hash the hash of the pair
     * @return a number from -511.5 to 511.5
     */
    public static float partingY(int hash) {
        return (float) ((hash >>> 10) & 1023) - 511.5f;
    }

    // ---- contacts
    // ----------------------------------------------------------------------------------------------------

    /**
     * Component of a relative velocity along a normal.
     *
     * @param nx normal
     * @param ny normal
     * @param vx velocity of the second minus that of the first
     * @param vy velocity of the second minus that of the first
     * @return vn
     */
    public static float along(float nx, float ny, float vx, float vy) {
        return nx * vx + ny * vy;
    }

    /**
     * The square of the speed up to which an impact does not bounce. One part is the speed of a fall from a small part of a radius, so
     * that piles come to rest. The other is a creeping speed, so that clumps come to rest without gravity too. Both go down to 0 for
     * elastic pairs.
     *
     * @param sum sum of the radii
     * @param e restitution of the pair
     * @param gravityRate gravity's part, per sum of radii, of a pair that is not nearly elastic
     * @param lengthRate creeping speed per sum of radii, of a pair that is not nearly elastic
     * @param fixed the square of a threshold of all pairs, with rates of 0; or 0
     * @return the square of the speed; 0 for an elastic pair without a fixed one
     */
    public static float bounceThreshold(float sum, float e, float gravityRate, float lengthRate, float fixed) {
        float length = inelasticity(e) * sum;
        float creep = lengthRate * length;
        return gravityRate * length + creep * creep + fixed;
    }

    /**
     * The same for two circles that nothing carries, whose creeping speed is lower.
     *
     * @param sum sum of the radii
     * @param e restitution of the pair
     * @param gravityRate gravity's part, per sum of radii, of a pair that is not nearly elastic
     * @param lengthRate creeping speed per sum of radii, of a pair without restitution
     * @param fixed the square of a threshold of all pairs, with rates of 0; or 0
     * @return the square of the speed
     */
    public static float flightThreshold(float sum, float e, float gravityRate, float lengthRate, float fixed) {
        float creep = lengthRate * ((1f - e) * sum);
        return gravityRate * (inelasticity(e) * sum) + creep * creep + fixed;
    }

    /** 1 for a restitution that is not nearly 1; from there it goes down to 0 at 1. */
    private static float inelasticity(float e) {
        return least((1f - e) * (1f / (1f - Tuning.NEARLY_ELASTIC)), 1f);
    }

    /**
     * Impulse by which two free circles bounce.
     *
     * @param e restitution of the pair
     * @param vn normal speed, negative
     * @param k effective mass 1 / (w_lo + w_hi)
     * @return an impulse greater than 0
     */
    public static float freeBounce(float e, float vn, float k) {
        return -(1f + e) * vn * k;
    }

    /**
     * What gravity adds to the normal speed of a pair in half a sub-step. Sub-steps are a leapfrog, so velocities are half a
     * sub-step ahead of positions. A free bounce turns round the velocity that belongs to the position, and so neither gains nor loses
     * height.
     *
     * @param fall component along the normal of what gravity adds to the velocity of a circle in a sub-step
     * @param wLo inverse mass of the lower id's circle, 0 if it is static
     * @param wHi inverse mass of the higher id's circle, 0 if it is static
     * @return a speed, negative if gravity brings the two together; 0 if both circles fall
     */
    public static float halfFall(float fall, float wLo, float wHi) {
        float half = 0.5f * fall;
        return wLo == 0f ? half : wHi == 0f ? -half : 0f;
    }

    // ---- walls
    // -------------------------------------------------------------------------------------------------------

    /**
     * The wall of an axis that a circle is nearer to: its direction away from that wall.
     *
     * @param x coordinate
     * @param min lower wall
     * @param max upper wall
     * @return 1 for the lower wall, -1 for the upper
     */
    public static float wallSide(float x, float min, float max) {
        return x - min <= max - x ? 1f : -1f;
    }

    /**
     * Separation of a circle from a wall.
     *
     * @param base coordinate at the start of the step
     * @param displacement displacement since
     * @param r radius
     * @param side the wall, by {@link #wallSide}
     * @param min lower wall
     * @param max upper wall
     * @return s
     */
    public static float wallGap(float base, float displacement, float r, float side, float min, float max) {
        return side > 0f ? ((base - min) - r) + displacement : ((max - base) - r) - displacement;
    }

    /**
     * By how much a circle that bounces off a wall would end the sub-step too far from it, since it turns at the start of the sub-step
     * and not when it reaches the wall.
     *
     * @param gap separation at the start
     * @param vn normal speed, negative where it bounces
     * @param gain what the bounce adds to the velocity, 0 for none
     * @param dt length of the step
     * @param r radius
     * @return a displacement to take back; 0 for a circle that flies farther than its radius in a step, whose path is watched
     */
    public static float leftBehind(float gap, float vn, float gain, float dt, float r) {
        return gap > 0f && vn < 0f && -vn * dt <= r ? gain * (gap / -vn) : 0f;
    }

    /**
     * How far from a wall circles are kept as it is set to a new place. One whose radius is more than the wall's way stays where it is:
     * the step pushes it. Its centre is inside even so.
     *
     * @param from where the wall was; where it is now if it jumped
     * @param to where it is now
     * @param margin 0 for a static circle, else its radius
     * @return the margin, or 0
     */
    public static float marginAtWall(float from, float to, float margin) {
        return from == to || Math.abs(to - from) > margin ? margin : 0f;
    }

    /**
     * The part of a circle's stored wall impulse that belongs to one side.
     *
     * @param signed stored impulse, positive where the lower wall pushes
     * @param side the wall
     * @return at least 0
     */
    public static float wallImpulse(float signed, float side) {
        return greatest(side * signed, 0f);
    }

    /**
     * A displacement, cut so that a coordinate stays in a range.
     *
     * @param base coordinate at the start of the step
     * @param displacement displacement since
     * @param low least coordinate
     * @param high greatest coordinate
     * @return the displacement, or what leads to the end of the range
     */
    public static float within(float base, float displacement, float low, float high) {
        float x = base + displacement;
        return x < low ? low - base : x > high ? high - base : displacement;
    }

    /**
     * The velocity of a circle along an axis after it has moved: 0 if the farther wall has cut its displacement. Only the nearer wall
     * is a constraint; in a tube of one diameter the circle is at both.
     *
     * @param v velocity along the axis
     * @param displacement displacement along the axis before the walls cut it
     * @param kept displacement after
     * @param side the nearer wall, by {@link #wallSide}
     * @return v, or 0
     */
    public static float stopAtFarWall(float v, float displacement, float kept, float side) {
        return (side > 0f ? kept < displacement : kept > displacement) ? 0f : v;
    }
}
