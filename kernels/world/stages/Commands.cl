// uses: world/stages/World.cl
// Applies what the caller asked for since the last step: records of the Java class Commands. The host links the records
// of one circle in call order (next) and marks the first of each; circles are independent of each other.

// Index space: a record a work-item. Cost: the records of one circle.
// links: for each record, the next of the same circle or -1, and (slot of a new circle) * 2, plus 1 where it is its
// circle's first.
kernel void commands_apply(WORLD_PARAMETERS, global const int *records, global const int2 *links, int count) {
    int r = (int) get_global_id(0);
    if (r >= count || (links[r].y & 1) == 0) return;
    int circleId = records[r * COMMAND_STRIDE + COMMAND_ID];
    int slot = slotOf[circleId];
    CircleFields initial = INITIAL_FIELDS;
    for (; r >= 0; r = links[r].x) {
        global const int *record = records + r * COMMAND_STRIDE;
        float a = as_float(record[COMMAND_FIRST]);
        float b = as_float(record[COMMAND_SECOND]);
        switch (record[COMMAND_OPCODE]) {
        case COMMAND_ADD:
            slot = links[r].y >> 1;
            homeCircle[slot] = (float4)(as_float(record[COMMAND_ADD_X]), as_float(record[COMMAND_ADD_Y]),
                                        as_float(record[COMMAND_ADD_RADIUS]), as_float(record[COMMAND_ADD_MASS]));
            homeMotion[slot] = (float4)(0.0f, 0.0f, as_float(record[COMMAND_ADD_VX]), as_float(record[COMMAND_ADD_VY]));
            homeTraits[slot] = (float4)(inverseMass(as_float(record[COMMAND_ADD_MASS])),
                                        as_float(record[COMMAND_ADD_RESTITUTION]), 0.0f, 0.0f);
            homeId[slot] = circleId;
            homeFirstCached[slot] = FRESH;
            slotOf[circleId] = slot;
            fields[circleId] = initial;
            break;
        case COMMAND_REMOVE:
            homeId[slot] = NONE;
            slotOf[circleId] = NONE;
            break;
        case COMMAND_POSITION:
            homeCircle[slot].x = a;
            homeCircle[slot].y = b;
            homeMotion[slot].x = 0.0f;
            homeMotion[slot].y = 0.0f;
            break;
        case COMMAND_VELOCITY:
            homeMotion[slot].z = a;
            homeMotion[slot].w = b;
            break;
        case COMMAND_RADIUS:
            homeCircle[slot].z = a;
            homeFirstCached[slot] = FRESH;
            homeTraits[slot].z = 0.0f;
            homeTraits[slot].w = 0.0f;
            break;
        case COMMAND_MASS:
            homeCircle[slot].w = a;
            homeTraits[slot].x = inverseMass(a);
            homeFirstCached[slot] = FRESH;
            homeTraits[slot].z = 0.0f;
            homeTraits[slot].w = 0.0f;
            break;
        case COMMAND_RESTITUTION:
            homeTraits[slot].y = a;
            break;
        case COMMAND_IMPULSE:
            homeMotion[slot].z = afterImpulse(homeMotion[slot].z, homeTraits[slot].x, a);
            homeMotion[slot].w = afterImpulse(homeMotion[slot].w, homeTraits[slot].x, b);
            break;
        case COMMAND_DEPART:
            // A static circle has no impulses of walls: their place keeps its velocity meanwhile.
            homeTraits[slot].zw = homeMotion[slot].zw;
            homeMotion[slot].z = travelSpeed(homeCircle[slot].x, a, as_float(record[COMMAND_THIRD]),
                                             as_float(record[COMMAND_FOURTH]));
            homeMotion[slot].w = travelSpeed(homeCircle[slot].y, b, as_float(record[COMMAND_THIRD]),
                                             as_float(record[COMMAND_FIFTH]));
            break;
        case COMMAND_ARRIVE:
            homeCircle[slot].x = a;
            homeCircle[slot].y = b;
            homeMotion[slot] = (float4)(0.0f, 0.0f, homeTraits[slot].z, homeTraits[slot].w);
            homeTraits[slot].z = 0.0f;
            homeTraits[slot].w = 0.0f;
            break;
        case COMMAND_FIELD:
            ((global int *) (fields + circleId))[record[COMMAND_FIRST]] = record[COMMAND_SECOND];
            break;
        }
    }
}

// Brings circles that changed bounds have left outside to the nearest place inside, unless the next step pushes them there. Index space: a slot at home a
// work-item.
kernel void commands_confine(global const int *homeId, global float4 *homeCircle, global float4 *homeMotion,
                             global const float4 *homeTraits, int slots, float minX, float minY, float maxX,
                             float maxY, float fromMinX, float fromMinY, float fromMaxX, float fromMaxY) {
    int slot = (int) get_global_id(0);
    if (slot >= slots || homeId[slot] < 0) return;
    float4 c = homeCircle[slot];
    float edge = homeTraits[slot].x == 0.0f ? 0.0f : c.z;
    float x = bounded(c.x, minX + marginAtWall(fromMinX, minX, edge), maxX - marginAtWall(fromMaxX, maxX, edge));
    float y = bounded(c.y, minY + marginAtWall(fromMinY, minY, edge), maxY - marginAtWall(fromMaxY, maxY, edge));
    if (x != c.x) {
        homeCircle[slot].x = x;
        homeMotion[slot].x = 0.0f;
    }
    if (y != c.y) {
        homeCircle[slot].y = y;
        homeMotion[slot].y = 0.0f;
    }
}
