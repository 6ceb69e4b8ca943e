package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.RESTITUTION;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.WALL_X;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.jvm.bodies.WakingByBodies;
import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.grid.PairFilter;
import io.github.circles2d.world.jvm.joints.RestingJoints;
import io.github.circles2d.world.jvm.pieces.PieceSearch;
import io.github.circles2d.world.jvm.solver.Contacts;
import io.github.circles2d.world.jvm.solver.NearResting;
import io.github.circles2d.world.jvm.state.PieceContactRow;
import io.github.circles2d.world.jvm.state.Resting;
import io.github.circles2d.world.jvm.state.Sleepers;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.PieceGap;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Walls;
import java.util.Arrays;

/**
 * The begin of a step in which circles wake, once those that are awake lie in the grid. {@link Sleep} has the rule. It looks at circles that
 * sleep near to those that are awake, now or in the step before, and at those whose balance may be another for another reason; nothing has
 * changed for all others. One worker does it for all.
 */
final class Waking implements WakingByBodies.Circles {
    private static final int NO_JOINTS = -1;
    private static final float[] NO_WALL_ROWS = new float[ContactRows.OF_WALLS];

    private final State state;
    private final Grid grid;
    private final Contacts contacts;
    private final Resting.Found found = new Resting.Found();

    /** By id: the last step that has looked at the circle. */
    private int[] looked = new int[0];

    private int step;

    /** Of circles that have been looked at. */
    private final SleeperSums sums;

    /** By id, of circles that have been looked at: the speed that wakes it; later that which has woken it. */
    private float[] speed = new float[0];

    /** By id: the last step that has woken the circle. */
    private int[] wokenIn = new int[0];

    /** By id: the speed that wakes it in the next ring; 0 between rings. */
    private float[] next = new float[0];

    /** Ids that are looked at. */
    private int[] list = new int[64];

    private int count;

    /** Ids that were near to circles that are awake in the step before. */
    private int[] border = new int[64];

    private int borderCount;

    /** Ids that wake. */
    private int[] woken = new int[64];

    private int wokenCount;

    /** The gravity of the last step. */
    private float gravityStepX;

    private float gravityStepY;

    /** The order of joints in the last step that looked; {@link #NO_JOINTS} without joints. */
    private int jointOrder = NO_JOINTS;

    // what the step has
    private StepConstants k;

    /** Null without joints. */
    private RestingJoints joints;

    /** The impulses of the rows of the contact that is looked at. */
    private final float[] rows = new float[ContactRows.COUNT];

    /** Null without bodies. */
    private WakingByBodies bodies;

    // the normal between two circles, and how far their surfaces are apart
    private float nx;
    private float ny;
    private float separation;

    Waking(State state, Grid grid, Contacts contacts) {
        this.state = state;
        this.grid = grid;
        this.contacts = contacts;
        sums = new SleeperSums(state);
    }

    private Sleepers sleepers() {
        return state.sleepers;
    }

    // ---- before the grid

    /** Lets circles rest that have fallen asleep. */
    void settle(StepConstants constants, TerrainStep terrain, PieceSearch pieces) {
        Sleepers all = sleepers();
        contacts.impulseCache().ensure(contacts.impulseCache().filled() + all.impulses());
        if (state.drowsy() == 0) {
            return;
        }
        state.resting.ensure();
        all.ensureImpulses(contacts.impulseCache().most());
        contacts.impulseCache().ensure(2 * contacts.impulseCache().filled() + all.impulses());
        boolean onTerrain = constants.terrain && pieces != null;
        if (onTerrain) {
            pieces.ensure();
        }
        for (int n = 0; n < state.drowsy(); n++) {
            int id = state.drowsyAt(n);
            int slot = state.slotOf[id];
            if (slot >= 0 && slot < state.awake && all.isAsleep(id)) {
                if (onTerrain) {
                    pieces.keep(slot, terrain, constants);
                }
                state.rest(slot);
                all.suspect(id);
            }
        }
        state.resting.moveToSleepers(contacts.impulseCache(), all);
        for (int slot = 0; slot < state.awake; slot++) {
            if (state.isStatic(slot)) {
                contacts.impulseCache().moveToSleepers(slot, all);
            }
        }
        state.forgetDrowsy();
    }

    // ---- who wakes

    /** Wakes circles; returns whether there are any. */
    boolean wake(
            StepConstants constants,
            TerrainStep terrain,
            PieceSearch pieces,
            RestingJoints held,
            WakingByBodies pushed) {
        k = constants;
        sums.k = constants;
        joints = held;
        bodies = pushed;
        begin();
        lookAtBorder();
        if (bodies != null) {
            lookAtPushed();
        }
        if (joints != null) {
            lookAtPulled();
        }
        int bordering = count;
        lookAtMovingStatics();
        if (joints != null) {
            lookAtDriven();
        }
        lookAtMovingWalls();
        if (k.terrain && pieces != null) {
            lookAtMovingPieces(terrain, pieces);
        }
        for (int n = 0; n < borderCount; n++) {
            look(border[n]);
        }
        rememberBorder(bordering);
        for (int n = 0; n < sleepers().suspects(); n++) {
            look(sleepers().suspectAt(n));
        }
        if (jointOrder != (joints == null ? NO_JOINTS : joints.order())) {
            jointOrder = joints == null ? NO_JOINTS : joints.order();
            sleepers().suspectAll();
        }
        boolean tilted = k.gravityStepX != gravityStepX || k.gravityStepY != gravityStepY;
        gravityStepX = k.gravityStepX;
        gravityStepY = k.gravityStepY;
        if (sleepers().suspectsAll() || tilted || k.warmScale != 1f) {
            for (int slot = state.awake; slot < state.n; slot++) {
                look(state.id[slot]);
            }
        }
        sleepers().forgetSuspects();
        wokenCount = 0;
        for (int n = 0; n < count; n++) {
            judge(list[n]);
        }
        if (bodies != null) {
            bodies.findWoken();
        }
        wakeRings();
        boolean some = bodies != null && bodies.end() || wokenCount > 0;
        for (int n = 0; n < wokenCount; n++) {
            sleepers().restart(state.wake(state.slotOf[woken[n]]));
        }
        sleepers().scale(k.warmScale);
        return some;
    }

    private void begin() {
        if (looked.length < state.slotOf.length) {
            int ids = state.slotOf.length;
            sums.ensure(ids);
            speed = new float[ids];
            next = new float[ids];
            wokenIn = new int[ids];
            looked = new int[ids];
            step = 0;
        }
        if (++step < 0) {
            Arrays.fill(looked, 0);
            Arrays.fill(wokenIn, 0);
            step = 1;
        }
        count = 0;
    }

    /** Begins to look at a circle; returns false if it does not sleep. */
    private boolean look(int id) {
        int slot = state.slotOf[id];
        if (slot < state.awake || !sleepers().isAsleep(id)) {
            return false;
        }
        if (looked[id] != step) {
            if (count == list.length) {
                list = Arrays.copyOf(list, 2 * count);
            }
            list[count++] = id;
            begin(id);
        }
        return true;
    }

    private void begin(int id) {
        looked[id] = step;
        sums.clear(id);
        speed[id] = 0f;
    }

    private void push(int id, float by) {
        speed[id] = CircleMath.max(speed[id], by);
    }

    private float radius(int slot) {
        return state.circle[CircleRow.of(slot) + RADIUS];
    }

    private float strong(int slot) {
        return Sleep.strong(sums.gainOfStep(slot), radius(slot), k.dt);
    }

    /** Finds the normal from the circle of lower id to the other, and how far their surfaces are apart. */
    private void meet(int lower, int higher) {
        float dx = CircleMath.difference(
                state.differenceX(lower, higher),
                state.motion[CircleRow.of(lower) + DX],
                state.motion[CircleRow.of(higher) + DX]);
        float dy = CircleMath.difference(
                state.differenceY(lower, higher),
                state.motion[CircleRow.of(lower) + DY],
                state.motion[CircleRow.of(higher) + DY]);
        float distance = CircleMath.length(dx, dy);
        float radii = radius(lower) + radius(higher);
        boolean apart = distance > Tuning.COINCIDENT * radii;
        nx = apart ? dx / distance : 0f;
        ny = apart ? dy / distance : 0f;
        separation = distance - radii;
    }

    /** Circles near to those that are awake: these may hit them, and press them. */
    private void lookAtBorder() {
        NearResting near = contacts.nearResting();
        for (int slot = 0; slot < state.awake && near.areAny(); slot++) {
            if (!state.isStatic(slot)) {
                for (int entry = near.first(slot); entry < near.first(slot + 1); entry++) {
                    int other = near.slot(entry);
                    if (look(state.id[other]) && PairFilter.mayMeet(state, slot, other)) {
                        touch(other, slot);
                    }
                }
            }
        }
    }

    private void touch(int slot, int awake) {
        boolean isLower = state.id[slot] < state.id[awake];
        int lower = isLower ? slot : awake;
        int higher = isLower ? awake : slot;
        meet(lower, higher);
        int entry = contacts.impulseCache().find(lower, higher);
        float j = entry < 0 ? 0f : contacts.impulseCache().impulseNow(entry) * k.warmScale;
        for (int row = 0; row < ContactRows.COUNT; row++) {
            rows[row] = entry < 0 || state.turning == null
                    ? 0f
                    : contacts.impulseCache().rowImpulseNow(entry, row) * k.warmScale;
        }
        float acting = ContactRows.actingImpulse(j, rows, 0, 1);
        if (acting > 0f) {
            press(slot, isLower, j);
        }
        float v =
                CircleMath.dot(nx, ny, state.motion[CircleRow.of(awake) + VX], state.motion[CircleRow.of(awake) + VY]);
        float restitution = CircleMath.max(
                state.traits[CircleRow.of(slot) + RESTITUTION], state.traits[CircleRow.of(awake) + RESTITUTION]);
        push(state.id[slot], hit(slot, awake, isLower ? -v : v, separation, restitution, acting));
    }

    /** Circles near to bodies: these may hit them, and press them. */
    private void lookAtPushed() {
        for (int c = bodies.first(); c < bodies.count(); c++) {
            bodies.show(c);
            int id = bodies.circle();
            if (look(id)) {
                int slot = state.slotOf[id];
                sums.press(slot, bodies, 1f);
                push(id, sums.hit(slot, bodies));
            }
        }
    }

    /** Adds the impulses of a contact, whose normal has been found and whose other rows are there, to the sums of a circle. */
    private void press(int slot, boolean isLower, float normalImpulse) {
        float j = ContactRows.impulseAlongNormal(normalImpulse, rows, 0, 1);
        float load = ContactRows.actingImpulse(normalImpulse, rows, 0, 1);
        float f = ContactRows.tangentImpulse(rows, 0, 1);
        float rolling = ContactRows.angularImpulse(rows, 0, 1);
        sums.press(slot, isLower ? -1f : 1f, nx, ny, j, load, f, rolling);
    }

    /** Takes the rows of an impulse between circles of which none moves. Returns the normal one. */
    private float takeKept(int press) {
        for (int row = 0; row < ContactRows.COUNT; row++) {
            rows[row] = state.turning == null ? 0f : sleepers().row(press, row) * k.warmScale;
        }
        return sleepers().normal(press) * k.warmScale;
    }

    /** Circles that joints hold to those that are awake: these may pull at them. */
    private void lookAtPulled() {
        for (int n = 0; n < joints.bordering(); n++) {
            int joint = joints.borderingAt(n);
            int id = joints.sleeper(joint);
            if (look(id) && joints.isThere(joint)) {
                push(id, pulled(joint, id));
            }
        }
    }

    /** What a circle that is awake is about to add by a joint to the speed of one that sleeps; 0 if too little. */
    private float pulled(int joint, int id) {
        int slot = state.slotOf[id];
        int awake = state.slotOf[joints.other(joint, id)];
        float distance = joints.measure(joint);
        float vx = state.motion[CircleRow.of(awake) + VX];
        float vy = state.motion[CircleRow.of(awake) + VY];
        float along = CircleMath.dot(joints.nx(), joints.ny(), vx, vy);
        float apart = joints.isA(joint, id) ? along : -along;
        float j = joints.load(joint, k);
        float by = 0f;
        if (joints.has(joint, JointRow.RIGID)) {
            float v = Math.abs(apart);
            if (joints.has(joint, JointRow.ACROSS)) {
                v = CircleMath.length(vx, vy) + 0.5f * distance * Math.abs(state.turning.angularVelocity[awake]);
            }
            by = hit(slot, awake, v, 0f, 0f, j);
        }
        if (joints.has(joint, JointRow.LOWER)) {
            float gap = distance - joints.value(joint, JointRow.MIN_LENGTH);
            by = CircleMath.max(by, hit(slot, awake, -apart, gap, 0f, j));
        }
        if (joints.has(joint, JointRow.UPPER)) {
            float gap = joints.value(joint, JointRow.MAX_LENGTH) - distance;
            by = CircleMath.max(by, hit(slot, awake, apart, gap, 0f, j));
        }
        return by;
    }

    private float hit(int slot, int awake, float approach, float gap, float restitution, float j) {
        return sums.hit(slot, state.ownInverseMass(awake), approach, gap, restitution, j);
    }

    /** Circles that a joint moves: by a motor, or since what holds them moves by itself. */
    private void lookAtDriven() {
        for (int n = 0; n < joints.driving(); n++) {
            int joint = joints.drivingAt(n);
            if (joints.isThere(joint)) {
                wakeHeld(joints.a(joint));
                wakeHeld(joints.b(joint));
            }
        }
        for (int slot = 0; slot < state.awake; slot++) {
            if (state.isStatic(slot)) {
                int id = state.id[slot];
                for (int entry = joints.first(id); entry < joints.first(id + 1); entry++) {
                    if (joints.isThere(joints.joint(entry)) && joints.movesAlong(slot, joints.joint(entry))) {
                        wakeHeld(joints.other(joints.joint(entry), id));
                    }
                }
            }
        }
    }

    private void wakeHeld(int id) {
        if (id != JointRow.NONE && look(id)) {
            push(id, strong(state.slotOf[id]));
        }
    }

    private void lookAtMovingStatics() {
        for (int slot = 0; slot < state.awake; slot++) {
            if (state.isStatic(slot) && grid.path[slot] > 0f) {
                float r = radius(slot);
                float far = (r + Tuning.MARGIN * r) + grid.path[slot];
                int s = CircleRow.of(slot);
                float x = state.circle[s + X];
                float y = state.circle[s + Y];
                state.resting.find(found, k.arena, x - far, x + far, y - far, y + far, Sleep.NEIGHBOURS);
                for (int n = 0; n < found.count; n++) {
                    int other = found.slots[n];
                    if (sleepers().isAsleep(state.id[other])
                            && comesNear(slot, other)
                            && PairFilter.wouldNotice(state, state.id[slot], state.id[other])) {
                        look(state.id[other]);
                        push(state.id[other], strong(other));
                    }
                }
            }
        }
    }

    private boolean comesNear(int moving, int slot) {
        float dx = state.differenceX(slot, moving);
        float dy = state.differenceY(slot, moving);
        float radii = radius(slot) + radius(moving);
        float far = (radii + Tuning.MARGIN * radii) + grid.path[moving];
        return dx * dx + dy * dy < far * far;
    }

    private void lookAtMovingWalls() {
        for (int slot = state.awake; slot < state.n && k.walls.any(); slot++) {
            int id = state.id[slot];
            if (sleepers().isAsleep(id) && wallsMoveNear(slot)) {
                look(id);
                push(id, strong(slot));
            }
        }
    }

    private boolean wallsMoveNear(int slot) {
        float[] travel = k.walls.travel;
        float x = state.circle[CircleRow.of(slot) + X];
        float y = state.circle[CircleRow.of(slot) + Y];
        float far = radius(slot) + Tuning.MARGIN * (2f * radius(slot));
        return travel[0] != 0f && x - k.bounds.minX() < far + Math.abs(travel[0])
                || travel[1] != 0f && k.bounds.maxX() - x < far + Math.abs(travel[1])
                || travel[2] != 0f && y - k.bounds.minY() < far + Math.abs(travel[2])
                || travel[3] != 0f && k.bounds.maxY() - y < far + Math.abs(travel[3]);
    }

    private void lookAtMovingPieces(TerrainStep terrain, PieceSearch pieces) {
        for (int node = terrain.groundNodes; node < terrain.nodes; node++) {
            int piece = terrain.links[2 * node + 1];
            if (piece >= 0 && terrain.traits[PieceRow.traits(piece) + PieceRow.MOTION] != 0) {
                float most = terrain.rows[PieceRow.of(piece) + PieceRow.MOST];
                int b = 4 * node;
                state.resting.find(
                        found,
                        k.arena,
                        terrain.boxes[b] - most,
                        terrain.boxes[b + 2] + most,
                        terrain.boxes[b + 1] - most,
                        terrain.boxes[b + 3] + most,
                        Sleep.NEIGHBOURS);
                for (int n = 0; n < found.count; n++) {
                    int other = found.slots[n];
                    if (sleepers().isAsleep(state.id[other]) && pieces.comesNear(other, piece, terrain)) {
                        look(state.id[other]);
                        push(state.id[other], strong(other));
                    }
                }
            }
        }
    }

    private void rememberBorder(int bordering) {
        if (border.length < bordering) {
            border = new int[list.length];
        }
        System.arraycopy(list, 0, border, 0, bordering);
        borderCount = bordering;
    }

    // ---- one that sleeps

    /** Adds what presses a circle besides those that are awake: others that do not move, walls and pieces. */
    private void sumUp(int id) {
        Sleepers all = sleepers();
        int slot = state.slotOf[id];
        for (int press = all.first(id); press >= 0; press = all.next(press, id)) {
            int other = state.slotOf[all.other(press, id)];
            boolean isLower = id < state.id[other];
            meet(isLower ? slot : other, isLower ? other : slot);
            press(slot, isLower, takeKept(press));
        }
        float w = state.ownInverseMass(slot);
        addWall(slot, w, 0, k.bounds.minX(), k.bounds.maxX());
        addWall(slot, w, 1, k.bounds.minY(), k.bounds.maxY());
        for (int c = 0; c < all.pieces(id); c++) {
            if (all.pieceNumbers(id)[PieceContactRow.numbers(c) + PieceContactRow.FEATURE] != PieceGap.NONE) {
                addPiece(slot, w, all.pieceRows(id), PieceContactRow.of(c));
            }
        }
        for (int e = bodies == null ? -1 : bodies.firstOf(id); e >= 0; e = bodies.next(e)) {
            if (bodies.measure(e)) {
                sums.press(slot, bodies, k.warmScale);
            }
        }
        for (int entry = joints == null ? 0 : joints.first(id);
                joints != null && entry < joints.first(id + 1);
                entry++) {
            addJoint(id, slot, joints.joint(entry));
        }
    }

    private void addJoint(int id, int slot, int joint) {
        if (joints.isThere(joint)) {
            boolean isA = joints.isA(joint, id);
            float x = joints.sumX(joint, k);
            float y = joints.sumY(joint, k);
            float twist = joints.twist(joint, k);
            float both = joints.both(joint, k);
            sums.add(
                    slot,
                    isA ? -x : x,
                    isA ? -y : y,
                    joints.load(joint, k),
                    (isA ? both + twist : both - twist) / radius(slot));
        }
    }

    private void addWall(int slot, float w, int axis, float min, float max) {
        float impulse = state.traits[CircleRow.of(slot) + WALL_X + axis];
        boolean turns = state.turning != null;
        float[] ofWalls = turns ? state.turning.wallRows : NO_WALL_ROWS;
        int at = (turns ? ContactRows.ofWalls(slot) : 0) + ContactRows.ofWall(0, axis);
        float nearer = Walls.wallSide(state.circle[CircleRow.of(slot) + X + axis], min, max);
        float side = impulse == 0f ? nearer : Math.signum(impulse);
        float acting = ContactRows.actingImpulse(Math.abs(impulse), ofWalls, at, ContactRows.OF_WALL);
        float j = ContactRows.impulseAlongNormal(Math.abs(impulse), ofWalls, at, ContactRows.OF_WALL);
        float f = Walls.tangentAlong(axis, side) * ContactRows.tangentImpulse(ofWalls, at, ContactRows.OF_WALL);
        float along = side * j / w;
        float across = acting > 0f ? f / w : 0f;
        float spin = ContactRows.spinOfOneBody(ofWalls, at, ContactRows.OF_WALL) / w;
        sums.add(slot, axis == 0 ? along : across, axis == 0 ? across : along, acting / w, spin);
    }

    private void addPiece(int slot, float w, float[] rows, int row) {
        float pushed = rows[row + PieceContactRow.IMPULSE];
        float acting = ContactRows.actingImpulse(pushed, rows, row + PieceContactRow.ROWS, 1) / w;
        if (acting > 0f) {
            float j = ContactRows.impulseAlongNormal(pushed, rows, row + PieceContactRow.ROWS, 1) / w;
            float f = ContactRows.tangentImpulse(rows, row + PieceContactRow.ROWS, 1) / w;
            float x = rows[row + PieceContactRow.NX];
            float y = rows[row + PieceContactRow.NY];
            float spin = ContactRows.spinOfOneBody(rows, row + PieceContactRow.ROWS, 1) / w;
            sums.add(slot, x * j - y * f, y * j + x * f, acting, spin);
        }
    }

    /** Decides whether a circle wakes. */
    private void judge(int id) {
        int slot = state.slotOf[id];
        sumUp(id);
        if (state.fields.getFloat(CircleField.TORQUE, id) != 0f) {
            push(id, strong(slot));
        }
        push(id, outOfBalance(id, slot));
        if (speed[id] > 0f) {
            addWoken(id);
        }
    }

    private float outOfBalance(int id, int slot) {
        float w = state.ownInverseMass(slot);
        float gainX = sums.gainX(slot);
        float gainY = sums.gainY(slot);
        float gain = CircleMath.length(gainX, gainY);
        float r = radius(slot);
        boolean strict = sleepers().learn(id, gainX, gainY, gain, r, k);
        float x = gainX + w * sums.sum(slot, SleeperSums.X);
        float y = gainY + w * sums.sum(slot, SleeperSums.Y);
        int offset = sleepers().offset(id, x, y, gain, strict);
        float b = CircleMath.length(x - Sleep.offsetX(offset, gain), y - Sleep.offsetY(offset, gain));
        if (joints != null && joints.turn(id)) {
            float spin = sums.sum(slot, SleeperSums.SPIN);
            b = CircleMath.max(b, Sleep.SHARE_OF_SPIN * Math.abs(state.turning.ownInverseInertia(slot) * spin));
        }
        if (!(b > Sleep.tolerance(strict, gain, w * sums.sum(slot, SleeperSums.LOAD), r, k.dt))) {
            sleepers().setRest(id, Sleep.ASLEEP);
            return 0f;
        }
        int rest = sleepers().rest(id) - 1;
        sleepers().setRest(id, rest);
        sleepers().suspect(id);
        int steps = Sleep.ASLEEP - rest;
        return Sleep.losesPatience(strict, gain, b, steps) ? Sleep.imbalanceOfStep(b, k.subSteps, r, k.dt) : 0f;
    }

    // ---- rings

    private void addWoken(int id) {
        if (wokenCount == woken.length) {
            woken = Arrays.copyOf(woken, 2 * wokenCount);
        }
        wokenIn[id] = step;
        woken[wokenCount++] = id;
    }

    /** Passes on what has woken circles, from ring to ring; all of a ring wake at once. */
    private void wakeRings() {
        int from = 0;
        for (int ring = 1; ring < Sleep.RINGS && (from < wokenCount || bodies != null && bodies.hasRing()); ring++) {
            int end = wokenCount;
            count = 0;
            if (bodies != null) {
                bodies.beginRing();
                bodies.passOn(this);
            }
            for (int n = from; n < end; n++) {
                passOn(woken[n]);
                if (bodies != null) {
                    bodies.passOnFrom(woken[n], speed[woken[n]]);
                }
                if (joints != null) {
                    passOnByJoints(woken[n]);
                }
            }
            for (int n = 0; n < count; n++) {
                int id = list[n];
                speed[id] = next[id];
                next[id] = 0f;
                if (speed[id] > Sleep.LEAST_HIT * radius(state.slotOf[id]) / k.dt) {
                    addWoken(id);
                }
            }
            from = end;
            if (bodies != null) {
                bodies.endRing();
            }
        }
    }

    @Override
    public void reachFromBody(int id, float itsSpeed, float j, float gap, float itsInverseMass) {
        if (sleepers().isAsleep(id) && wokenIn[id] != step) {
            reach(id, passedOn(itsSpeed, itsInverseMass, id, state.slotOf[id], j, gap));
        }
    }

    /** Whether there is no circle to look at but those near to circles and bodies that are awake. */
    boolean isIdle(RestingJoints held) {
        return borderCount == 0
                && sleepers().suspects() == 0
                && !sleepers().suspectsAll()
                && jointOrder == (held == null ? NO_JOINTS : held.order());
    }

    private void passOn(int id) {
        int slot = state.slotOf[id];
        int s = CircleRow.of(slot);
        float far = Sleep.NEIGHBOURS * radius(slot);
        float x = state.circle[s + X];
        float y = state.circle[s + Y];
        state.resting.find(found, k.arena, x - far, x + far, y - far, y + far, Sleep.NEIGHBOURS);
        for (int n = 0; n < found.count; n++) {
            int other = found.slots[n];
            int otherId = state.id[other];
            if (sleepers().isAsleep(otherId) && wokenIn[otherId] != step && PairFilter.wouldMeet(state, id, otherId)) {
                passOn(id, slot, otherId, other);
            }
        }
    }

    private void passOn(int id, int slot, int otherId, int other) {
        boolean isLower = otherId < id;
        meet(isLower ? other : slot, isLower ? slot : other);
        float radii = isLower ? radius(other) + radius(slot) : radius(slot) + radius(other);
        if (!(separation < Tuning.MARGIN * radii)) {
            return;
        }
        int press = sleepers().find(id, otherId);
        float acting = press < 0 ? 0f : ContactRows.actingImpulse(takeKept(press), rows, 0, 1);
        reach(otherId, passedOn(speed[id], state.ownInverseMass(slot), otherId, other, acting, separation));
    }

    private float passedOn(float itsSpeed, float itsInverseMass, int id, int slot, float j, float gap) {
        return sums.passedOn(slot, itsSpeed, j, j > 0f ? loadOf(id, slot) : 0f, gap, itsInverseMass);
    }

    private float passedFreely(int id, float itsInverseMass, int other, float gap) {
        return sums.passedOn(other, speed[id], 0f, 0f, gap, itsInverseMass);
    }

    /** What has woken a circle reaches another one with a speed, if that is not 0. */
    private void reach(int id, float passed) {
        if (passed > 0f) {
            if (next[id] == 0f) {
                if (count == list.length) {
                    list = Arrays.copyOf(list, 2 * count);
                }
                list[count++] = id;
            }
            next[id] = CircleMath.max(next[id], passed);
        }
    }

    /** By the joints of a circle that has woken. */
    private void passOnByJoints(int id) {
        for (int entry = joints.first(id); entry < joints.first(id + 1); entry++) {
            int joint = joints.joint(entry);
            int other = joints.other(joint, id);
            if (other != JointRow.NONE
                    && joints.isThere(joint)
                    && sleepers().isAsleep(other)
                    && wokenIn[other] != step) {
                passOn(joint, id, other);
            }
        }
    }

    private void passOn(int joint, int id, int otherId) {
        int slot = state.slotOf[id];
        int other = state.slotOf[otherId];
        float itsInverseMass = state.ownInverseMass(slot);
        float j = joints.load(joint, k);
        if (j > 0f) {
            reach(otherId, passedOn(speed[id], itsInverseMass, otherId, other, j, 0f));
            return;
        }
        float distance = joints.measure(joint);
        if (joints.has(joint, JointRow.RIGID)) {
            reach(otherId, passedFreely(id, itsInverseMass, other, 0f));
        }
        if (joints.has(joint, JointRow.LOWER)) {
            reach(
                    otherId,
                    passedFreely(id, itsInverseMass, other, distance - joints.value(joint, JointRow.MIN_LENGTH)));
        }
        if (joints.has(joint, JointRow.UPPER)) {
            reach(
                    otherId,
                    passedFreely(id, itsInverseMass, other, joints.value(joint, JointRow.MAX_LENGTH) - distance));
        }
    }

    /** The normal impulses on a circle. */
    private float loadOf(int id, int slot) {
        if (looked[id] != step) {
            begin(id);
            sumUp(id);
        }
        return sums.sum(slot, SleeperSums.LOAD);
    }
}
