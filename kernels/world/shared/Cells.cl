// uses: world/shared/CircleMath.cl
// Cells and pairs of ids. The Java class Cells documents them.

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
