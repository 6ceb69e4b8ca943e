// The Java class CircleMath documents these formulas. A file here that has the name of a class in world.model has its functions and their bits: they
// use + - * / sqrt floor, comparisons and integers, in the same brackets.
// docs/determinism.md has the rules: no multiplication is contracted with an addition.
#pragma OPENCL FP_CONTRACT OFF

// Oclgrind, which reads SPIR, does not know all that compilers leave behind when they inline.
#ifdef __SPIR__
#define INLINE
#else
#define INLINE __attribute__((always_inline))
#endif

// Not the built-ins, which devices compute in other ways. Of +0 and -0, maxf and minf give the second; if one is NaN, too.
float minf(float a, float b) { return a < b ? a : b; }
float maxf(float a, float b) { return a > b ? a : b; }
float clampf(float a, float low, float high) { return maxf(minf(a, high), low); }

// The short way round. period: infinite if the axis does not wrap.
float shortWay(float d, float period) {
    float half_ = 0.5f * period;
    return d > half_ ? d - period : d < -half_ ? d + period : d;
}

float laps(float x, float min, float period) { return floor((x - min) / period); }

float shareOfPeriod(float p, float period) {
    float most = 0.125f * period;
    float way = fabs(p);
    return way > most ? most / way : 1.0f;
}

float lengthf(float x, float y) { return sqrt(x * x + y * y); }
float dotf(float nx, float ny, float vx, float vy) { return nx * vx + ny * vy; }
bool isLonger(float ux, float uy, float length) { return ux * ux + uy * uy > length * length; }

float lostByRounding(float base, float displacement, float sum) {
    float part = sum - base;
    return (base - (sum - part)) + (displacement - part);
}

float inverseMass(float mass) { return 1.0f / mass; }
float orOfKind(float own, float ofKind) { return isnan(own) ? ofKind : own; }

float within(float base, float displacement, float low, float high) {
    float x = base + displacement;
    return x < low ? low - base : x > high ? high - base : displacement;
}
