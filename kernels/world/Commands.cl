// Applies what the caller asked for since the last step: records of the Java class Commands. The host links the records
// of one circle in call order (next) and marks the first of each; circles are independent of each other.

// Records, in ints: operation, id, seven values.
#define RECORD 9
#define ADD 1
#define REMOVE 2
#define POSITION 3
#define VELOCITY 4
#define RADIUS 5
#define MASS 6
#define RESTITUTION 7
#define IMPULSE 8

// Index space: a record a work-item. Cost: the records of one circle.
// links: for each record, the next of the same circle or -1, and (slot of a new circle) * 2, plus 1 where it is its
// circle's first.
kernel void commands_apply(global const int *records, global const int2 *links, int count, global float4 *homeCircle,
                           global float4 *homeMotion, global float4 *homeTraits, global int *homeId,
                           global int *homeMemory, global int *slotOf) {
    int r = (int) get_global_id(0);
    if (r >= count || (links[r].y & 1) == 0) return;
    int id = records[r * RECORD + 1];
    int slot = slotOf[id];
    for (; r >= 0; r = links[r].x) {
        global const int *record = records + r * RECORD;
        float a = as_float(record[2]);
        float b = as_float(record[3]);
        switch (record[0]) {
        case ADD:
            slot = links[r].y >> 1;
            homeCircle[slot] = (float4)(a, b, as_float(record[4]), as_float(record[5]));
            homeMotion[slot] = (float4)(0.0f, 0.0f, as_float(record[7]), as_float(record[8]));
            homeTraits[slot] = (float4)(inverseMass(as_float(record[5])), as_float(record[6]), 0.0f, 0.0f);
            homeId[slot] = id;
            homeMemory[slot] = FRESH;
            slotOf[id] = slot;
            break;
        case REMOVE:
            homeId[slot] = NONE;
            slotOf[id] = NONE;
            break;
        case POSITION:
            homeCircle[slot].x = a;
            homeCircle[slot].y = b;
            homeMotion[slot].x = 0.0f;
            homeMotion[slot].y = 0.0f;
            break;
        case VELOCITY:
            homeMotion[slot].z = a;
            homeMotion[slot].w = b;
            break;
        case RADIUS:
            homeCircle[slot].z = a;
            homeMemory[slot] = FRESH;
            homeTraits[slot].z = 0.0f;
            homeTraits[slot].w = 0.0f;
            break;
        case MASS:
            homeCircle[slot].w = a;
            homeTraits[slot].x = inverseMass(a);
            homeMemory[slot] = FRESH;
            homeTraits[slot].z = 0.0f;
            homeTraits[slot].w = 0.0f;
            break;
        case RESTITUTION:
            homeTraits[slot].y = a;
            break;
        case IMPULSE:
            homeMotion[slot].z = afterImpulse(homeMotion[slot].z, homeTraits[slot].x, a);
            homeMotion[slot].w = afterImpulse(homeMotion[slot].w, homeTraits[slot].x, b);
            break;
        }
    }
}

// Brings circles that changed bounds have left outside to the nearest place inside. Index space: a slot at home a
// work-item.
kernel void commands_confine(global const int *homeId, global float4 *homeCircle, global float4 *homeMotion,
                             global const float4 *homeTraits, int slots, float minX, float minY, float maxX,
                             float maxY) {
    int slot = (int) get_global_id(0);
    if (slot >= slots || homeId[slot] < 0) return;
    float4 c = homeCircle[slot];
    float edge = homeTraits[slot].x == 0.0f ? 0.0f : c.z;
    float x = bounded(c.x, minX + edge, maxX - edge);
    float y = bounded(c.y, minY + edge, maxY - edge);
    if (x != c.x) {
        homeCircle[slot].x = x;
        homeMotion[slot].x = 0.0f;
    }
    if (y != c.y) {
        homeCircle[slot].y = y;
        homeMotion[slot].y = 0.0f;
    }
}
