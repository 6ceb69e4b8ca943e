// uses: world/shared/Sleep.cl world/stages/World.cl
// The state by id, for one copy to the host. Index space: slots at home.

kernel void readback_circles(global const int *homeId, global const float4 *homeCircle, int slots, global float4 *byId) {
    int slot = (int) get_global_id(0);
    if (slot < slots && homeId[slot] >= 0) byId[homeId[slot]] = homeCircle[slot];
}

kernel void readback_positions(global const int *homeId, global const float4 *homeCircle, int slots, global float2 *byId) {
    int slot = (int) get_global_id(0);
    if (slot < slots && homeId[slot] >= 0) byId[homeId[slot]] = homeCircle[slot].xy;
}

// In front the number of steps, by which the host knows whether they are those that it asked for.
kernel void readback_request(global const int *homeId, global const float4 *homeCircle, int slots,
                             global const int *status, global float2 *byId) {
    int slot = (int) get_global_id(0);
    if (slot == 0) *(global int *) byId = status[STEPS_DONE];
    if (slot < slots && homeId[slot] >= 0) byId[1 + homeId[slot]] = homeCircle[slot].xy;
}

#ifdef TURNING
// velocities: angular velocities, not angles.
kernel void readback_turns(global const int *homeId, global const int2 *homeTurn, int slots, global int *byId, int velocities) {
    int slot = (int) get_global_id(0);
    if (slot >= slots || homeId[slot] < 0) return;
    byId[homeId[slot]] = velocities ? homeTurn[slot].ANGULAR_VELOCITY : homeTurn[slot].ANGLE;
}
#endif

kernel void readback_velocities(global const int *homeId, global const float4 *homeMotion, int slots, global float2 *byId) {
    int slot = (int) get_global_id(0);
    if (slot < slots && homeId[slot] >= 0) byId[homeId[slot]] = homeMotion[slot].VELOCITY;
}

#ifdef SLEEPING
// A bit an id, of circles that sleep. Index space: words of 32 ids.
kernel void readback_asleep(global const int *slotOf, global const int4 *homeSleep, int ids, global uint *byId) {
    int word = (int) get_global_id(0);
    uint bits = 0;
    for (int k = 0; k < 32 && 32 * word + k < ids; k++) {
        int slot = slotOf[32 * word + k];
        if (slot >= 0 && isAsleep(homeSleep[slot].REST)) bits |= 1u << k;
    }
    if (32 * word < ids) byId[word] = bits;
}
#endif
