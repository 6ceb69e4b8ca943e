// uses: world/shared/JointMath.cl world/shared/Velocity.cl world/stages/World.cl
// The visits of joints. The Java classes JointVisits and VisitedJoint document them, function by function. A schedule, Joints.cl, supplies
// the values of both ends, and gives to circles what a visit leaves for them.

#ifdef JOINTS
// There once, however many kernels visit joints: compilers took minutes.
#define APART __attribute__((noinline))

// Of A, of B, or of the anchor in place of B.
typedef struct {
    float4 m;     // as motion
    float2 began; // velocity as the sub-step began
    float share;  // by how much it counts as lighter
    float inverseMass; // also of one that sleeps
    IF_SLEEPING(bool still;) // whether it sleeps, and gets nothing
#ifdef TURNING
    float inverseInertia, radius, speed; // speed: surface speed
    float turned;                        // in this step, radians
    int angle;
#endif
} JointEnd;

typedef struct {
    float4 row[3];
    int4 traits[2];
    float4 kept[2];
    float4 spring[1];
    JointEnd a, b;
    float h, inverseH; // of the step
    float most;        // the greatest speed by which it corrects
    float baseX, baseY, normalX, normalY, distance, direction;
    // velocity of B against A, and that as the sub-step began; inverse masses of both, as the visit sees them, and the effective mass
    float vx, vy, begunX, begunY, inverse, mass;
#ifdef TURNING
    float omegaA, omegaB, turnA, turnB;
#endif
    // what the visit gives: impulses on B, an angular impulse on A, what both surfaces get besides
    float pushX, pushY, twist, both;
} JointVisit;

int linearOf(const JointVisit *v) { return v->HOLD_FORM & HOLD_LINEAR; }
int angularOf(const JointVisit *v) { return v->HOLD_FORM & HOLD_ANGULAR; }
bool holds(const JointVisit *v, int flag) { return (v->HOLD_FORM & flag) != 0; }
// spring is 0 where there is none.
bool isExact(const JointVisit *v) { return v->SPRING_EXACT != 0.0f; }

// Whether the linear part is an exact spring, whose impulses are not kept.
bool isLinearExact(const JointVisit *v) { return holds(v, HOLD_ELASTIC) && isExact(v); }

// The same of the angular part.
bool isAngularExact(const JointVisit *v) { return angularOf(v) == HOLD_TURN_ANGLE && isExact(v); }

// Whether it does something without bias: exact springs alone do not.
bool relaxes(const JointVisit *v) {
    return holds(v, HOLD_RIGID | HOLD_LOWER | HOLD_UPPER | HOLD_ACROSS) || (holds(v, HOLD_ELASTIC) && !isExact(v)) ||
           linearOf(v) == HOLD_DRAG || (angularOf(v) != 0 && !isAngularExact(v));
}

// Where B is from A.
APART void measureJoint(JointVisit *v) {
    float x = v->baseX + (v->b.m.DX - v->a.m.DX);
    float y = v->baseY + (v->b.m.DY - v->a.m.DY);
    if (linearOf(v) == HOLD_POINT) {
        v->normalX = x;
        v->normalY = y;
        return;
    }
    float d = lengthf(x, y);
    v->distance = d;
    if (d > 0.0f) {
        v->normalX = x / d;
        v->normalY = y / d;
    }
#ifdef TURNING
    if (holds(v, HOLD_ACROSS)) {
        int turn_ = meanTurn(v->a.angle, v->REFERENCE_A, v->a.turned, v->b.angle, v->REFERENCE_B, v->b.turned);
        float cos_ = cosOfUnits(turn_);
        float sin_ = sinOfUnits(turn_);
        float dx = v->ROW_DIRECTION_X;
        float dy = v->ROW_DIRECTION_Y;
        v->direction = (cos_ * dx - sin_ * dy) * y - (sin_ * dx + cos_ * dy) * x;
    }
#endif
}

// Takes the velocities of both.
void lookAtEnds(JointVisit *v) {
    v->vx = v->b.m.VX - v->a.m.VX;
    v->vy = v->b.m.VY - v->a.m.VY;
    v->inverse = v->a.share * v->a.inverseMass + v->b.share * v->b.inverseMass;
    v->mass = jointMass(v->inverse);
#ifdef TURNING
    if (angularOf(v) != 0 || holds(v, HOLD_ACROSS)) {
        float rA = v->a.radius;
        float rB = v->b.radius;
        v->omegaA = v->a.speed / rA;
        v->omegaB = v->b.speed / rB;
        v->turnA = v->a.share * (v->a.inverseInertia / (rA * rA));
        v->turnB = v->b.share * (v->b.inverseInertia / (rB * rB));
    }
#endif
}

// How far it is from what it is to keep, as measured last; springs keep nothing.
float strainOf(const JointVisit *v) {
    if (linearOf(v) == HOLD_POINT) return holds(v, HOLD_RIGID) ? lengthf(v->normalX, v->normalY) : 0.0f;
    float d = v->distance;
    float strain = holds(v, HOLD_RIGID) ? fabs(d - v->ROW_LENGTH) : 0.0f;
    strain = holds(v, HOLD_LOWER) ? maxf(v->ROW_MIN_LENGTH - d, strain) : strain;
    return holds(v, HOLD_UPPER) ? maxf(d - v->ROW_MAX_LENGTH, strain) : strain;
}

void giveNothing(JointVisit *v) {
    v->pushX = 0.0f;
    v->pushY = 0.0f;
    v->twist = 0.0f;
    v->both = 0.0f;
}

// All impulses of the joint, as what is to be given.
APART void giveAll(JointVisit *v) {
    giveNothing(v);
    if (linearOf(v) == HOLD_AXIAL) {
        float along = (v->KEPT_AXIAL + v->KEPT_LOWER) - v->KEPT_UPPER;
        float across = v->KEPT_ACROSS;
        v->pushX = v->normalX * along - v->normalY * across;
        v->pushY = v->normalY * along + v->normalX * across;
        v->both = holds(v, HOLD_ACROSS) ? -0.5f * v->distance * across : 0.0f;
    } else {
        v->pushX = v->KEPT_AXIAL;
        v->pushY = v->KEPT_ACROSS;
    }
    v->twist = v->KEPT_ANGULAR;
}

// Of a spring, from the impulse before, which an exact one does not have.
float springOf(const JointVisit *v, float before, float m, float speed, float begun, float c) {
    return isExact(v) ? springImpulse(m, speed, begun, c, v->SPRING_NOW, v->SPRING_BEGUN, v->SPRING_WAY)
                      : solvedImpulse(before, m, speed, c, v->SPRING_MASS_SCALE, v->SPRING_BIAS_RATE, v->SPRING_IMPULSE_SCALE);
}

float holdRigid(global const JointHead *j, const JointVisit *v, float before, float m, float speed, float c) {
    return heldImpulse(before, m, speed, c, j->massScale, j->biasRate, j->impulseScale, v->most);
}

float springMass(const JointVisit *v) {
    return jointMass(springShare(v->a.share, v->SPRING_EXACT) * v->a.inverseMass +
                     springShare(v->b.share, v->SPRING_EXACT) * v->b.inverseMass);
}

// One axis with bias.
float solveAxis(global const JointHead *j, const JointVisit *v, float before, float speed, float begun, float c) {
    return holds(v, HOLD_RIGID) ? holdRigid(j, v, before, v->mass, speed, c)
                                : springOf(v, before, isExact(v) ? springMass(v) : v->mass, speed, begun, c);
}

// Exact springs keep no impulse, nor one from when they were not exact.
void forgetExact(JointVisit *v) {
    if (isLinearExact(v)) {
        v->KEPT_AXIAL = 0.0f;
        v->KEPT_ACROSS = linearOf(v) == HOLD_POINT ? 0.0f : v->KEPT_ACROSS;
    }
    if (isAngularExact(v)) v->KEPT_ANGULAR = 0.0f;
}

// What an exact spring has given counts at once.
void countExact(JointVisit *v) {
    if (isLinearExact(v)) {
        bool along = linearOf(v) == HOLD_AXIAL;
        v->KEPT_SUM_X += along ? v->normalX * v->KEPT_AXIAL : v->pushX;
        v->KEPT_SUM_Y += along ? v->normalY * v->KEPT_AXIAL : v->pushY;
    }
    if (isAngularExact(v)) v->KEPT_SUM_ANGULAR += v->twist;
    forgetExact(v);
}

// Cuts a force that is too great, and gives the change.
void keepForce(JointVisit *v, float beforeX, float beforeY) {
    float limit = v->ROW_MAX_FORCE * v->h;
    float share = shareWithin(v->KEPT_AXIAL, v->KEPT_ACROSS, limit);
    v->KEPT_AXIAL *= share;
    v->KEPT_ACROSS *= share;
    v->pushX = v->KEPT_AXIAL - beforeX;
    v->pushY = v->KEPT_ACROSS - beforeY;
}

#ifdef TURNING
void giveTwist(JointVisit *v, float before, float next) {
    float limit = v->ROW_MAX_TORQUE * v->h;
    float held = clampf(next, -limit, limit);
    v->KEPT_ANGULAR = held;
    v->twist = held - before;
    v->omegaA += v->turnA * v->twist;
    v->omegaB -= v->turnB * v->twist;
}

void solveTurning(global const JointHead *j, JointVisit *v) {
    if (angularOf(v) == 0 || angularOf(v) == HOLD_TURN_SPEED) return;
    float away = turnedAway(v->a.angle, v->REFERENCE_A, v->a.turned, v->b.angle, v->REFERENCE_B, v->b.turned);
    float before = v->KEPT_ANGULAR;
    float turnMass = jointMass(v->turnA + v->turnB);
    float omega = v->omegaA - v->omegaB;
    float next = angularOf(v) == HOLD_TURN_RIGID
                     ? solvedImpulse(before, turnMass, omega, away, j->massScale, j->biasRate, j->impulseScale)
                     : springOf(v, before, turnMass, omega, omega, away);
    giveTwist(v, before, next);
}

void relaxTurning(JointVisit *v) {
    if (angularOf(v) == 0) return;
    float before = v->KEPT_ANGULAR;
    float turnMass = jointMass(v->turnA + v->turnB);
    float omega = v->omegaA - v->omegaB;
    if (angularOf(v) == HOLD_TURN_RIGID) {
        giveTwist(v, before, relaxedImpulse(before, turnMass, omega));
    } else if (angularOf(v) == HOLD_TURN_SPEED) {
        giveTwist(v, before, relaxedImpulse(before, turnMass, omega - v->ROW_SPEED));
    }
}

float acrossMass(const JointVisit *v) {
    float arm = 0.5f * v->distance;
    return jointMass(v->inverse + arm * arm * (v->turnA + v->turnB));
}

float speedAcross(const JointVisit *v) {
    float along = dotf(-v->normalY, v->normalX, v->vx, v->vy);
    return along - 0.5f * v->distance * (v->omegaA + v->omegaB);
}

void moveAcross(global const JointHead *j, JointVisit *v, bool biased) {
    float before = v->KEPT_ACROSS;
    float m = acrossMass(v);
    float speed = speedAcross(v);
    float next = biased ? holdRigid(j, v, before, m, speed, v->direction) : relaxedImpulse(before, m, speed);
    v->KEPT_ACROSS = next;
    float change = next - before;
    v->pushX += -v->normalY * change;
    v->pushY += v->normalX * change;
    v->both = -0.5f * v->distance * change;
}
#endif

float moveLimit(global const JointHead *j, const JointVisit *v, bool biased, float before, float speed, float gap) {
    return biased ? solvedLimit(before, v->mass, speed, gap, v->inverseH, j->massScale, j->biasRate, j->impulseScale, v->most)
                  : relaxedLimit(before, v->mass, speed, gap, v->inverseH);
}

// Along the line from A to B, with or without bias.
void moveAlong(global const JointHead *j, JointVisit *v, bool biased) {
    float nx = v->normalX;
    float ny = v->normalY;
    float d = v->distance;
    float speed = dotf(nx, ny, v->vx, v->vy);
    float push = 0.0f;
    if (holds(v, HOLD_RIGID) || (biased && holds(v, HOLD_ELASTIC))) {
        float before = v->KEPT_AXIAL;
        float begun = dotf(nx, ny, v->begunX, v->begunY);
        float next = biased ? solveAxis(j, v, before, speed, begun, d - v->ROW_LENGTH) : relaxedImpulse(before, v->mass, speed);
        v->KEPT_AXIAL = next;
        float change = next - before;
        push += change;
        speed += v->inverse * change;
    }
    if (holds(v, HOLD_LOWER)) {
        float before = v->KEPT_LOWER;
        float next = moveLimit(j, v, biased, before, speed, d - v->ROW_MIN_LENGTH);
        v->KEPT_LOWER = next;
        push += next - before;
        speed += v->inverse * (next - before);
    }
    if (holds(v, HOLD_UPPER)) {
        float before = v->KEPT_UPPER;
        float next = moveLimit(j, v, biased, before, -1.0f * speed, v->ROW_MAX_LENGTH - d);
        v->KEPT_UPPER = next;
        push -= next - before;
    }
    v->pushX = nx * push;
    v->pushY = ny * push;
    IF_TURNING(if (holds(v, HOLD_ACROSS)) moveAcross(j, v, biased);)
}

void solvePoint(global const JointHead *j, JointVisit *v) {
    float beforeX = v->KEPT_AXIAL;
    float beforeY = v->KEPT_ACROSS;
    v->KEPT_AXIAL = solveAxis(j, v, beforeX, v->vx, v->begunX, v->normalX);
    v->KEPT_ACROSS = solveAxis(j, v, beforeY, v->vy, v->begunY, v->normalY);
    keepForce(v, beforeX, beforeY);
}

// The biased pass.
APART void solveJoint(global const JointHead *j, JointVisit *v) {
    giveNothing(v);
    measureJoint(v);
    lookAtEnds(v);
    if (holds(v, HOLD_ELASTIC)) {
        v->begunX = v->b.began.x - v->a.began.x;
        v->begunY = v->b.began.y - v->a.began.y;
    }
    IF_TURNING(solveTurning(j, v);)
    if (linearOf(v) == HOLD_AXIAL) {
        moveAlong(j, v, true);
    } else if (linearOf(v) == HOLD_POINT) {
        solvePoint(j, v);
    }
    countExact(v);
}

// The pass without bias.
APART void relaxJoint(global const JointHead *j, JointVisit *v) {
    giveNothing(v);
    measureJoint(v);
    lookAtEnds(v);
    IF_TURNING(relaxTurning(v);)
    if (linearOf(v) == HOLD_AXIAL) {
        moveAlong(j, v, false);
    } else if (linearOf(v) == HOLD_DRAG || (linearOf(v) == HOLD_POINT && holds(v, HOLD_RIGID))) {
        float beforeX = v->KEPT_AXIAL;
        float beforeY = v->KEPT_ACROSS;
        v->KEPT_AXIAL = relaxedImpulse(beforeX, v->mass, v->vx);
        v->KEPT_ACROSS = relaxedImpulse(beforeY, v->mass, v->vy);
        keepForce(v, beforeX, beforeY);
    }
}

// Behind the relaxing pass: adds up the impulses, and gives those that the next sub-step begins with.
void endSubStepOfJoint(JointVisit *v) {
    giveAll(v);
    v->KEPT_SUM_X += v->pushX;
    v->KEPT_SUM_Y += v->pushY;
    v->KEPT_SUM_ANGULAR += v->twist;
}

// Whether it breaks by what it did in the step.
bool breaks(const StepConstants *k, const JointVisit *v) {
    float force = lengthf(v->KEPT_SUM_X, v->KEPT_SUM_Y);
    float torque = fabs(v->KEPT_SUM_ANGULAR);
    return holds(v, HOLD_BREAKABLE) && (force > v->ROW_BREAK_FORCE * k->dt || torque > v->ROW_BREAK_TORQUE * k->dt);
}

#ifdef TURNING
bool turnsEnds(const JointVisit *v) { return angularOf(v) != 0 || holds(v, HOLD_ACROSS); }

// Impulses along the surfaces.
float spinOfA(const JointVisit *v) { return (v->twist + v->both) / v->a.radius; }
float spinOfB(const JointVisit *v) { return (v->both - v->twist) / v->b.radius; }
#endif
#endif
