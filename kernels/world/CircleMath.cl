// Every floating-point formula of the World engine: the same functions, under the same names and in the same bracketing
// as the Java class CircleMath, which documents them. Both give the same bits: only + - * / sqrt, comparisons and integer
// operations, never contracted. No kernels here; constant cost a call.
#pragma OPENCL FP_CONTRACT OFF

// ---- geometry -------------------------------------------------------------------------------------------------------

float norm(float x, float y) { return sqrt(x * x + y * y); }

float least(float a, float b) { return a < b ? a : b; }

float greatest(float a, float b) { return a > b ? a : b; }

float bounded(float a, float low, float high) { return greatest(least(a, high), low); }

float difference(float base, float from, float to) { return base + (to - from); }

float lostByRounding(float base, float displacement, float sum) {
    float part = sum - base;
    return (base - (sum - part)) + (displacement - part);
}

float inverseMass(float mass) { return 1.0f / mass; }

float limitSpeed(float v) { return bounded(v, -GREATEST_SPEED, GREATEST_SPEED); }

float afterImpulse(float v, float w, float impulse) { return limitSpeed(v + w * impulse); }

// ---- broad phase ----------------------------------------------------------------------------------------------------

float plan(float v, float dt, float fall) { return v * dt + fall; }

float reach(float r, float path) { return (r + MARGIN * r) + least(path, CAP * r); }

bool isFast(float path, float r) { return path > r; }

float travelShare(float path, float r) {
    float most = TRAVEL * r;
    return path > most ? most / path : 1.0f;
}

bool sweeps(float r, float other) { return other * SWEEP_RATIO >= r; }

bool mayPass(float ux, float uy, float r, float other) {
    float halfSum = 0.5f * (r + other);
    return ux * ux + uy * uy > halfSum * halfSum && sweeps(r, other);
}

bool differ(float px, float py, float lowX, float highX, float lowY, float highY, float length) {
    if (lowX > highX) return false;
    float ux = greatest(px - lowX, highX - px);
    float uy = greatest(py - lowY, highY - py);
    return ux * ux + uy * uy > length * length;
}

float timeOfTouch(float dx, float dy, float ux, float uy, float sum) {
    float b = dx * ux + dy * uy;
    float a = ux * ux + uy * uy;
    float c = (dx * dx + dy * dy) - sum * sum;
    float disc = b * b - a * c;
    if (!(b > 0.0f) || !(disc >= 0.0f)) return 2.0f;
    return greatest(c, 0.0f) / (b + sqrt(disc));
}

float nearest(float dx, float dy, float px, float py) {
    float square = px * px + py * py;
    if (!(square > 0.0f)) return 0.0f;
    float share = (dx * px + dy * py) / square;
    // Some compilers bring a number into 0 to 1 by saturation, which makes 0 of NaN; bounded makes 1.
    return isnan(share) ? 1.0f : bounded(share, 0.0f, 1.0f);
}

int sizeClass(float r, float rmax) {
    int k = 0;
    float halved = rmax * 0.5f;
    while (r <= halved && k < LEVELS - 1) {
        k++;
        halved *= 0.5f;
    }
    return k;
}

// Java's conversion of a float to an int saturates.
int cell(float x, float min, float inverseEdge) { return convert_int_sat(greatest((x - min) * inverseEdge, 0.0f)); }

int ringFirst(int a, int b, int size) { return (b + 1 == size ? 0 : b + 1) == a ? b : a; }

uint mixBits(uint h) {
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    return h ^ (h >> 16);
}

int pairHash(int lo, int hi) { return (int) mixBits(mixBits((uint) lo) + (uint) hi); }

bool keeps(int hash, int fewer) {
    return fewer <= CROWD || (long) ((uint) hash >> 16) * (long) fewer < (long) CROWD << 16;
}

float partingX(int hash) { return (float) (hash & 1023) - 511.5f; }

float partingY(int hash) { return (float) ((int) ((uint) hash >> 10) & 1023) - 511.5f; }

// ---- contacts -------------------------------------------------------------------------------------------------------

float along(float nx, float ny, float vx, float vy) { return nx * vx + ny * vy; }

// Results of freeFlight.
#define SOLVE 0
#define LEAVE 1
#define BOUNCE 2

float bounceThreshold(float sum, float e, float gravityRate, float lengthRate) {
    float creep = lengthRate * ((1.0f - e) * sum);
    return gravityRate * sum + creep * creep;
}

int freeFlight(float vn, bool meets, float thr2) {
    if (vn * vn > thr2) {
        if (vn > 0.0f) return LEAVE;
        if (meets) return BOUNCE;
    }
    return SOLVE;
}

bool carries(float lambda, float s, float vn, float thr2) { return lambda > 0.0f || (s < 0.0f && vn * vn <= thr2); }

float bounceSpeed(float e, float vn, float s, float h, float thr2) {
    return vn < 0.0f && vn * vn > thr2 && s + vn * h < 0.0f ? -e * vn : 0.0f;
}

float freeBounce(float e, float vn, float k) { return -(1.0f + e) * vn * k; }

float rigid(float lambda, float k, float vn, float b) { return greatest(lambda - k * (vn + b), 0.0f); }

float soft(float lambda, float k, float vn, float s, float push, float biasRate, float massScale, float impulseScale) {
    float b = massScale * greatest(biasRate * s, -push);
    return greatest((lambda - k * (massScale * vn + b)) - impulseScale * lambda, 0.0f);
}

float pushSpeed(float sum, float perLength, float perRoot) { return greatest(perLength * sum, perRoot * sqrt(sum)); }

// ---- walls ----------------------------------------------------------------------------------------------------------

float wallSide(float x, float min, float max) { return x - min <= max - x ? 1.0f : -1.0f; }

float wallGap(float base, float displacement, float r, float side, float min, float max) {
    return side > 0.0f ? ((base - min) - r) + displacement : ((max - base) - r) - displacement;
}

float leftBehind(float gap, float vn, float gain, float dt, float r) {
    return gap > 0.0f && vn < 0.0f && -vn * dt <= r ? gain * (gap / -vn) : 0.0f;
}

float wallImpulse(float sign, float side) { return greatest(side * sign, 0.0f); }

float within(float base, float displacement, float low, float high) {
    float x = base + displacement;
    return x < low ? low - base : x > high ? high - base : displacement;
}
