// uses: world/shared/Arithmetic.cl
// The Java class CircleMath documents these formulas. Same bits: only + - * / sqrt floor, comparisons and integers, in the same brackets.

float lostByRounding(float base, float displacement, float sum) {
    float part = sum - base;
    return (base - (sum - part)) + (displacement - part);
}

float laps(float x, float min, float period) { return floor((x - min) / period); }

float shareOfPeriod(float p, float period) {
    float most = 0.125f * period;
    float way = fabs(p);
    return way > most ? most / way : 1.0f;
}

float inverseMass(float mass) { return 1.0f / mass; }
float limitSpeed(float v) { return clampf(v, -GREATEST_SPEED, GREATEST_SPEED); }
float afterImpulse(float v, float w, float impulse) { return limitSpeed(v + w * impulse); }
float beforeImpulse(float v, float gain, float dampingFactor) { return (v + gain) * dampingFactor; }

float shareWithin(float x, float y, float most) {
    float length = lengthf(x, y);
    return length > most ? most / length : 1.0f;
}

float gain(float gravityGain, float force, float w, float h) {
    return force == 0.0f ? gravityGain : limitSpeed(gravityGain + force * w * h);
}

float plan(float v, float dt, float fall) { return v * dt + fall; }
float travelSpeed(float from, float to, float dt, float period) { return limitSpeed(shortWay(to - from, period) / dt); }
float speculativeDistance(float r, float path) { return (r + MARGIN * r) + minf(path, CAP * r); }
float sight(float r, float path) { return (r + MARGIN * r) + (path + r); }
bool isFast(float path, float r) { return path > CAP * r; }

float besideWalls(float x, float p, float r, float min, float max) {
    float slack = r + MARGIN * r;
    return (p < 0.0f && x - min < slack) || (p > 0.0f && max - x < slack) ? 0.0f : p;
}

float timeOfWall(float x, float p, float r, float min, float max, float travelMin, float travelMax) {
    float low = ((min - travelMin) + r) - x;
    float high = ((max + travelMax) - r) - x;
    float toMin = p - travelMin;
    float toMax = p - (0.0f - travelMax);
    return toMin < 0.0f && toMin < low ? low / toMin : toMax > 0.0f && toMax > high ? high / toMax : 1.0f;
}

float marginAtWall(float from, float to, float margin) {
    return from == to || fabs(to - from) > margin ? margin : 0.0f;
}

float travelShare(float path, float r) {
    float most = TRAVEL * r;
    return path > most ? most / path : 1.0f;
}

float sightMargin(float r, float path, float top) {
    return 1.125f * ((r + top) + maxf(path, CAP * top));
}

float carriedPath(float path, float longest, float top) { return minf(path, longest) + CAP * top; }

// Some compilers bring a number into this range by saturation, which makes 0 of NaN; clampf makes 1.
float boundedShare(float share) { return isnan(share) ? 1.0f : clampf(share, 0.0f, 1.0f); }

float leastBetween(float x, float px, float y, float py, float low, float high) {
    float from = py == 0.0f ? 0.0f : boundedShare((low - y) / py);
    float to = py == 0.0f ? 1.0f : boundedShare((high - y) / py);
    return x + minf(from * px, to * px);
}

float greatestBetween(float x, float px, float y, float py, float low, float high) {
    return -leastBetween(-x, -px, y, py, low, high);
}

bool sweeps(float r, float other) { return other * SWEEP_RATIO >= r; }
bool isLonger(float ux, float uy, float length) { return ux * ux + uy * uy > length * length; }

bool differ(float px, float py, float lowX, float highX, float lowY, float highY, float length) {
    if (lowX > highX) return false;
    float ux = maxf(px - lowX, highX - px);
    float uy = maxf(py - lowY, highY - py);
    return ux * ux + uy * uy > length * length;
}

float timeOfTouch(float dx, float dy, float ux, float uy, float sum) {
    float b = dx * ux + dy * uy;
    float a = ux * ux + uy * uy;
    float c = (dx * dx + dy * dy) - sum * sum;
    float disc = b * b - a * c;
    if (!(b > 0.0f) || !(disc >= 0.0f)) return 2.0f;
    return maxf(c, 0.0f) / (b + sqrt(disc));
}

float timeOfImpactBeyond(float dx, float dy, float ux, float uy, float sum, float graze) {
    float deep = timeOfTouch(dx, dy, ux, uy, sum - graze);
    return deep < 1.0f ? timeOfTouch(dx, dy, ux, uy, sum) : 2.0f;
}

float timeOfImpact(float dx, float dy, float ux, float uy, float sum) {
    return timeOfImpactBeyond(dx, dy, ux, uy, sum, GRAZE * sum);
}

float deepestGraze(float r, float other) { return (2.0f * GRAZE) * minf(r, other); }

bool isRunOver(float dx, float dy, float px, float py, float r, float sum) {
    float x = dx - px;
    float y = dy - py;
    return x * px + y * py < 0.0f || !isLonger(x, y, sum - RUN_OVER * r);
}

float beforeSlow(float t, float dx, float dy, float px, float py, float pathX, float pathY, float sum) {
    return minf(timeOfTouch(dx + pathX, dy + pathY, px, py, sum), t);
}

float timeOfCarry(float dx, float dy, float px, float py, float pathX, float pathY, float share, float r, float sum) {
    float t = timeOfImpact(dx, dy, px - pathX, py - pathY, sum);
    if (t < share) return t;
    float x = dx + share * pathX;
    float y = dy + share * pathY;
    t = maxf(timeOfImpact(x, y, px, py, sum), share);
    if (t < 1.0f && isRunOver(x, y, px, py, r, sum)) return t;
    bool meets = timeOfImpact(dx, dy, px, py, sum) < 1.0f;
    return meets && isRunOver(dx, dy, px, py, r, sum) ? 1.0f : 2.0f;
}

float holdAllowance(float r, float path, float other, bool stands, bool dull) {
    if (stands) return CLAMP_ALLOWANCE * r;
    float least = CLAMP_ALLOWANCE * minf(r, other);
    return other < r || dull ? least : clampf(path, least, r);
}

float nearest(float dx, float dy, float px, float py) {
    float square = px * px + py * py;
    if (!(square > 0.0f)) return 0.0f;
    return boundedShare((dx * px + dy * py) / square);
}

float alongPath(float dx, float dy, float px, float py) {
    float square = px * px + py * py;
    return square > 0.0f ? (dx * px + dy * py) / square : 0.0f;
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

// No place inside of walls has the last one; differences and counts of cells stay ints.
int cell(float x, float min, float inverseEdge) { return (int) clampf((x - min) * inverseEdge, 0.0f, 0x1p30f); }
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

// Of circles with one centre. ids: the lower above the higher.
float2 partingNormal(ulong ids) {
    int hash = pairHash((int) (ids >> 32), (int) ids);
    float x = partingX(hash);
    float y = partingY(hash);
    float length = lengthf(x, y);
    return (float2)(x / length, y / length);
}
