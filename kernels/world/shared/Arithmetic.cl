// What all formulas use. The compiler must contract no multiplication with an addition: docs/determinism.md has the rules.
#pragma OPENCL FP_CONTRACT OFF

// Not in intermediate code, which will be inlined later anyway: Oclgrind does not know all that compilers leave behind when they
// inline.
#ifdef __SPIR__
#define INLINE
#else
#define INLINE __attribute__((always_inline))
#endif

// Not the built-ins of such names, which devices may compute in other ways. Of +0 and -0, maxf and minf give the second; if an argument is
// NaN, too. clampf(a, low, high) is maxf(minf(a, high), low).
float maxf(float a, float b) { return a > b ? a : b; }

float minf(float a, float b) { return a < b ? a : b; }

float clampf(float a, float low, float high) { return maxf(minf(a, high), low); }

// A difference of coordinates the short way round. period: of the axis; infinite if it does not wrap.
float shortWay(float d, float period) {
    float half_ = 0.5f * period;
    return d > half_ ? d - period : d < -half_ ? d + period : d;
}

float lengthf(float x, float y) { return sqrt(x * x + y * y); }

float dotf(float nx, float ny, float vx, float vy) { return nx * vx + ny * vy; }
