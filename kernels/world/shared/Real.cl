// Formulas over REAL: one float, or the four lanes of a float4. A file that is written over REAL is taken for one lane, and for
// four where a kernel file asks for that (see KernelSource). Each lane has the bits of the formula for one: operators on vectors
// work lane by lane. A formula over REAL has no branches and calls no built-in function but sqrt.
#pragma OPENCL FP_CONTRACT OFF

#ifndef LANES
#define LANES
#endif
#define JOIN(a, b) a##b
#define REAL_OF(lanes) JOIN(float, lanes)
#define MASK_OF(lanes) JOIN(TRUTH, lanes)
#define NAME_OF(name, lanes) JOIN(name, lanes)
#define TRUTH bool
#define TRUTH4 int4
#define REAL REAL_OF(LANES)
#define MASK MASK_OF(LANES)              // what a comparison gives
#define NAME(name) NAME_OF(name, LANES) // greatest, greatest4

// a where the mask is true, else b. For vectors not by ?:, of which POCL makes slower code.
#define choose(mask, a, b) ((mask) ? (a) : (b))
#define choose4(mask, a, b) select(b, a, mask)

// Not in intermediate code, which will be inlined later anyway: Oclgrind does not know all that compilers leave behind when they
// inline.
#ifdef __SPIR__
#define INLINE
#else
#define INLINE __attribute__((always_inline))
#endif

REAL NAME(greatest)(REAL a, REAL b) { return NAME(choose)(a > b, a, b); }

REAL NAME(least)(REAL a, REAL b) { return NAME(choose)(a < b, a, b); }

// A difference of coordinates the short way round. period: of the axis; infinite if it does not wrap.
REAL NAME(shortWay)(REAL d, float period) {
    REAL half_ = (REAL)(0.5f * period);
    return NAME(choose)(d > half_, d - period, NAME(choose)(d < -half_, d + period, d));
}

REAL NAME(norm)(REAL x, REAL y) { return sqrt(x * x + y * y); }

REAL NAME(along)(REAL nx, REAL ny, REAL vx, REAL vy) { return nx * vx + ny * vy; }
