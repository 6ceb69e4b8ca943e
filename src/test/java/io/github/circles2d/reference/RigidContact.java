package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.clamp;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.min;
import static io.github.circles2d.reference.Numbers.sqrt;

/** A contact of a corner of one thing, A, with a line or a corner of another, B. The normal points from B to A. */
final class RigidContact {
    private static final float GREATEST_FREQUENCY = 0.3f;
    private static final float PUSH = 0.4f;
    private static final float DEEP = 0.2f;
    private static final float DEEP_RATE = 15f;
    private static final float BOUNCE_DEPTH = 0.01f / PUSH;
    private static final float BOUNCE_THRESHOLD = 0.4f;
    private static final float NEARLY_ELASTIC = 0.9f;

    /** Of the push-out speed of circles. */
    private static final float OF_PUSH = 0.5f;

    private static final float LEAST_BOUNCE = 1e-6f;
    private static final float GREATEST_IMPULSE = 1e20f;

    /** How far lines go on beyond their ends, in half thicknesses. */
    private static final float GOES_ON = 0.25f;

    private static final float SAME_WAY = 0.98f;

    // forms
    static final int CORNER_ON_LINE = 0;
    static final int SWAPPED = 1;
    static final int BOTH = 2;

    /** What stays of a contact: the numbers of the form and of the feature of the body, and that of the other's feature. */
    record Saved(int type, int body, int other, int first, int second, float impulse, float grip) {
        Saved times(float scale) {
            return new Saved(type, body, other, first, second, scale * impulse, scale * grip);
        }

        int form() {
            return first >> 16;
        }

        /** Whether it has a feature in common with another one, of the same pair. */
        boolean sharesFeature(RigidContact c) {
            boolean same = (first & 0xFFFF) == (c.first & 0xFFFF);
            return same && (form() == SWAPPED) == (c.first >> 16 == SWAPPED)
                    || second == c.second && (form() == CORNER_ON_LINE) == (c.first >> 16 == CORNER_ON_LINE);
        }
    }

    final RigidPair pair;
    final RigidThing a;
    final RigidThing b;
    final int first;
    final int second;
    final boolean onLine;

    /** Of A: the number of its corner. */
    private final int corner;

    /** Of B: the number of its line or corner. */
    private final int feature;

    /** From the place of B to that of A. */
    private final float[] offset;

    float nx;
    float ny;
    float gap;

    // from the places of A and B to the point
    float ax;
    float ay;
    float bx;
    float by;

    float impulse;
    float grip;
    float roll;
    float bounce;

    /** The greatest speed of approach so far in the step. */
    private float approach;

    /** The greatest impulse so far in the step, but for that of the step before. */
    private float most;

    private final StepParameters k;

    RigidContact(
            RigidPair pair,
            RigidThing a,
            RigidThing b,
            int corner,
            int feature,
            boolean onLine,
            boolean swapped,
            StepParameters k) {
        this.pair = pair;
        this.a = a;
        this.b = b;
        this.corner = corner;
        this.feature = feature;
        this.onLine = onLine;
        this.k = k;
        int form = !onLine ? BOTH : swapped ? SWAPPED : CORNER_ON_LINE;
        first = form << 16 | (swapped ? feature : corner);
        second = swapped ? corner : feature;
        float side = swapped ? -1f : 1f;
        offset = new float[] {side * pair.offset[0], side * pair.offset[1]};
    }

    boolean isOf(Circle c) {
        return a.circle == c || b.circle == c;
    }

    /** The normal of the line, towards the first body; null if it is no straight line. */
    float[] lineNormal() {
        if (!onLine || RigidThing.isHollow(b.lines.get(feature))) {
            return null;
        }
        float side = first >> 16 == SWAPPED ? -1f : 1f;
        float[] line = b.lines.get(feature);
        return new float[] {side * line[2], side * line[3]};
    }

    float[] corner() {
        return a.corners.get(corner);
    }

    float[] feature() {
        return onLine ? b.lines.get(feature) : b.corners.get(feature);
    }

    /** From the place of B to that of A, now. */
    float[] wayToA() {
        return new float[] {offset[0] + (a.way[0] - b.way[0]), offset[1] + (a.way[1] - b.way[1])};
    }

    /** Finds the normal, the gap and the point. Impulses end if they come apart and the normal turns far. */
    void measure() {
        float beforeX = nx;
        float beforeY = ny;
        measureNormal();
        if (gap > 0f && beforeX * nx + beforeY * ny < SAME_WAY) {
            impulse = 0f;
            grip = 0f;
        }
    }

    private void measureNormal() {
        float[] p = corner();
        float[] q = feature();
        float[] d = wayToA();
        float px = p[0];
        float py = p[1];
        float r = p[7] + p[2];
        float[] end = endOfA(d[0] + px, d[1] + py);
        if (end != null) {
            px += r * end[0];
            py += r * end[1];
            r = 0f;
        }
        float rx = d[0] + px - q[0];
        float ry = d[1] + py - q[1];
        if (!onLine) {
            float itsRadius = q[7] + q[2];
            float[] itsEnd = b.end(feature, rx, ry);
            if (itsEnd == null) {
                measureCorner(rx, ry, r + itsRadius);
            } else {
                measureCorner(rx - itsRadius * itsEnd[0], ry - itsRadius * itsEnd[1], r);
            }
        } else if (RigidThing.isHollow(q)) {
            float far = length(rx, ry);
            if (far > 0f) {
                nx = -rx / far;
                ny = -ry / far;
            }
            gap = (-q[4] - far) - r;
        } else {
            measureLine(px, py, r, d, rx, ry);
        }
        ax = px - nx * r;
        ay = py - ny * r;
        bx = d[0] + ax;
        by = d[1] + ay;
    }

    /** The end with which A's corner, at (x, y) against the place of B, touches; null if it touches between its ends. */
    private float[] endOfA(float x, float y) {
        float[] q = feature();
        if (!onLine) {
            return a.end(corner, q[0] - x, q[1] - y);
        }
        return RigidThing.isHollow(q) ? a.end(corner, x - q[0], y - q[1]) : a.end(corner, -q[2], -q[3]);
    }

    /** The normal stays if both are in one place. */
    private void measureCorner(float rx, float ry, float radii) {
        float far = length(rx, ry);
        if (far > 0f) {
            nx = rx / far;
            ny = ry / far;
        }
        gap = far - radii;
    }

    private void measureLine(float px, float py, float r, float[] d, float rx, float ry) {
        float[] line = feature();
        float lx = line[2];
        float ly = line[3];
        float radii = r + line[5];
        float height = rx * lx + ry * ly;
        float along = ry * lx - rx * ly;
        float more = GOES_ON * (a.ownW > 0f || b.ownW == 0f ? a.thin : b.thin);
        boolean beside = !(along >= -more && along <= line[4] + more);
        if (beside && height > radii) {
            float ux = a.velocity[0] - a.omega * py - b.velocity[0] + b.omega * (d[1] + py);
            float uy = a.velocity[1] + a.omega * px - b.velocity[1] - b.omega * (d[0] + px);
            float un = ux * lx + uy * ly;
            float then = along + (uy * lx - ux * ly) * ((height - radii) / -un);
            beside = !(un < 0f && -un * k.h() >= height - radii && then >= -more && then <= line[4] + more);
        }
        float end = along < 0f ? 0f : line[4];
        float ex = rx + ly * end;
        float ey = ry - lx * end;
        if (beside && ex * lx + ey * ly > 0f) {
            measureCorner(ex, ey, radii);
            return;
        }
        nx = lx;
        ny = ly;
        gap = height - radii;
    }

    // ---- visits

    private static float inverseMass(RigidThing t, float armX, float armY, float x, float y) {
        float arm = armX * y - armY * x;
        return t.ownW + t.ownI * arm * arm;
    }

    /** One over the effective mass of A, or B, alone, along the normal. */
    float inverseMassOf(boolean ofA) {
        return ofA ? inverseMass(a, ax, ay, nx, ny) : inverseMass(b, bx, by, nx, ny);
    }

    private float shareOf(RigidThing t, boolean summing) {
        return summing && t.type == RigidThing.BODY ? t.share : 1f;
    }

    private float mass(boolean summing) {
        return massOf(
                summing
                        ? shareOf(a, true) * inverseMassOf(true) + shareOf(b, true) * inverseMassOf(false)
                        : inverseMassOf(true) + inverseMassOf(false));
    }

    /** 0 of what nothing moves. */
    private static float massOf(float inverse) {
        return inverse >= Float.MIN_NORMAL ? 1f / inverse : 0f;
    }

    /** The velocity of A against B at the point. */
    private float[] speed() {
        return new float[] {
            (a.velocity[0] - a.omega * ay) - (b.velocity[0] - b.omega * by),
            (a.velocity[1] + a.omega * ax) - (b.velocity[1] + b.omega * bx)
        };
    }

    private float normalSpeed() {
        float[] u = speed();
        return u[0] * nx + u[1] * ny;
    }

    private float normalSpeedBefore() {
        float ux = (a.velocityBefore[0] - a.omegaBefore * ay) - (b.velocityBefore[0] - b.omegaBefore * by);
        float uy = (a.velocityBefore[1] + a.omegaBefore * ax) - (b.velocityBefore[1] + b.omegaBefore * bx);
        return ux * nx + uy * ny;
    }

    /** R of both: the sum of the half thicknesses, of which that of what does not move counts as the other's. */
    private float radii() {
        return a.ownW == 0f ? 2f * b.thin : b.ownW == 0f ? 2f * a.thin : a.thin + b.thin;
    }

    private void apply(float x, float y, boolean summing) {
        a.push(x, y, ax, ay, summing);
        b.push(-x, -y, bx, by, summing);
    }

    /** What is accumulated acts again on bodies. */
    void warmStart() {
        if (impulse != 0f || grip != 0f) {
            float x = nx * impulse - ny * grip;
            float y = ny * impulse + nx * grip;
            if (a.type == RigidThing.BODY) {
                a.push(x, y, ax, ay, false);
            }
            if (b.type == RigidThing.BODY) {
                b.push(-x, -y, bx, by, false);
            }
        }
    }

    /** Stops what would come far into the other within a sub-step. */
    boolean isHit() {
        return impulse > 0f && approach * k.h() > Circle.CAP * radii();
    }

    /** Is neither pressed nor closed. */
    boolean isIdle() {
        return gap > 0f && impulse == 0f && grip == 0f;
    }

    /** Has closed without an impulse, as a body turned: it is to bounce in the next sub-step. */
    boolean bouncesLater() {
        return impulse == 0f && !(gap > 0f) && bounceSpeed(normalSpeed(), pushSpeed()) > 0f;
    }

    private float push() {
        return 0.5f * k.settings().pushOutSpeed();
    }

    private float pushSpeed() {
        return OF_PUSH * push() * radii();
    }

    /** With bias, along the normal. */
    void solve(boolean summing) {
        float push = push();
        float pushSpeed = pushSpeed();
        float omega = 2f * 3.14159265f * min(k.settings().frequency() * k.h(), GREATEST_FREQUENCY);
        float a1 = 2f * k.settings().damping() + omega;
        float a2 = omega * a1;
        float impulseScale = 1f / (1f + a2);
        float massScale = a2 * impulseScale;
        float biasRate = (omega / a1) * k.inverseH();
        float m = mass(summing);
        float vn = normalSpeed();
        float before = normalSpeedBefore();
        approach = max(approach, -before);
        bounce = bounceSpeed(before, pushSpeed);
        float next;
        if (bounce > 0f) {
            next = impulse - m * (vn - bounce);
        } else if (gap > 0f) {
            next = impulse - m * (vn + gap * k.inverseH());
        } else {
            float deep = DEEP_RATE * (push / PUSH) * gap + (DEEP * DEEP_RATE / PUSH - 1f) * pushSpeed;
            float bias = massScale * max(biasRate * gap, min(-pushSpeed, deep));
            next = (impulse - m * (massScale * vn + bias)) - impulseScale * impulse;
        }
        take(max(next, 0f), summing);
    }

    /** Without bias, along the normal. */
    void relax(boolean summing) {
        float bias = gap > 0f ? gap * k.inverseH() : 0f;
        take(max(impulse - mass(summing) * (normalSpeed() + bias), 0f), summing);
    }

    private void take(float wanted, boolean summing) {
        float next = min(wanted, GREATEST_IMPULSE);
        float gained = next - impulse;
        impulse = next;
        most = max(most, next);
        apply(nx * gained, ny * gained, summing);
    }

    /** 0 if there is no bounce. */
    private float bounceSpeed(float before, float pushSpeed) {
        float e = max(a.restitution, b.restitution);
        float inelastic = min((1f - e) * (1f / (1f - NEARLY_ELASTIC)), 1f) * radii();
        float creep = 0.5f * inelastic;
        float gravityRate = BOUNCE_THRESHOLD * BOUNCE_THRESHOLD * 0.5f * length(k.gravity());
        float fixed = k.settings().threshold();
        float squaredThreshold = fixed >= 0f ? fixed * fixed : gravityRate * inelastic + creep * creep;
        boolean bounces = e > 0f
                && before < 0f
                && before * before > squaredThreshold
                && gap + before * k.h() < 0f
                && gap + BOUNCE_DEPTH * pushSpeed >= 0f;
        if (!bounces) {
            return 0f;
        }
        RigidThing falls = a.w == 0f ? b : a;
        float half = 0.5f * (falls.gain[0] * nx + falls.gain[1] * ny);
        float halfFall = b.w == 0f ? half : a.w == 0f ? -half : 0f;
        return max(-e * before + (1f + e) * halfFall, LEAST_BOUNCE);
    }

    /** Friction, then rolling resistance, as far as the normal impulse allows. */
    void solveGrip(boolean summing) {
        float friction = sqrt(a.friction * b.friction);
        if (friction > 0f || grip != 0f) {
            float armA = ax * nx + ay * ny;
            float armB = bx * nx + by * ny;
            float m = massOf(shareOf(a, summing) * (a.ownW + a.ownI * armA * armA)
                    + shareOf(b, summing) * (b.ownW + b.ownI * armB * armB));
            float[] u = speed();
            float slip = u[1] * nx - u[0] * ny - (a.belt + b.belt);
            float next = held(grip - m * slip, friction * impulse);
            float gained = next - grip;
            grip = next;
            apply(-ny * gained, nx * gained, summing);
        }
        float resistance = max(a.rolling, b.rolling);
        float turns = a.ownI + b.ownI;
        if (resistance > 0f && turns > 0f) {
            float next = held(roll - massOf(turns) * (a.omega - b.omega), resistance * impulse);
            float gained = next - roll;
            roll = next;
            a.give(0f, 0f, a.i * gained, summing);
            b.give(0f, 0f, -b.i * gained, summing);
        }
    }

    private static float held(float value, float most) {
        return most > 0f ? clamp(value, -most, most) : 0f;
    }

    /** What a bounce gave has acted once for all. */
    void forgetBounce() {
        if (bounce > 0f) {
            bounce = 0f;
            impulse = 0f;
            grip = 0f;
            roll = 0f;
        }
    }

    /** What the pair tells of, if this is the contact that pressed most; null if it has not pressed. */
    RigidTouch touch() {
        if (!(most > 0f)) {
            return null;
        }
        boolean isA = a == pair.a;
        float side = isA ? -1f : 1f;
        float[] point = {
            pair.a.place[0] + (pair.a.way[0] + (isA ? ax : bx)), pair.a.place[1] + (pair.a.way[1] + (isA ? ay : by))
        };
        RigidTouch.Key key = new RigidTouch.Key(false, pair.b.type, pair.a.id, pair.b.id);
        return new RigidTouch(key, point, new float[] {side * nx, side * ny}, most, approach + 0f);
    }

    Saved save() {
        return new Saved(pair.b.type, pair.a.id, pair.b.id, first, second, impulse, grip);
    }
}
