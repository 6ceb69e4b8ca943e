// uses: world/shared/CircleMath.cl
// Contacts of circles of different levels. The Java class CrossRule says why the formulas are so.

#if defined(cl_khr_int64_base_atomics) && !defined(ATOMICS_BY_HALVES)
#define HAS_LONG_ATOMICS
#pragma OPENCL EXTENSION cl_khr_int64_base_atomics : enable
#endif

#ifdef __ENDIAN_LITTLE__
#define LOW_HALF 0
#else
#define LOW_HALF 1
#endif

bool isFinerLight(float inverseMassOfFiner, float inverseMassOfCoarser) { return inverseMassOfFiner >= inverseMassOfCoarser; }

int loadOfHeavy(float inverseMassOfLight, float inverseMassOfHeavy) {
    return (int) (inverseMassOfHeavy / (inverseMassOfHeavy + inverseMassOfLight) * CROSS_LOAD_UNITS) + 1;
}

float crossShare(int load) { return maxf((float) load * (1.0f / CROSS_LOAD_UNITS), 1.0f); }

float crossMass(float inverseMassOfLight, float inverseMassOfHeavy, float share) {
    return 1.0f / (inverseMassOfLight + share * inverseMassOfHeavy);
}

bool mayWait(float restitution, float inverseMassOfHeavy, float separation, float radius, float otherRadius) {
    float depth = minf(CROSS_WAIT_DEPTH * (radius + otherRadius), CROSS_WAIT_DEPTH_OF_SMALLER * minf(radius, otherRadius));
    return restitution > NEARLY_ELASTIC && inverseMassOfHeavy > 0.0f && separation + depth >= 0.0f;
}

float velocityRange(float radius, float inverseH) { return radius * inverseH; }
float impulseRange(float radius, float inverseH, float inverseMass) { return radius * inverseH / inverseMass; }
int exponentOf(float range) { return max(as_int(range) & 0x7f800000, 47 << 23); }
float scaleOf(float range) { return as_float(((127 + CROSS_RANGE_LOG + 127) << 23) - exponentOf(range)); }
float unitOf(float range) { return as_float(exponentOf(range) - (CROSS_RANGE_LOG << 23)); }
long toFixed(float value, float scale) { return (long) clampf(value * scale, -0x1p56f, 0x1p56f); }
float fromFixed(long sum, float unit) { return (float) sum * unit; }

// Work-items add in any order: the sum of whole numbers is the same.
void addFixed(global long *sum, long value) {
#ifdef HAS_LONG_ATOMICS
    atom_add(sum, value);
#else
    global uint *halves = (global uint *) sum;
    uint low = (uint) value;
    uint carry = atomic_add(halves + LOW_HALF, low) > ~low;
    atomic_add(halves + (1 - LOW_HALF), (uint) (value >> 32) + carry);
#endif
}
