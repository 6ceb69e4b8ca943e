// docs/determinism.md has the rules: no multiplication is contracted with an addition.
#pragma OPENCL FP_CONTRACT OFF

// Oclgrind, which reads SPIR, does not know all that compilers leave behind when they inline.
#ifdef __SPIR__
#define INLINE
#else
#define INLINE __attribute__((always_inline))
#endif

// Not the built-ins, which devices compute in other ways. Of +0 and -0, maxf and minf give the second; if one is NaN, too.
float maxf(float a, float b) { return a > b ? a : b; }
float minf(float a, float b) { return a < b ? a : b; }
float clampf(float a, float low, float high) { return maxf(minf(a, high), low); }

// The short way round. period: infinite if the axis does not wrap.
float shortWay(float d, float period) {
    float half_ = 0.5f * period;
    return d > half_ ? d - period : d < -half_ ? d + period : d;
}

float lengthf(float x, float y) { return sqrt(x * x + y * y); }
float dotf(float nx, float ny, float vx, float vy) { return nx * vx + ny * vy; }
