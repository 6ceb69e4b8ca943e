// uses: world/shared/Sleep.cl world/shared/Surface.cl world/shared/Walls.cl world/stages/World.cl
// Applies the records of the Java class Commands. The host links those of one circle in call order; circles are independent.

#ifdef SLEEPING
#define CHANGED_PARAMETER , global float4 *changed

// As one that has not begun to come to rest.
int4 restarted(float4 c, float4 m) {
    bool isStatic = inverseMass(c.MASS) == 0.0f;
    return (int4)(0, as_int(isStatic ? 0.0f : 0.0f - m.DX), as_int(isStatic ? 0.0f : 0.0f - m.DY), 0);
}

bool isOfSurfaceOrKind(int field) {
    return field == FIELD_KIND || field == FIELD_GROUP || (field >= TURNING_FIELDS && field < TURNING_FIELDS + SURFACE_FIELDS);
}

bool isOfMotion(int field) { return field >= MOTION_FIELDS; }

// Whether an operation wakes its circle.
bool wakesItself(global const int *record) {
    int field = record[COMMAND_FIRST];
    switch (record[COMMAND_OPCODE]) {
    case COMMAND_ADD:
    case COMMAND_REMOVE:
    case COMMAND_DEPART:
    case COMMAND_ARRIVE:
        return false;
    case COMMAND_FIELD:
        return isOfSurfaceOrKind(field) || isOfMotion(field);
    default:
        return true;
    }
}

// The circle before a change by which others may lose what carries them; of no mass if there is none.
float4 changedBefore(global const int *record, float4 c) {
    int operation = record[COMMAND_OPCODE];
    bool wakes = operation == COMMAND_REMOVE || operation == COMMAND_POSITION || operation == COMMAND_RADIUS ||
                 operation == COMMAND_GROW || operation == COMMAND_MASS;
    return wakes ? c : (float4)(0.0f);
}

// The circle behind a change that may push others.
float4 changedBehind(global const int *record, float4 c) {
    int operation = record[COMMAND_OPCODE];
    int field = record[COMMAND_FIRST];
    bool wakes = operation == COMMAND_POSITION || operation == COMMAND_RADIUS || operation == COMMAND_GROW ||
                 operation == COMMAND_MASS || operation == COMMAND_ANGULAR_VELOCITY || operation == COMMAND_ARRIVE ||
                 (operation == COMMAND_ADD && inverseMass(c.MASS) == 0.0f) ||
                 (operation == COMMAND_FIELD && isOfSurfaceOrKind(field));
    return wakes ? c : (float4)(0.0f);
}
#else
#define CHANGED_PARAMETER
#endif

// Index space: a record. Cost: the records of its circle. links: the next record of the circle or -1; twice the slot of a new circle, plus
// 1 for its first.
kernel void commands_apply(WORLD_PARAMETERS, global const int *records, global const int2 *links, int count CHANGED_PARAMETER) {
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
#ifdef SLEEPING
        bool wakes = wakesItself(record);
        changed[2 * r] = changedBefore(record, slot < 0 ? (float4)(0.0f) : w.homeCircle[slot]);
        if (wakes) w.homeTraits[slot].INVERSE_MASS = inverseMass(w.homeCircle[slot].MASS);
#endif
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
            IF_OWN_MOTION(w.ownMotion[circleId] = INITIAL_MOTION;)
#ifdef TURNING
            w.homeTurn[slot] = (int2)(0);
            w.homeWallRows[slot] = (WallRows)(0.0f);
            w.homeOwn[slot] = INITIAL_OWN;
#endif
            IF_TERRAIN(w.homePieces[slot] = (int2)(0);)
            break;
        case COMMAND_REMOVE:
            w.homeId[slot] = NONE;
            w.slotOf[circleId] = NONE;
            break;
        case COMMAND_POSITION:
            w.homeCircle[slot].xy = (float2)(a, b);
            w.homeMotion[slot].DISPLACEMENT = (float2)(0.0f);
            IF_TERRAIN(w.homePieces[slot] = (int2)(0);)
            break;
        case COMMAND_VELOCITY:
            w.homeMotion[slot].VELOCITY = (float2)(a, b);
            break;
        case COMMAND_RADIUS:
            w.homeCircle[slot].RADIUS = a;
            w.homeFirstCached[slot] = FRESH;
            w.homeTraits[slot].WALLS = (float2)(0.0f);
            IF_TURNING(w.homeWallRows[slot] = (WallRows)(0.0f);)
            IF_TERRAIN(w.homePieces[slot] = (int2)(0);)
            break;
        case COMMAND_GROW:
            w.homeCircle[slot].RADIUS = a;
            break;
        case COMMAND_MASS:
            w.homeCircle[slot].MASS = a;
            w.homeTraits[slot].INVERSE_MASS = inverseMass(a);
            w.homeFirstCached[slot] = FRESH;
            w.homeTraits[slot].WALLS = (float2)(0.0f);
            IF_TURNING(w.homeWallRows[slot] = (WallRows)(0.0f);)
            IF_TERRAIN(w.homePieces[slot] = (int2)(0);)
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
            w.homeMotion[slot].VX = travelSpeed(w.homeCircle[slot].x, a, as_float(record[COMMAND_THIRD]), as_float(record[COMMAND_FOURTH]));
            w.homeMotion[slot].VY = travelSpeed(w.homeCircle[slot].y, b, as_float(record[COMMAND_THIRD]), as_float(record[COMMAND_FIFTH]));
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
#ifdef OWN_MOTION
            if (record[COMMAND_FIRST] >= MOTION_FIELDS) {
                ((global int *) (w.ownMotion + circleId))[record[COMMAND_FIRST] - MOTION_FIELDS] = record[COMMAND_SECOND];
                break;
            }
#endif
#ifdef TURNING
            if (record[COMMAND_FIRST] >= TURNING_FIELDS) {
                ((global int *) (w.homeOwn + slot))[record[COMMAND_FIRST] - TURNING_FIELDS] = record[COMMAND_SECOND];
                break;
            }
#endif
            ((global int *) (w.fields + circleId))[record[COMMAND_FIRST]] = record[COMMAND_SECOND];
            break;
        }
        IF_SLEEPING(if (wakes || record[COMMAND_OPCODE] == COMMAND_ADD) w.homeSleep[slot] = restarted(w.homeCircle[slot], w.homeMotion[slot]);)
        IF_SLEEPING(changed[2 * r + 1] = changedBehind(record, w.homeCircle[slot]);)
    }
}

#ifdef SLEEPING
#define HOME_SLEEP_PARAMETERS , global int4 *homeSleep, float calmMinX, float calmMinY, float calmMaxX, float calmMaxY

int sideOf(float wallImpulse) { return wallImpulse == 0.0f ? 0 : wallImpulse > 0.0f ? 1 : 2; }

// Whether circles of a kind wake, or those that a wall presses as it does one. kinds, walls: a bit of each.
bool wakesBy(global const uint *kinds, int walls, int kind, float4 traits) {
    int pressing = sideOf(traits.WALL_X) | sideOf(traits.WALL_Y) << 2;
    return (kinds[kind / 32] >> (kind % 32) & 1) != 0 || (pressing & walls) != 0;
}

// Wakes circles near to those that have changed, and by kinds and walls if some wake so. Index space: slots at home. Cost: the changes.
kernel void commands_wake(global const int *homeId, global const float4 *homeCircle, global const float4 *homeMotion,
                          global float4 *homeTraits, global int4 *homeSleep, int slots, global const float4 *changed, int changes,
                          float periodX, float periodY, int some, global const uint *kinds, int walls,
                          global const CircleFields *fields) {
    int slot = (int) get_global_id(0);
    if (slot >= slots || homeId[slot] < 0 || !isAsleep(homeSleep[slot].REST)) return;
    float4 c = homeCircle[slot];
    bool near = some != 0 && wakesBy(kinds, walls, fields[homeId[slot]].kind, homeTraits[slot]);
    for (int k = 0; k < changes && !near; k++) {
        float4 o = changed[k];
        float far = SLEEP_NEIGHBOURS * (c.RADIUS + o.RADIUS);
        near = o.MASS > 0.0f && fabs(shortWay(o.x - c.x, periodX)) <= far && fabs(shortWay(o.y - c.y, periodY)) <= far;
    }
    if (!near) return;
    homeTraits[slot].INVERSE_MASS = inverseMass(c.MASS);
    homeSleep[slot] = restarted(c, homeMotion[slot]);
}
#else
#define HOME_SLEEP_PARAMETERS
#endif

// Brings circles outside of new bounds to the nearest place inside, unless the next step pushes them there. Wakes those that sleep and
// reach out of the calm bounds. Index space: slots at home.
kernel void commands_confine(global const int *homeId, global float4 *homeCircle, global float4 *homeMotion,
                             global float4 *homeTraits, int slots, float minX, float minY, float maxX,
                             float maxY, float fromMinX, float fromMinY, float fromMaxX, float fromMaxY HOME_SLEEP_PARAMETERS) {
    int slot = (int) get_global_id(0);
    if (slot >= slots || homeId[slot] < 0) return;
    float4 c = homeCircle[slot];
    float edge = awakeInverseMass(c, homeTraits[slot].INVERSE_MASS) == 0.0f ? 0.0f : c.RADIUS;
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
#ifdef SLEEPING
    float far = SLEEP_NEIGHBOURS * c.RADIUS;
    bool calm = !isAsleep(homeSleep[slot].REST) ||
                (c.x - far >= calmMinX && c.x + far <= calmMaxX && c.y - far >= calmMinY && c.y + far <= calmMaxY);
    if (x != c.x || y != c.y || !calm) {
        homeTraits[slot].INVERSE_MASS = inverseMass(c.MASS);
        homeSleep[slot] = restarted(c, homeMotion[slot]);
    }
#endif
}
