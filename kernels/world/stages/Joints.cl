// uses: world/shared/JointVisit.cl world/shared/Sleep.cl world/stages/CrossSolver.cl
// The joints' part of stage Solver: passes between those over like and over cross contacts. A work-group visits a batch, colour by colour; joints in
// no batch have a launch a colour. Then split joints see the circles as these have left them, and circles take the sums. The Java
// classes JointPasses and SplitJoints do the same.

#ifdef JOINTS
// A table, by the words before it.
global int *jointTable(const World *w, int at) { return (global int *) w->joints + at; }
global float4 *jointVectors(const World *w, int at) { return (global float4 *) jointTable(w, at); }
int jointAt(const World *w, int place) { return jointTable(w, w->joints->order)[place]; }
global int *jointSerial(const World *w, int joint) { return jointTable(w, w->joints->serial) + joint; }
global float4 *keptOf(const World *w, int joint) { return jointVectors(w, w->joints->state) + 2 * joint; }
global float4 *workOf(const World *w, int place) { return jointVectors(w, w->joints->work) + 3 * place; }

// Working slots of A and B, or NONE; A has none if the joint does nothing in the step, and B has one if it rests then.
global int2 *endsOf(const World *w, int place) { return (global int2 *) jointTable(w, w->joints->ends) + place; }

void takeTraits(const World *w, int joint, JointVisit *v) {
    global const int4 *traits = (global const int4 *) jointTable(w, w->joints->traits) + 2 * joint;
    v->traits[0] = traits[0];
    v->traits[1] = traits[1];
}

void takeRows(const World *w, int joint, JointVisit *v) {
    global const float4 *row = jointVectors(w, w->joints->rows) + 3 * joint;
    for (int k = 0; k < 3; k++) v->row[k] = row[k];
    v->kept[0] = keptOf(w, joint)[0];
    v->kept[1] = keptOf(w, joint)[1];
}

void takeSpring(const World *w, JointVisit *v) {
    v->spring[0] = (float4)(0.0f);
    if (holds(v, HOLD_ELASTIC) || angularOf(v) == HOLD_TURN_ANGLE) {
        v->spring[0] = jointVectors(w, w->joints->springs)[v->HOLD_SPRING];
    }
}

// Once circles are sorted.
int slotOfCircle(const World *w, int id) { return id == NONE ? NONE : workingSlotOf(w)[w->slotOf[id]]; }

#ifdef SLEEPING
// Whether a circle sleeps, and gets nothing. slot: or NONE.
bool isStill(const World *w, int slot) { return slot != NONE && isAsleep(w->sleep[slot].REST); }

// Whether a circle of a joint sleeps, and none that a step could move is awake.
bool jointRests(const World *w, int2 ends) {
    return (isStill(w, ends.x) || isStill(w, ends.y)) && w->traits[ends.x].INVERSE_MASS == 0.0f &&
           (ends.y == NONE || w->traits[ends.y].INVERSE_MASS == 0.0f);
}

#ifdef TURNING
float ownInverseInertia(const World *w, int slot) {
    return ownInverseMass(w, slot) * w->surfaces[SURFACE_STRIDE * w->fields[w->id[slot]].kind + SURFACE_INERTIA];
}
#endif
#endif

// The circle may leave its free path.
void freeFromPath(const World *w, int slot) {
    if (slot != NONE) ((global float *) (w->motionClamp + slot))[ALLOWANCE_AT] = INFINITY;
}

// Finds the circles of a joint that has not broken. It may be done for a step that is refused then. place: also the number of a circle of split
// joints.
void findJoint(const World *w, int place) {
    if (place < w->joints->splitCircles) {
        jointTable(w, w->joints->shares)[place] = 0;
        global long2 *sums = (global long2 *) jointTable(w, w->joints->sums) + 3 * place;
        for (int k = 0; k < 3; k++) sums[k] = (long2)(0);
    }
    if (place >= w->joints->count) return;
    int joint = jointAt(w, place);
    JointVisit v;
    takeTraits(w, joint, &v);
    int2 ends = (int2)(NONE);
    if (*jointSerial(w, joint) != ~v.HOLD_SERIAL) {
        ends = (int2)(slotOfCircle(w, v.HOLDS_A), slotOfCircle(w, v.HOLDS_B));
#ifdef SLEEPING
        if (jointRests(w, ends)) {
            *endsOf(w, place) = (int2)(NONE, 0);
            return;
        }
#endif
        freeFromPath(w, ends.x);
        freeFromPath(w, ends.y);
    }
    *endsOf(w, place) = ends;
}

// Index space: places in the order, and numbers of circles of split joints.
kernel void joints_find(WORLD_PARAMETERS) {
    World w = WORLD;
    if (!refused(&w)) findJoint(&w, (int) get_global_id(0));
}

// The numbers of the circles of a split joint.
int2 splitEndsOf(const World *w, int place) {
    return ((global const int2 *) jointTable(w, w->joints->splitEnds))[place - w->joints->splitStart];
}

// Scales the impulses of the step before; a new joint has none. Once a step, which is not refused.
void beginJoint(const World *w, int place) {
    int2 ends = *endsOf(w, place);
    int joint = jointAt(w, place);
    if (ends.x == NONE) {
        if (ends.y != NONE) { // it rests
            keptOf(w, joint)[0] *= w->warmScale;
            keptOf(w, joint)[1] *= w->warmScale;
        }
        return;
    }
    JointVisit v;
    takeTraits(w, joint, &v);
    global int *serial = jointSerial(w, joint);
    global float4 *kept = keptOf(w, joint);
    bool isNew = *serial != v.HOLD_SERIAL;
    *serial = v.HOLD_SERIAL;
    v.kept[0] = isNew ? (float4)(0.0f) : kept[0];
    v.kept[1] = isNew ? (float4)(0.0f) : kept[1];
    takeSpring(w, &v);
    v.KEPT_AXIAL *= w->warmScale;
    v.KEPT_ACROSS *= w->warmScale;
    v.KEPT_LOWER *= w->warmScale;
    v.KEPT_UPPER *= w->warmScale;
    v.KEPT_ANGULAR *= w->warmScale;
    forgetExact(&v);
    v.KEPT_SUM_X = 0.0f;
    v.KEPT_SUM_Y = 0.0f;
    v.KEPT_SUM_ANGULAR = 0.0f;
    kept[0] = v.kept[0];
    kept[1] = v.kept[1];
    if (place >= w->joints->splitStart) {
        int2 numbers = splitEndsOf(w, place);
        global int *shares = jointTable(w, w->joints->shares);
        if (numbers.x >= 0) atomic_inc(shares + numbers.x);
        if (numbers.y >= 0) atomic_inc(shares + numbers.y);
    }
}

// Index space: places in the order.
kernel void joints_begin(WORLD_PARAMETERS) {
    World w = WORLD;
    int place = (int) get_global_id(0);
    if (place < w.joints->count && !refused(&w)) beginJoint(&w, place);
}

// By how much an impulse moves an end.
float givenMass(const JointEnd *e) {
    IF_SLEEPING(if (e->still) return 0.0f;)
    return e->inverseMass;
}

// solving: with the velocity as the sub-step began, for springs.
void takeCircle(const World *w, int slot, bool solving, JointEnd *e) {
    e->m = w->motion[slot];
    if (solving) {
        float2 fall = givenMass(e) == 0.0f ? (float2)(0.0f) : gainOf(w, w->id[slot], e->inverseMass);
        e->began = w->load[slot].BEFORE - fall;
    }
}

#ifdef TURNING
void takeSpin(const World *w, int slot, JointEnd *e) {
    float r = w->circle[slot].RADIUS;
    e->radius = r;
    e->speed = crossSpeeds(w)[slot];
    e->turned = w->turned[slot] * w->k.h / r;
    e->angle = w->turn[slot].ANGLE;
}
#endif

// At a boundary of sub-steps. An anchor at rest has row 0.
void takeAnchor(const World *w, int row, int boundary, JointEnd *e) {
    e->m = jointVectors(w, w->joints->anchors)[row * (w->k.subSteps + 1) + boundary];
    e->began = e->m.VELOCITY;
#ifdef TURNING
    e->radius = 1.0f;
    e->speed = 0.0f;
    e->turned = 0.0f;
    e->angle = 0;
#endif
}

// What a joint is, and where its ends are.
void takeJoint(const World *w, int place, int2 ends, int boundary, bool solving, JointVisit *v) {
    int joint = jointAt(w, place);
    takeTraits(w, joint, v);
    takeRows(w, joint, v);
    takeSpring(w, v);
    v->h = w->k.h;
    v->inverseH = w->k.inverseH;
    v->begunX = v->begunY = v->distance = v->direction = 0.0f;
    bool hasB = ends.y != NONE;
    bool needsBegun = solving && holds(v, HOLD_ELASTIC);
    takeCircle(w, ends.x, needsBegun, &v->a);
    if (hasB) {
        takeCircle(w, ends.y, needsBegun, &v->b);
    } else {
        takeAnchor(w, v->HOLD_ANCHOR, boundary, &v->b);
    }
#ifdef TURNING
    if (turnsEnds(v)) {
        takeSpin(w, ends.x, &v->a);
        if (hasB) takeSpin(w, ends.y, &v->b);
    }
#endif
}

// What the step has measured of it.
void takeWork(const World *w, int place, JointVisit *v) {
    global const float4 *work = workOf(w, place);
    float4 line = work[0];
    float4 masses = work[1];
    float2 shares = work[2].xy;
    IF_SLEEPING(v->a.still = ((int) work[2].w & JOINT_STILL_A) != 0;)
    IF_SLEEPING(v->b.still = ((int) work[2].w & JOINT_STILL_B) != 0;)
    v->most = work[2].z;
    v->baseX = line.x;
    v->baseY = line.y;
    v->normalX = line.z;
    v->normalY = line.w;
    v->a.inverseMass = masses.x;
    v->b.inverseMass = masses.y;
    IF_TURNING(v->a.inverseInertia = masses.z;)
    IF_TURNING(v->b.inverseInertia = masses.w;)
    v->a.share = shares.x;
    v->b.share = shares.y;
}

bool relaxesAt(const World *w, int place) { return ((int) workOf(w, place)[2].w & JOINT_RELAXES) != 0; }

// The same for the first time.
void beginWork(const World *w, int place, int2 ends, float2 shares, JointVisit *v) {
    bool hasB = ends.y != NONE;
    float4 a = w->circle[ends.x];
    float4 b = (float4)(0.0f);
    if (hasB) {
        b = w->circle[ends.y];
    } else {
        b.xy = (float2)(v->ROW_ANCHOR_X, v->ROW_ANCHOR_Y);
    }
    float4 masses = (float4)(w->traits[ends.x].INVERSE_MASS, hasB ? w->traits[ends.y].INVERSE_MASS : 0.0f, 0.0f, 0.0f);
    IF_TURNING(masses.z = w->inverseInertia[ends.x];)
    IF_TURNING(masses.w = hasB ? w->inverseInertia[ends.y] : 0.0f;)
    int flags = relaxes(v) ? JOINT_RELAXES : 0;
#ifdef SLEEPING
    // A circle that sleeps is pulled as if it would give way.
    if (isStill(w, ends.x)) {
        flags |= JOINT_STILL_A;
        masses.x = ownInverseMass(w, ends.x);
        IF_TURNING(masses.z = ownInverseInertia(w, ends.x);)
    }
    if (isStill(w, ends.y)) {
        flags |= JOINT_STILL_B;
        masses.y = ownInverseMass(w, ends.y);
        IF_TURNING(masses.w = ownInverseInertia(w, ends.y);)
    }
#endif
    global float4 *work = workOf(w, place);
    work[0] = (float4)(ACROSS_X(w, b.x - a.x), ACROSS_Y(w, b.y - a.y), 1.0f, 0.0f);
    work[1] = masses;
    float radius = hasB ? minf(a.RADIUS, b.RADIUS) : a.RADIUS;
    work[2] = (float4)(shares.x, shares.y, greatestPush(radius, w->k.inverseH), (float) flags);
    takeWork(w, place, v);
}

void keepJoint(const World *w, int place, const JointVisit *v) {
    global float4 *kept = keptOf(w, jointAt(w, place));
    kept[0] = v->kept[0];
    kept[1] = v->kept[1];
    workOf(w, place)[0] = (float4)(v->baseX, v->baseY, v->normalX, v->normalY);
}

// Gives it to the velocities.
void giveToCircles(const World *w, int2 ends, const JointVisit *v) {
    float wA = givenMass(&v->a);
    float wB = givenMass(&v->b);
    if (wA != 0.0f) w->motion[ends.x].VELOCITY = (float2)(v->a.m.VX - wA * v->pushX, v->a.m.VY - wA * v->pushY);
    if (wB != 0.0f) w->motion[ends.y].VELOCITY = (float2)(v->b.m.VX + wB * v->pushX, v->b.m.VY + wB * v->pushY);
#ifdef TURNING
    if (!turnsEnds(v)) return;
    global float *speeds = crossSpeeds(w);
    if (wA != 0.0f) speeds[ends.x] = v->a.speed + v->a.inverseInertia * spinOfA(v);
    if (wB != 0.0f) speeds[ends.y] = v->b.speed + v->b.inverseInertia * spinOfB(v);
#endif
}

// Gives it to the sums that the circles begin the next sub-step with.
void giveToLoads(const World *w, int2 ends, const JointVisit *v) {
    if (givenMass(&v->a) != 0.0f) {
        global float *sum = (global float *) (w->load + ends.x) + IMPULSES_AT;
        sum[0] -= v->pushX;
        sum[1] -= v->pushY;
        IF_TURNING(if (turnsEnds(v)) w->spinImpulse[ends.x] += spinOfA(v);)
    }
    if (givenMass(&v->b) != 0.0f) {
        global float *sum = (global float *) (w->load + ends.y) + IMPULSES_AT;
        sum[0] += v->pushX;
        sum[1] += v->pushY;
        IF_TURNING(if (turnsEnds(v)) w->spinImpulse[ends.y] += spinOfB(v);)
    }
}

// Marks circles that the joint cannot bring to where they should be as loaded in the next sub-step.
void loadEnds(const World *w, int2 ends, const JointVisit *v) {
    float strain = strainOf(v);
    if (givenMass(&v->a) != 0.0f && jointLoads(strain, w->circle[ends.x].RADIUS)) {
        ((global float *) (w->load + ends.x))[LOADED_NEXT_AT] = 1.0f;
    }
    if (givenMass(&v->b) != 0.0f && jointLoads(strain, w->circle[ends.y].RADIUS)) {
        ((global float *) (w->load + ends.y))[LOADED_NEXT_AT] = 1.0f;
    }
}

// Sums of a circle of split joints: along x and y, and along its surface.
global long *jointSums(const World *w, int number, bool speeds) {
    return (global long *) jointTable(w, w->joints->sums) + 6 * number + (speeds ? 0 : 3);
}

float jointRange(const World *w, int slot, bool speeds) {
    return speeds ? velocityRangeOf(w, (uint) slot) : impulseRangeOf(w, (uint) slot);
}

void addToSum(const World *w, int number, int slot, bool speeds, float x, float y, float spin) {
    float scale = scaleOf(jointRange(w, slot, speeds));
    global long *sums = jointSums(w, number, speeds);
    addFixed(sums, toFixed(x, scale));
    addFixed(sums + 1, toFixed(y, scale));
    IF_TURNING(addFixed(sums + 2, toFixed(spin, scale));)
}

// Adds what a visit gives to the sums: impulses, or the speeds that they make.
void giveToSums(const World *w, int place, int2 ends, const JointVisit *v, bool speeds) {
    int2 numbers = splitEndsOf(w, place);
    float spinA = 0.0f;
    float spinB = 0.0f;
#ifdef TURNING
    if (turnsEnds(v)) {
        spinA = (speeds ? v->a.inverseInertia : 1.0f) * spinOfA(v);
        spinB = (speeds ? v->b.inverseInertia : 1.0f) * spinOfB(v);
    }
#endif
    if (givenMass(&v->a) != 0.0f) {
        float by = speeds ? v->a.inverseMass : 1.0f;
        addToSum(w, numbers.x, ends.x, speeds, -(by * v->pushX), -(by * v->pushY), spinA);
    }
    if (givenMass(&v->b) != 0.0f) {
        float by = speeds ? v->b.inverseMass : 1.0f;
        addToSum(w, numbers.y, ends.y, speeds, by * v->pushX, by * v->pushY, spinB);
    }
}

void breakJoint(const World *w, int joint) {
    *jointSerial(w, joint) = ~*jointSerial(w, joint);
    int k = atomic_inc(&w->status[JOINTS_BROKEN]);
    ((global int2 *) jointTable(w, w->joints->broken))[k] = (int2)(w->status[STEPS_DONE], joint);
}

float2 sharesOf(const World *w, int place, bool split) {
    if (!split) return (float2)(1.0f);
    int2 numbers = splitEndsOf(w, place);
    global const int *shares = jointTable(w, w->joints->shares);
    return (float2)(numbers.x < 0 ? 1.0f : (float) shares[numbers.x], numbers.y < 0 ? 1.0f : (float) shares[numbers.y]);
}

// A visit in a pass. w: by tiles, as crossWorld has it.
void visitJoint(const World *w, int place, int pass, int subStep, bool split) {
    int2 ends = *endsOf(w, place);
    if (ends.x == NONE) return;
    bool last = pass == JOINT_RELAX && subStep == w->k.subSteps - 1;
    if (pass == JOINT_RELAX && !last && !relaxesAt(w, place)) return;
    JointVisit v;
    int boundary = pass == JOINT_RELAX ? subStep + 1 : subStep;
    if (pass != JOINT_PREPARE) takeWork(w, place, &v);
    takeJoint(w, place, ends, boundary, pass == JOINT_SOLVE, &v);
    bool moves = relaxes(&v);
    if (pass == JOINT_PREPARE) {
        beginWork(w, place, ends, sharesOf(w, place, split), &v);
        measureJoint(&v);
        giveAll(&v);
    } else if (pass == JOINT_SOLVE) {
        solveJoint(w->joints, &v);
    } else if (moves) {
        relaxJoint(w->joints, &v);
    }
    if (pass == JOINT_SOLVE || (pass == JOINT_RELAX && moves)) {
        if (split) {
            giveToSums(w, place, ends, &v, true);
        } else {
            giveToCircles(w, ends, &v);
        }
    }
    if (pass == JOINT_RELAX && moves) endSubStepOfJoint(&v);
    if (pass != JOINT_SOLVE && !last && moves) {
        loadEnds(w, ends, &v);
        if (split) {
            giveToSums(w, place, ends, &v, false);
        } else {
            giveToLoads(w, ends, &v);
        }
    }
    keepJoint(w, place, &v);
    if (last && breaks(&w->k, &v)) breakJoint(w, jointAt(w, place));
}

// The starts of the colours of a batch, or of the joints that are in none, which have the number behind the last batch.
global const int *startsOf(const World *w, int batch) { return jointTable(w, w->joints->starts) + JOINT_BATCH_STRIDE * batch; }

// By a work-group.
void passBatch(const World *w, int batch, int colours, int pass, int subStep) {
    global const int *starts = startsOf(w, batch);
    for (int colour = 0; colour < colours; colour++) {
        int to = starts[colour + 1];
        for (int place = starts[colour] + (int) get_local_id(0); place < to; place += (int) get_local_size(0)) {
            visitJoint(w, place, pass, subStep, false);
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
    }
}

// All joints that are in batches. Index space: a work-group a batch. Cost: its joints.
kernel __attribute__((reqd_work_group_size(JOINT_GROUP, 1, 1))) void joints_passBatches(WORLD_PARAMETERS, int pass, int subStep) {
    World w = WORLD;
    bool idle = refused(&w);
    if (!idle) w = crossWorld(w);
    passBatch(&w, (int) get_group_id(0), idle ? 0 : w.joints->colours, pass, subStep);
}

// Joints of a colour that are in no batch. Index space: these.
kernel void joints_passColour(WORLD_PARAMETERS, int pass, int subStep, int colour) {
    World w = WORLD;
    if (refused(&w)) return;
    w = crossWorld(w);
    global const int *starts = startsOf(&w, w.joints->batches);
    int place = starts[colour] + (int) get_global_id(0);
    if (place < starts[colour + 1]) visitJoint(&w, place, pass, subStep, false);
}

// Split joints, which add to sums. Index space: these.
kernel void joints_passSplit(WORLD_PARAMETERS, int pass, int subStep) {
    World w = WORLD;
    if (refused(&w)) return;
    w = crossWorld(w);
    int place = w.joints->splitStart + (int) get_global_id(0);
    if (place < w.joints->count) visitJoint(&w, place, pass, subStep, true);
}

// A circle takes the sums of what split joints gave. w: by tiles, as crossWorld has it.
void takeJointSums(const World *w, int number, bool speeds, bool impulses) {
    if (jointTable(w, w->joints->shares)[number] == 0) return;
    int slot = slotOfCircle(w, jointTable(w, w->joints->splitIds)[number]);
    bool moves = w->traits[slot].INVERSE_MASS != 0.0f;
    if (speeds) {
        global long *sums = jointSums(w, number, true);
        if (moves) {
            float unit = unitOf(jointRange(w, slot, true));
            float2 v = w->motion[slot].VELOCITY;
            w->motion[slot].VELOCITY = (float2)(v.x + fromFixed(sums[0], unit), v.y + fromFixed(sums[1], unit));
            IF_TURNING(crossSpeeds(w)[slot] += fromFixed(sums[2], unit);)
        }
        sums[0] = sums[1] = sums[2] = 0;
    }
    if (impulses) {
        global long *sums = jointSums(w, number, false);
        if (moves) {
            float unit = unitOf(jointRange(w, slot, false));
            global float *sum = (global float *) (w->load + slot) + IMPULSES_AT;
            sum[0] += fromFixed(sums[0], unit);
            sum[1] += fromFixed(sums[1], unit);
            IF_TURNING(w->spinImpulse[slot] += fromFixed(sums[2], unit);)
        }
        sums[0] = sums[1] = sums[2] = 0;
    }
}

// Index space: circles of split joints.
kernel void joints_takeSums(WORLD_PARAMETERS, int speeds, int impulses) {
    World w = WORLD;
    int number = (int) get_global_id(0);
    if (number >= w.joints->splitCircles || refused(&w)) return;
    w = crossWorld(w);
    takeJointSums(&w, number, speeds != 0, impulses != 0);
}
#endif
