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

float afterImpulse(float v, float w, float impulse) {
    return bounded(v + w * impulse, -GREATEST_SPEED, GREATEST_SPEED);
}

// ---- broad phase ----------------------------------------------------------------------------------------------------

float reach(float r, float vx, float vy, float dt, float margin, float cap) {
    return (r + margin * r) + least(norm(vx, vy) * dt, cap * r);
}

int level(float r, float rmax) {
    int k = 0;
    float half_ = rmax * 0.5f;
    while (r <= half_ && k < LEVELS - 1) {
        k++;
        half_ *= 0.5f;
    }
    return k;
}

// Java's conversion of a float to an int saturates.
int cell(float x, float min, float inverseEdge) { return convert_int_sat(greatest((x - min) * inverseEdge, 0.0f)); }

int ringFirst(int a, int b, int mask) { return ((b + 1) & mask) == a ? b : a; }

uint mixBits(uint h) {
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    return h ^ (h >> 16);
}

int pairHash(int lo, int hi) { return (int) mixBits(mixBits((uint) lo) + (uint) hi); }

float partingX(int hash) { return (float) (hash & 1023) - 511.5f; }

float partingY(int hash) { return (float) ((int) ((uint) hash >> 10) & 1023) - 511.5f; }

// ---- contacts -------------------------------------------------------------------------------------------------------

float along(float nx, float ny, float vx, float vy) { return nx * vx + ny * vy; }

bool approaches(float vn, float thr2) { return vn < 0.0f && vn * vn > thr2; }

bool separates(float vn, float thr2) { return vn > 0.0f && vn * vn > thr2; }

bool carries(float lambda, float s, float vn, float thr2) { return lambda > 0.0f || (s < 0.0f && vn * vn <= thr2); }

float bounceSpeed(float e, float vn, float s, float h, float thr2) {
    return approaches(vn, thr2) && s + vn * h < 0.0f ? -e * vn : 0.0f;
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

float wallImpulse(float sign, float side) { return greatest(side * sign, 0.0f); }

float within(float base, float displacement, float low, float high) {
    float x = base + displacement;
    return x < low ? low - base : x > high ? high - base : displacement;
}
