// uses: world/shared/CircleMath.cl
// When circles touch that move evenly. The Java class TimeOfImpact documents it.

float timeOfWall(float x, float p, float r, float min, float max, float travelMin, float travelMax) {
    float low = ((min - travelMin) + r) - x;
    float high = ((max + travelMax) - r) - x;
    float toMin = p - travelMin;
    float toMax = p - (0.0f - travelMax);
    return toMin < 0.0f && toMin < low ? low / toMin : toMax > 0.0f && toMax > high ? high / toMax : 1.0f;
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
