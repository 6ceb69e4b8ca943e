// uses: world/shared/CircleMath.cl
// How far circles look and go in continuous collision. The Java class Paths documents it.

float speculativeDistance(float r, float path) { return (r + MARGIN * r) + minf(path, CAP * r); }
float sight(float r, float path) { return (r + MARGIN * r) + (path + r); }
bool isFast(float path, float r) { return path > CAP * r; }

float besideWalls(float x, float p, float r, float min, float max) {
    float slack = r + MARGIN * r;
    return (p < 0.0f && x - min < slack) || (p > 0.0f && max - x < slack) ? 0.0f : p;
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
float deepestGraze(float r, float other) { return (2.0f * GRAZE) * minf(r, other); }

bool differ(float px, float py, float lowX, float highX, float lowY, float highY, float length) {
    if (lowX > highX) return false;
    float ux = maxf(px - lowX, highX - px);
    float uy = maxf(py - lowY, highY - py);
    return ux * ux + uy * uy > length * length;
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
