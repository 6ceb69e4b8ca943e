package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.RigidStep.BODY_CIRCLE;
import static io.github.circles2d.world.bodies.RigidStep.BODY_PIECE;
import static io.github.circles2d.world.bodies.RigidStep.BODY_WALL;

import io.github.circles2d.world.bodies.RigidExtras;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.jvm.state.JointStates;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.KindMotion;
import io.github.circles2d.world.model.KindSleep;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.Velocity;

/**
 * What rigid bodies do in a step, between the passes of the circles. Workers share what is by body, pair or contact, and visits of one colour
 * ({@link RigidVisits}); one worker does the rest, and what is too short to share.
 */
public final class RigidPasses {
    /** By how much a body turns at most in a sub-step, in radians, so that contacts see where it gets. */
    private static final float MOST_TURN = 0.785f;

    /** A body takes as long as more circles, but a pass over bodies has more waits. */
    private static final int CIRCLES = 4;

    /** As many circles take as long as to visit a pair. */
    private static final int PAIRS = 16;

    private final State state;
    private final Team team;
    private final int leastBodies;
    private final RigidPairs pairs;
    private final RigidThings things;
    private final RigidContacts contacts;
    private final RigidCover cover;
    private final RigidOrder order;
    private final RigidVisits visits;
    private final RigidJoints joints;
    private final RigidResting resting;

    /** Null if nobody sleeps. */
    private float[] kindSleep;

    /** Whether all contacts stay as they are, and no body touches something else. */
    private boolean allRest;

    /** Whom bodies are about to push. */
    public final WakingByBodies waking;

    // within a step
    private RigidStep step;
    private StepConstants k;
    private TerrainStep terrain;
    private int subStep;

    private final Team.Share gain = this::gain;
    private final Team.Share move = this::move;

    /** No worker gets less than a least share of what is by circle, but for what is left over. */
    public RigidPasses(State state, Team team, int leastShare) {
        this.state = state;
        this.team = team;
        leastBodies = Math.max(1, leastShare / CIRCLES);
        pairs = new RigidPairs(state, team);
        things = pairs.things;
        contacts = new RigidContacts(pairs, team);
        cover = new RigidCover(contacts, things, team);
        order = new RigidOrder(contacts, things);
        visits = new RigidVisits(contacts, things, order, team, leastShare / PAIRS);
        joints = new RigidJoints(state, pairs);
        resting = new RigidResting(state, pairs);
        waking = new WakingByBodies(state, contacts, pairs, resting, joints);
    }

    /** How many workers are worth their while. */
    public int workers(RigidStep bodies) {
        return bodies.count / leastBodies;
    }

    /**
     * Finds the contacts of a step, as all lies now. Without joints of bodies, theirs are null. Before circles wake, and again if some have: who
     * sleeps is another thing in contacts.
     */
    public void find(
            RigidStep bodies, StepConstants constants, TerrainStep ground, JointStep jointStep, JointStates states) {
        findBodies(bodies, constants, ground, jointStep, states);
        findContacts();
    }

    /** The first half, which looks at no circle: where bodies are. */
    public void findBodies(
            RigidStep bodies, StepConstants constants, TerrainStep ground, JointStep jointStep, JointStates states) {
        step = bodies;
        k = constants;
        terrain = ground;
        joints.findPartners(bodies, jointStep, states);
        pairs.begin(bodies, constants, ground);
    }

    /** The boxes in which bodies may meet something in the step, of four floats each: least x and y, greatest x and y. */
    public float[] boxes() {
        return pairs.boxes();
    }

    /** How many boxes there are. */
    public int boxCount() {
        return things.bodies;
    }

    /** The second half. */
    public void findContacts() {
        pairs.find();
        contacts.find(step, k);
    }

    /** Puts down the slots of the circles that passes look at, since bodies are near, of which there is room for all; returns how many. */
    public int circles(int[] slots) {
        int n = 0;
        for (int t = things.bodies; t < things.count; t++) {
            if (things.all[t].type == BODY_CIRCLE) {
                slots[n++] = state.slotOf[things.all[t].id];
            }
        }
        return n;
    }

    /** Whether a step changes nothing of bodies, nor they of circles. Without joints of bodies, theirs are null. */
    public boolean isIdle(RigidStep bodies, StepConstants constants, TerrainStep ground, JointStep jointStep) {
        return jointStep == null
                && !RigidPairs.piecesMove(constants.terrain ? ground : null)
                && waking.isIdle(bodies, constants)
                && areStill();
    }

    /** Whether no circle moves. */
    private boolean areStill() {
        boolean still = true;
        for (int slot = 0; slot < state.awake; slot++) {
            still &= pairs.isStill(slot);
        }
        return still;
    }

    /** Begins a step, of which contacts have been found, and in which circles have begun theirs. kinds: by which bodies fall asleep, or null. */
    public void begin(float[] kinds) {
        kindSleep = kinds;
        allRest = pairs.awake() == 0 && contacts.count == 0 && k.warmScale == 1f && resting.areAll(step);
        if (!allRest) {
            resting.take(step, k.warmScale);
        }
        cover.apply();
        order.find();
        pairs.takeCircleSurfaces();
        takeCircles(false);
        visits.begin(k, step.listener != null);
        joints.begin(k);
        pushCircles();
    }

    // ---- passes

    /** What drives bodies, and the impulses of the sub-step before. */
    public void integrateVelocities() {
        team.share(things.bodies, 0, gain);
        for (int t = things.bodies; t < things.count; t++) {
            if (things.all[t].type != BODY_CIRCLE) {
                things.all[t].noteVelocity();
            }
        }
        joints.warmStart();
        visits.warmStart();
    }

    private void gain(int worker, int from, int end) {
        float[] motion = state.kindMotion;
        float[] surfaces = k.turning ? state.turning.surfaces : null;
        for (int n = from; n < end; n++) {
            RigidThing t = things.all[n];
            t.vx += t.takenX();
            t.vy += t.takenY();
            t.omega += t.takenOmega();
            if (motion != null) {
                int row = KindMotion.of(t.kind);
                float factor = motion[row + KindMotion.DAMPING_FACTOR];
                float share =
                        Velocity.shareWithin(t.vx * factor, t.vy * factor, motion[row + KindMotion.GREATEST_SPEED]);
                t.vx *= factor * share;
                t.vy *= factor * share;
            }
            if (surfaces != null) {
                t.omega *= surfaces[KindSurface.of(t.kind) + KindSurface.DAMPING_FACTOR];
            }
            t.noteVelocity();
        }
    }

    /** The biased pass over joints, bodies, pieces and walls. */
    public void solve(int sub) {
        joints.solve(sub);
        visits.solve();
    }

    /** The biased pass over circles, after which bounces are over. */
    public void solveCircles() {
        takeCircles(true);
        visits.passOverCircles(false);
        giveCircles();
        freeCircles();
        visits.forgetBounces();
    }

    /** Moves bodies, and what moves along with time; circles have moved. Measures contacts. */
    public void integratePositions(int sub) {
        subStep = sub;
        team.share(things.count, 0, move);
        visits.measure();
    }

    private void move(int worker, int from, int end) {
        for (int n = from; n < end; n++) {
            RigidThing t = things.all[n];
            switch (t.type) {
                case BODY_PIECE -> RigidThings.pose(t, terrain, subStep + 1, k);
                case BODY_WALL -> RigidThings.poseWall(t, subStep + 1, k);
                case BODY_CIRCLE -> {
                    int m = CircleRow.of(state.slotOf[t.id]);
                    t.dx = state.motion[m + CircleRow.DX];
                    t.dy = state.motion[m + CircleRow.DY];
                }
                default -> {
                    if (!t.asleep) {
                        moveBody(t);
                    }
                }
            }
        }
    }

    private void moveBody(RigidThing t) {
        t.vx = Velocity.limitSpeed(t.vx);
        t.vy = Velocity.limitSpeed(t.vy);
        t.omega = CircleMath.clamp(t.omega, -MOST_TURN * k.inverseH, MOST_TURN * k.inverseH);
        t.dx += t.vx * k.h;
        t.dy += t.vy * k.h;
        t.turned += t.omega * k.h;
        t.turn(false);
    }

    /** The relaxing pass over joints, bodies, pieces and walls. */
    public void relax(int sub, boolean last) {
        joints.relax(sub, last);
        visits.relax();
    }

    public void relaxCircles(boolean last) {
        takeCircles(false);
        visits.passOverCircles(true);
        giveCircles();
        if (!last) {
            pushCircles();
        }
    }

    // ---- circles

    /** Takes the velocities of circles as they are; before: also those without impulses. */
    private void takeCircles(boolean before) {
        for (int n = things.bodies; n < things.count; n++) {
            RigidThing t = things.all[n];
            if (t.type == BODY_CIRCLE) {
                int slot = state.slotOf[t.id];
                int s = CircleRow.of(slot);
                t.vx = state.motion[s + CircleRow.VX];
                t.vy = state.motion[s + CircleRow.VY];
                boolean rests = slot >= state.awake;
                if (k.turning && !rests) {
                    t.omega = state.turning.spin[s + CircleRow.SURFACE_SPEED] / t.thin;
                }
                if (before) {
                    t.beforeX = rests ? t.vx : state.load[s + CircleRow.BEFORE_X];
                    t.beforeY = rests ? t.vy : state.load[s + CircleRow.BEFORE_Y];
                    t.beforeOmega = k.turning && !rests ? state.turning.before(slot) / t.thin : 0f;
                }
            }
        }
    }

    private void giveCircles() {
        for (int n = things.bodies; n < things.count; n++) {
            RigidThing t = things.all[n];
            if (t.type == BODY_CIRCLE && t.w > 0f) {
                int s = CircleRow.of(state.slotOf[t.id]);
                state.motion[s + CircleRow.VX] = t.vx;
                state.motion[s + CircleRow.VY] = t.vy;
                if (k.turning) {
                    state.turning.spin[s + CircleRow.SURFACE_SPEED] = t.omega * t.thin;
                }
            }
        }
    }

    /** Circles that a body has pushed leave their paths. */
    private void freeCircles() {
        for (int p = order.firstWithCircle; p < contacts.pairCount; p++) {
            RigidPair pair = contacts.pairs[p];
            int s = CircleRow.of(state.slotOf[pair.b.id]);
            for (int n = pair.begin; n < pair.end; n++) {
                if (contacts.all[n].impulse > 0f && state.motionClamp[s + CircleRow.ALLOWANCE] >= 0f) {
                    state.motionClamp[s + CircleRow.ALLOWANCE] = Float.POSITIVE_INFINITY;
                }
            }
        }
    }

    /** Adds what circles have accumulated to the impulses that act in their next sub-step. */
    private void pushCircles() {
        for (int p = order.firstWithCircle; p < contacts.pairCount; p++) {
            RigidPair pair = contacts.pairs[p];
            RigidThing circle = pair.b;
            int s = CircleRow.of(state.slotOf[circle.id]);
            for (int n = pair.begin; n < pair.end; n++) {
                RigidContact c = contacts.all[n];
                if (c.impulse > 0f && circle.w > 0f) {
                    float side = c.a == circle ? 1f : -1f;
                    state.load[s + CircleRow.IMPULSE_X] += side * (c.nx * c.impulse - c.ny * c.grip);
                    state.load[s + CircleRow.IMPULSE_Y] += side * (c.ny * c.impulse + c.nx * c.grip);
                    state.load[s + CircleRow.LOADED_NEXT] = 1f;
                    if (k.turning) {
                        state.turning.spin[s + CircleRow.SPIN_IMPULSE] -= c.grip;
                    }
                }
            }
        }
    }

    // ---- end

    /** Ends the step: bodies take what they have become. */
    public void end() {
        for (int n = 0; n < things.bodies; n++) {
            RigidThing t = things.all[n];
            int id = t.id;
            if (t.asleep) {
                continue;
            }
            float movedX = t.dx - step.restX[id];
            float movedY = t.dy - step.restY[id];
            float x = t.x + t.dx;
            float y = t.y + t.dy;
            step.restX[id] = CircleMath.lostByRounding(t.x, t.dx, x);
            step.restY[id] = CircleMath.lostByRounding(t.y, t.dy, y);
            step.x[id] = x;
            step.y[id] = y;
            keepInside(id);
            step.angle[id] = Surface.turn(t.angle, t.turned, 1f, 1f);
            step.vx[id] = Velocity.limitSpeed(t.vx);
            step.vy[id] = Velocity.limitSpeed(t.vy);
            step.omega[id] = Velocity.limitSpeed(t.omega);
            if (kindSleep != null) {
                rest(t, id, movedX, movedY);
            }
        }
        if (joints.end()) {
            step.changes++;
        }
        if (!allRest) {
            contacts.keep(resting);
            step.resting = resting.kept;
            tell();
        }
    }

    /** A body that has moved by so much comes to rest, or begins anew to do so. */
    private void rest(RigidThing t, int id, float movedX, float movedY) {
        float driftX = step.extras.real(id, RigidExtras.DRIFT_X) + movedX;
        float driftY = step.extras.real(id, RigidExtras.DRIFT_Y) + movedY;
        int turned = step.extras.get(id, RigidExtras.TURNED) + (step.angle[id] - t.angle);
        float gain = t.gain();
        int kind = KindSleep.of(t.kind);
        float damping = kindSleep[kind + KindSleep.DAMPING];
        float most = Sleep.drift(t.thin, gain, k.inverseH, damping);
        boolean rests = (gain > 0f || damping > 0f)
                && kindSleep[kind + KindSleep.AWAKE] == 0f
                && Math.abs(step.omega[id]) * k.dt < Sleep.TURN_OF_STEP
                && Sleep.rests(driftX, driftY, turned, t.reach, most)
                && !joints.drive(id);
        if (!rests) {
            step.wake(id);
            return;
        }
        int rest = step.extras.get(id, RigidExtras.REST) + 1;
        step.setRest(id, rest, turned, driftX, driftY);
        if (Sleep.fallsAsleep(rest, k.dt)) {
            step.setRest(id, Sleep.ASLEEP, Sleep.NO_OFFSET, t.gainX * k.inverseH, t.gainY * k.inverseH);
            step.setSpinOfRest(id, t.gainOmega * k.inverseH, 0);
            step.vx[id] = 0f;
            step.vy[id] = 0f;
            step.omega[id] = 0f;
        }
    }

    private void keepInside(int id) {
        float x = k.arena.placeX(CircleMath.clamp(step.x[id], k.bounds.minX(), k.bounds.maxX()));
        float y = k.arena.placeY(CircleMath.clamp(step.y[id], k.bounds.minY(), k.bounds.maxY()));
        if (x != step.x[id]) {
            step.x[id] = x;
            step.restX[id] = 0f;
        }
        if (y != step.y[id]) {
            step.y[id] = y;
            step.restY[id] = 0f;
        }
    }

    /** Tells what bodies have touched, each pair by its contact that pressed most. */
    private void tell() {
        if (step.listener == null) {
            return;
        }
        step.touchesStay = false;
        for (int p = 0; p < contacts.pairCount; p++) {
            RigidPair pair = contacts.pairs[p];
            RigidContact hardest = null;
            float most = 0f;
            for (int n = pair.begin; n < pair.end; n++) {
                if (contacts.all[n].most > most) {
                    hardest = contacts.all[n];
                    most = hardest.most;
                }
            }
            if (hardest != null) {
                tell(pair.a, pair.b, hardest);
            }
        }
    }

    private void tell(RigidThing body, RigidThing other, RigidContact c) {
        boolean isA = c.a == body;
        float side = isA ? -1f : 1f;
        step.addTouch(
                other.type,
                body.id,
                other.id,
                body.x + (body.dx + (isA ? c.ax : c.bx)),
                body.y + (body.dy + (isA ? c.ay : c.by)),
                side * c.nx,
                side * c.ny,
                c.most,
                c.approach + 0f); // never -0
    }

    public long bytes() {
        return resting.bytes()
                + waking.bytes()
                + pairs.bytes()
                + contacts.bytes()
                + cover.bytes()
                + order.bytes()
                + joints.bytes();
    }
}
