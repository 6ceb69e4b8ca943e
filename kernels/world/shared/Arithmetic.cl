// What all formulas use. The compiler must contract no multiplication with an addition: docs/determinism.md has the rules.
#pragma OPENCL FP_CONTRACT OFF

// Not in intermediate code, which will be inlined later anyway: Oclgrind does not know all that compilers leave behind when they
// inline.
#ifdef __SPIR__
#define INLINE
#else
#define INLINE __attribute__((always_inline))
#endif

float greatest(float a, float b) { return a > b ? a : b; }

float least(float a, float b) { return a < b ? a : b; }

// A difference of coordinates the short way round. period: of the axis; infinite if it does not wrap.
float shortWay(float d, float period) {
    float half_ = 0.5f * period;
    return d > half_ ? d - period : d < -half_ ? d + period : d;
}

float norm(float x, float y) { return sqrt(x * x + y * y); }

float along(float nx, float ny, float vx, float vy) { return nx * vx + ny * vy; }
