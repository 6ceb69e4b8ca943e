// uses: world/shared/Surface.cl world/shared/Walls.cl world/stages/World.cl
// Applies the records of the Java class Commands. The host links those of one circle in call order; circles are independent.

// Index space: a record. Cost: the records of its circle. links: the next record of the circle or -1; twice the slot of a new circle, plus
// 1 for its first.
kernel void commands_apply(WORLD_PARAMETERS, global const int *records, global const int2 *links, int count) {
    World w = WORLD;
    int r = (int) get_global_id(0);
    if (r >= count || (links[r].y & 1) == 0) return;
    int circleId = records[r * COMMAND_STRIDE + COMMAND_ID];
    int slot = w.slotOf[circleId];
    CircleFields initial = INITIAL_FIELDS;
    for (; r >= 0; r = links[r].x) {
        global const int *record = records + r * COMMAND_STRIDE;
        float a = as_float(record[COMMAND_FIRST]);
        float b = as_float(record[COMMAND_SECOND]);
        switch (record[COMMAND_OPCODE]) {
        case COMMAND_ADD:
            slot = links[r].y >> 1;
            w.homeCircle[slot] = (float4)(as_float(record[COMMAND_ADD_X]), as_float(record[COMMAND_ADD_Y]),
                                        as_float(record[COMMAND_ADD_RADIUS]), as_float(record[COMMAND_ADD_MASS]));
            w.homeMotion[slot] = (float4)(0.0f, 0.0f, as_float(record[COMMAND_ADD_VX]), as_float(record[COMMAND_ADD_VY]));
            w.homeTraits[slot] = (float4)(inverseMass(as_float(record[COMMAND_ADD_MASS])),
                                        as_float(record[COMMAND_ADD_RESTITUTION]), 0.0f, 0.0f);
            w.homeId[slot] = circleId;
            w.homeFirstCached[slot] = FRESH;
            w.slotOf[circleId] = slot;
            w.fields[circleId] = initial;
#ifdef TURNING
            w.homeTurn[slot] = (int2)(0);
            w.homeWallRows[slot] = (WallRows)(0.0f);
            w.homeOwn[slot] = INITIAL_OWN;
#endif
#ifdef TERRAIN
            w.homePieces[slot] = (int2)(0);
#endif
            break;
        case COMMAND_REMOVE:
            w.homeId[slot] = NONE;
            w.slotOf[circleId] = NONE;
            break;
        case COMMAND_POSITION:
            w.homeCircle[slot].xy = (float2)(a, b);
            w.homeMotion[slot].DISPLACEMENT = (float2)(0.0f);
#ifdef TERRAIN
            w.homePieces[slot] = (int2)(0);
#endif
            break;
        case COMMAND_VELOCITY:
            w.homeMotion[slot].VELOCITY = (float2)(a, b);
            break;
        case COMMAND_RADIUS:
            w.homeCircle[slot].RADIUS = a;
            w.homeFirstCached[slot] = FRESH;
            w.homeTraits[slot].WALLS = (float2)(0.0f);
#ifdef TURNING
            w.homeWallRows[slot] = (WallRows)(0.0f);
#endif
#ifdef TERRAIN
            w.homePieces[slot] = (int2)(0);
#endif
            break;
        case COMMAND_GROW:
            w.homeCircle[slot].RADIUS = a;
            break;
        case COMMAND_MASS:
            w.homeCircle[slot].MASS = a;
            w.homeTraits[slot].INVERSE_MASS = inverseMass(a);
            w.homeFirstCached[slot] = FRESH;
            w.homeTraits[slot].WALLS = (float2)(0.0f);
#ifdef TURNING
            w.homeWallRows[slot] = (WallRows)(0.0f);
#endif
#ifdef TERRAIN
            w.homePieces[slot] = (int2)(0);
#endif
            break;
        case COMMAND_RESTITUTION:
            w.homeTraits[slot].RESTITUTION = a;
            break;
        case COMMAND_IMPULSE:
            w.homeMotion[slot].VX = afterImpulse(w.homeMotion[slot].VX, w.homeTraits[slot].INVERSE_MASS, a);
            w.homeMotion[slot].VY = afterImpulse(w.homeMotion[slot].VY, w.homeTraits[slot].INVERSE_MASS, b);
            break;
        case COMMAND_DEPART:
            w.homeTraits[slot].KEPT_VELOCITY = w.homeMotion[slot].VELOCITY;
            w.homeMotion[slot].VX = travelSpeed(w.homeCircle[slot].x, a, as_float(record[COMMAND_THIRD]),
                                             as_float(record[COMMAND_FOURTH]));
            w.homeMotion[slot].VY = travelSpeed(w.homeCircle[slot].y, b, as_float(record[COMMAND_THIRD]),
                                             as_float(record[COMMAND_FIFTH]));
            break;
        case COMMAND_ARRIVE:
            w.homeCircle[slot].xy = (float2)(a, b);
            w.homeMotion[slot] = (float4)((float2)(0.0f), w.homeTraits[slot].KEPT_VELOCITY);
            w.homeTraits[slot].WALLS = (float2)(0.0f);
            break;
#ifdef TURNING
        case COMMAND_ANGLE:
            w.homeTurn[slot].ANGLE = record[COMMAND_FIRST];
            break;
        case COMMAND_ANGULAR_VELOCITY:
            w.homeTurn[slot].ANGULAR_VELOCITY = record[COMMAND_FIRST];
            break;
        case COMMAND_ANGULAR_IMPULSE:
            w.homeTurn[slot].ANGULAR_VELOCITY =
                as_int(afterAngularImpulse(as_float(w.homeTurn[slot].ANGULAR_VELOCITY), a, w.homeCircle[slot].RADIUS,
                                           w.homeTraits[slot].INVERSE_MASS * b));
            break;
#endif
        case COMMAND_FIELD:
#ifdef TURNING
            if (record[COMMAND_FIRST] >= TURNING_FIELDS) {
                ((global int *) (w.homeOwn + slot))[record[COMMAND_FIRST] - TURNING_FIELDS] = record[COMMAND_SECOND];
                break;
            }
#endif
            ((global int *) (w.fields + circleId))[record[COMMAND_FIRST]] = record[COMMAND_SECOND];
            break;
        }
    }
}

// Brings circles outside of new bounds to the nearest place inside, unless the next step pushes them there. Index space: slots at home.
kernel void commands_confine(global const int *homeId, global float4 *homeCircle, global float4 *homeMotion,
                             global const float4 *homeTraits, int slots, float minX, float minY, float maxX,
                             float maxY, float fromMinX, float fromMinY, float fromMaxX, float fromMaxY) {
    int slot = (int) get_global_id(0);
    if (slot >= slots || homeId[slot] < 0) return;
    float4 c = homeCircle[slot];
    float edge = homeTraits[slot].INVERSE_MASS == 0.0f ? 0.0f : c.RADIUS;
    float x = clampf(c.x, minX + marginAtWall(fromMinX, minX, edge), maxX - marginAtWall(fromMaxX, maxX, edge));
    float y = clampf(c.y, minY + marginAtWall(fromMinY, minY, edge), maxY - marginAtWall(fromMaxY, maxY, edge));
    if (x != c.x) {
        homeCircle[slot].x = x;
        homeMotion[slot].DX = 0.0f;
    }
    if (y != c.y) {
        homeCircle[slot].y = y;
        homeMotion[slot].DY = 0.0f;
    }
}
