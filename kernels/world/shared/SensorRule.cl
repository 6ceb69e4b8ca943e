// uses: world/shared/CircleMath.cl
// When two circles that are only sensed touch. The Java class SensorRule documents it.

#ifdef REPORTING
bool isFastSensed(float path, float r) { return path > r; }
float sensorMargin(float r, float path, float top) { return 1.125f * ((r + top) + maxf(path, top)); }

bool findsSensed(int row, bool fast, float path, int id, bool otherFast, float otherPath, int otherId) {
    if (fast || otherFast) return fast && (!otherFast || path > otherPath || (path == otherPath && id < otherId));
    return row == SENSOR_SEEKS || (row == SENSOR_BOTH_SEEK && id < otherId);
}

float timeOfClosest(float dx, float dy, float ux, float uy) {
    float uu = ux * ux + uy * uy;
    return uu > 0.0f ? clampf(-(dx * ux + dy * uy) / uu, 0.0f, 1.0f) : 0.0f;
}

float sensedSeparation(float dx, float dy, float ux, float uy, float share, float sum) {
    return lengthf(dx + share * ux, dy + share * uy) - sum;
}

float timeSensed(float dx, float dy, float ux, float uy, float sum) {
    float b = -(dx * ux + dy * uy);
    float gap = (dx * dx + dy * dy) - sum * sum;
    float disc = maxf(b * b - (ux * ux + uy * uy) * gap, 0.0f);
    return gap > 0.0f && b > 0.0f ? minf(gap / (b + sqrt(disc)), 1.0f) : 0.0f;
}
#endif
