// uses: world/shared/CircleMath.cl
// How far circles get in a step. The Java class world.model.Reach explains it, function by function.

float reachOf(float r, float path, bool isStatic) { return isStatic ? REACH_STATIC_SLACK * r : REACH_SLACK * (r + path); }
int wholeLog2(float x) { return (as_int(x) >> 23) - 127; }
float powerOfTwo(int exponent) { return as_float((127 + exponent) << 23); }
int topExponent(float greatestRadius) { return wholeLog2(REACH_GREATEST * greatestRadius); }
int reachClassOf(float reach, int topExponent_) { return min(topExponent_ - wholeLog2(reach), 31); }
float topReach(int reachClass, int topExponent_) { return powerOfTwo(topExponent_ - reachClass + 1); }

float inverseReachEdge(int reachClass, int topExponent_) {
    return powerOfTwo(reachClass - topExponent_ - 1 - REACH_EDGE_LOG);
}

int reachCell(float x, float min_, float inverseEdge) {
    return (int) clampf((x - min_) * inverseEdge, -0x1p22f, 0x1p22f);
}

int reachBuckets(int circles) { return 2 << (31 - clz(max(circles, 1))); }

int reachBucket(int column, int row, int reachClass, int buckets) {
    uint h = (uint) column * 0x9e3779b1u + (uint) row * 0x85ebca6bu + (uint) reachClass * 0xc2b2ae35u;
    return (int) ((h ^ h >> 15) * 0x2c1b3c6du >> 7 & (uint) (buckets - 1));
}
