// uses: world/shared/Drive.cl world/stages/CrossSolver.cl world/stages/Joints.cl
// Circles near to bodies that are pushed, which the host has: it takes copies, and gives them back between the passes. The Java class
// world.device.plan.BodyStage says what the words are; world.jvm.HostBodies reads and writes them.

#ifdef BODIES
#define BOX_ROUNDING 0x1p-19f // of coordinates: more than those of boxes are rounded by
#define SENSED_REACH 1.03f // of a radius: a bit more than the Java class RigidSensing takes

// How far from its centre a circle looks for bodies: a bit more than in the Java class RigidSearch, which decides.
float reachForBodies(const World *w, int id, float4 c, float4 m) {
    float invMass = inverseMass(c.MASS);
    float2 gain_ = invMass == 0.0f ? (float2)(0.0f) : gainOf(w, id, invMass);
    float way = w->k.dt * (lengthf(m.VX, m.VY) + lengthf(gain_.x, gain_.y) * (float) w->k.subSteps);
    return 1.001f * (c.RADIUS + 2.25f * (MARGIN * c.RADIUS + 0.5f * way));
}

// Whether a place that reaches so far may meet a box of least x and y, greatest x and y.
bool isNearBox(const World *w, float2 c, float2 reach, float4 box) {
    float dx = fabs(ACROSS_X(w, c.x - 0.5f * (box.x + box.z)));
    float dy = fabs(ACROSS_Y(w, c.y - 0.5f * (box.y + box.w)));
    float farX = reach.x + 0.5f * (box.z - box.x);
    float farY = reach.y + 0.5f * (box.w - box.y);
    float roundingX = BOX_ROUNDING * (fabs(c.x) + fabs(box.x) + fabs(box.z) + farX);
    float roundingY = BOX_ROUNDING * (fabs(c.y) + fabs(box.y) + fabs(box.w) + farY);
    return dx <= farX + roundingX && dy <= farY + roundingY;
}

void copyForBodies(const World *w, int slot, int id, global int *to) {
    CircleFields f = w->fields[id];
    global float *row = (global float *) to;
    vstore4((int4)(id, f.kind, f.group, f.forceX), 0, to);
    vstore4((int4)(f.forceY, slot, as_int(w->surfaceSpeed[slot]), as_int(w->inverseInertia[slot])), 1, to);
    vstore4(w->circle[slot], 2, row);
    vstore4(w->motion[slot], 3, row);
    vstore4(w->traits[slot], 4, row);
    IF_OWN_MOTION(vstore4(w->ownMotion[id], 5, row);)
    to[23] = w->turn[slot].ANGLE;
    vstore8(vload8(0, surfaceOfCircle(w, slot)), 3, row);
}

// Index space: slots. Cost: the boxes. found: how many circles are near, whether the step is refused; from BODY_BOXES on the boxes; behind
// them room for so many circles.
kernel void bodies_find(WORLD_PARAMETERS, global int *found, int boxes, int room) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot == 0) found[1] = refused(&w);
    if (slot >= circles || refused(&w)) return;
    int id = w.id[slot];
    float4 c = w.circle[slot];
    float reach = reachForBodies(&w, id, c, w.motion[slot]);
    global const float *box = (global const float *) (found + BODY_BOXES);
    for (int k = 0; k < boxes; k++) {
        if (isNearBox(&w, c.xy, (float2)(reach), vload4(k, box))) {
            int place = atomic_inc(found);
            if (place < room) copyForBodies(&w, slot, id, found + BODY_BOXES + 4 * boxes + BODY_NEAR_WORDS * place);
            return;
        }
    }
}

// Behind the step: circles that bodies may sense, by where these have been in it. As bodies_find.
kernel void bodies_sense(WORLD_PARAMETERS, global int *found, int boxes, int room) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles) return;
    int id = w.homeId[slot];
    float4 from = w.circle[slot];
    float2 to = w.homeCircle[slot].xy;
    float2 way = 0.5f * (float2)(ACROSS_X(&w, to.x - from.x), ACROSS_Y(&w, to.y - from.y));
    float2 reach = (float2)(fabs(way.x), fabs(way.y)) + SENSED_REACH * from.RADIUS;
    global const float *box = (global const float *) (found + BODY_BOXES);
    for (int k = 0; k < boxes; k++) {
        if (isNearBox(&w, from.xy + way, reach, vload4(k, box))) {
            int place = atomic_inc(found);
            if (place < room) {
                global int *row = found + BODY_BOXES + 4 * boxes + BODY_SENSED_WORDS * place;
                vstore4((int4)(id, w.fields[id].kind, w.fields[id].group, as_int(from.RADIUS)), 0, row);
                vstore4((float4)(from.x, from.y, to.x, to.y), 1, (global float *) row);
            }
            return;
        }
    }
}

#ifdef JOINTS
// Circles that joints hold to bodies, before continuous collision. Index space: these, of which held has the ids.
kernel void bodies_free(WORLD_PARAMETERS, global const int *held, int count) {
    World w = WORLD;
    int k = (int) get_global_id(0);
    if (k < count && !refused(&w)) freeFromPath(&w, slotOfCircle(&w, held[k]));
}
#endif

#if defined(SLEEPING) && !defined(JOINTS)
int slotOfCircle(const World *w, int id) { return workingSlotOf(w)[w->slotOf[id]]; }
#endif

#if defined(JOINTS) || defined(SLEEPING)
// Circles that the host names, behind bodies_find, which may have found them too. Index space: these, of which named has the ids.
kernel void bodies_name(WORLD_PARAMETERS, global const int *named, int count, global int *found, int boxes, int room) {
    World w = WORLD;
    int k = (int) get_global_id(0);
    if (k >= count || refused(&w)) return;
    int place = atomic_inc(found);
    if (place < room) {
        copyForBodies(&w, slotOfCircle(&w, named[k]), named[k], found + BODY_BOXES + 4 * boxes + BODY_NEAR_WORDS * place);
    }
}
#endif

// Index space of both: circles at bodies, of which slots has the slots.

kernel void bodies_take(WORLD_PARAMETERS, global const int *slots_, int count, global float *rows) {
    World w = WORLD;
    int k = (int) get_global_id(0);
    if (k >= count) return;
    int slot = slots_[k];
    global float *row = rows + BODY_ROW_WORDS * k;
    w = crossWorld(w);
    vstore4(w.motion[slot], 0, row);
    vstore4(w.load[slot], 1, row);
    vstore4((float4)(crossSpeeds(&w)[slot], w.spinImpulse[slot], w.motionClamp[slot].ALLOWANCE, w.turned[slot]), 2, row);
}

kernel void bodies_give(WORLD_PARAMETERS, global const int *slots_, int count, global const float *rows) {
    World w = WORLD;
    int k = (int) get_global_id(0);
    if (k >= count) return;
    int slot = slots_[k];
    global const float *row = rows + BODY_ROW_WORDS * k;
    float4 last = vload4(2, row);
    w = crossWorld(w);
    w.motion[slot] = vload4(0, row);
    w.load[slot] = vload4(1, row);
    crossSpeeds(&w)[slot] = last.x;
    w.spinImpulse[slot] = last.y;
    ((global float *) (w.motionClamp + slot))[ALLOWANCE_AT] = last.z;
}
#endif
