package io.github.circles2d.world.device;

import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.Status;
import io.github.circles2d.world.device.memory.StatusWord;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Stages;
import io.github.circles2d.world.device.plan.Steps;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepConstants;
import java.util.List;

/**
 * The steps that have been enqueued and not been looked at. Steps are enqueued for the common case: there is room for the contacts, no
 * circle is fast, and no circle is in a crowd. A step that meets another case is refused: it changes nothing, and neither do the steps
 * behind it. {@link #settle} then enlarges the arrays, or enqueues the missing steps with what the case needs.
 */
final class StepQueue {
    /** How many circles, slots and cached impulses the device has at home: in the arrays that stay between steps. */
    static final class Home {
        /** Slots; circles that have gone may have left some of them empty. */
        int slots;

        int circles;

        /** Contacts of the last step, which cached impulses are numbered by. */
        int cachedContacts;
    }

    /** After so many steps the host looks at their status before it goes on, so that the queue stays short. */
    private static final int MOST_PENDING = 64;

    /** After so many batches of steps without a fast circle, or a crowd, steps are made without heed of them again. */
    private static final int CALM = 16;

    /** Contacts a circle for which room is made, before it is tried whether crowds can be thinned out. */
    private static final int ROOM_PER_CIRCLE = 24;

    private static final int LEAST_ROOM = 4096;

    private final DeviceArrays arrays;
    private final Home home;
    private final List<Plan> plans;
    private final CommandsStage commands;
    private final RequestedPositions requested;
    private final StepStatistics stats;
    private final Status status = new Status();

    /** What is reported of the steps; null if nobody is told. */
    private ReportReader reader;

    private Stages stages;

    /** What makes the steps that were enqueued last; null before the first. */
    private Plan plan;

    /** The steps that have been enqueued and not been looked at. */
    private int pending;

    /** Steps written home when it was looked last. */
    private int seen;

    /** For how many more batches steps heed fast circles; 0 if they do not. */
    private int sweeping;

    /** For how many more batches steps thin crowds out; 0 if they do not. */
    private int thinning;

    private final GridLevels levels = new GridLevels();
    private int subSteps;
    private float warmScale;

    /** Whether circles fall asleep and wake. */
    private boolean sleeping;

    /** For how many more batches steps can wake circles; 0 if they do not take any that sleep. */
    private int waking;

    /** Whether a further step would change nothing, if nothing else is new. */
    private boolean quiet;

    /** How many circles were awake behind the last step that the host has seen; negative if all are, or nobody knows. */
    private int awake = -1;

    StepQueue(
            DeviceArrays arrays,
            Home home,
            List<Plan> plans,
            CommandsStage commands,
            RequestedPositions requested,
            StepStatistics stats) {
        this.arrays = arrays;
        this.home = home;
        this.plans = plans;
        this.commands = commands;
        this.requested = requested;
        this.stats = stats;
        status.write(arrays);
    }

    /** Sets what further steps are made with. None are pending. */
    void use(Stages newStages, ReportReader newReader) {
        stages = newStages;
        reader = newReader;
    }

    /** Sets the shape of further steps; copies it, since the caller may change it before these are known to have found room. */
    void begin(GridLevels shape, StepConstants k) {
        levels.copy(shape);
        subSteps = k.subSteps;
        warmScale = k.warmScale;
        sleeping = k.sleeping;
        quiet = false;
    }

    Status status() {
        return status;
    }

    /** Whether a step may be enqueued behind those that are pending, if it is as they are. */
    boolean canContinue() {
        return pending > 0 && warmScale == 1f;
    }

    /** Whether all that has been enqueued has been made, and a further step would change nothing unless something else is new. */
    boolean isQuiet() {
        return pending == 0 && quiet;
    }

    /** Something is new. */
    void stir() {
        quiet = false;
    }

    /** Circles of another world come. */
    void load() {
        quiet = false;
        awake = -1;
    }

    /** About how many of so many circles are awake. */
    int awake(int circles) {
        return awake < 0 ? circles : Math.min(awake, circles);
    }

    /** Steps that have been enqueued since the world was made. */
    int enqueued() {
        return seen + pending;
    }

    /** Steps that are known to have been made. */
    int seen() {
        return seen;
    }

    int slotsBehindPending() {
        return pending == 0 ? home.slots : home.circles;
    }

    void add(int steps) {
        for (int left = steps; left > 0; ) {
            if (pending == MOST_PENDING) {
                settle();
            }
            if (reader == null && isQuiet()) {
                return;
            }
            int count = Math.min(left, MOST_PENDING - pending);
            enqueue(count);
            left -= count;
        }
    }

    private void enqueue(int steps) {
        for (int left = steps; left > 0; ) {
            left -= enqueueAtOnce(left);
        }
    }

    /** Enqueues steps that need nothing in between; returns how many of those wanted. */
    private int enqueueAtOnce(int most) {
        boolean reports = reader != null && reader.isActive();
        Steps wanted = steps(most, reports, false);
        plan = Plans.first(plans, wanted);
        if (stages.lackKernels(wanted)) {
            CompilerNotice.during(() -> stages.compile(wanted), stages.device().name());
        }
        if (!reports) {
            pending += most;
            plan.enqueue(wanted);
            return most;
        }
        boolean decides = plan.decidesEvents(wanted);
        Steps enqueued = decides ? wanted : steps(1, true, true);
        reader.before(stages, plan, enqueued, enqueued());
        pending += enqueued.count();
        plan.enqueue(enqueued);
        reader.behind(stages, plan, enqueued);
        if (!decides) {
            stages.end(enqueued.circles());
        }
        return enqueued.count();
    }

    private Steps steps(int count, boolean reports, boolean reportsBehind) {
        return new Steps(
                count,
                levels,
                slotsBehindPending(),
                home.circles,
                subSteps,
                // Behind pending steps the state is as a step leaves it, and the length of the step before is that of
                // the step.
                pending == 0 ? warmScale : 1f,
                sweeping > 0,
                thinning > 0,
                reportsBehind,
                reports && reader.isRecording(),
                reports && reader.isSensing(),
                arrays.features().turning(),
                stages.haveJoints(),
                arrays.features().bodies(),
                sleeping,
                sleeping && waking > 0);
    }

    /** Waits until all steps have been made. */
    void settle() {
        while (pending > 0) {
            if (reader != null) {
                reader.readAhead();
            }
            status.read(arrays);
            takeMade(status.get(StatusWord.STEPS_DONE) - seen);
            for (Plan each : plans) {
                each.learn(Plan.TileUse.of(status), thinning > 0);
            }
            if (pending == 0) {
                home.cachedContacts = cachedContacts();
                stats.stepped(plan, home.circles, status.get(StatusWord.CONTACTS));
                sweeping = status.has(StatusWord.FAST) && sweeping > 0 ? CALM : Math.max(0, sweeping - 1);
                thinning = status.has(StatusWord.CROWDED) ? CALM : Math.max(0, thinning - 1);
                awake = sleeping ? status.get(StatusWord.AWAKE) : -1;
                quiet = sleeping && waking > 0 && !status.has(StatusWord.RESTLESS) && stages.bodiesAreIdle();
                waking = status.has(StatusWord.SLEEPERS) ? CALM : Math.max(0, waking - 1);
            } else {
                adapt();
                enqueueRefused();
            }
        }
    }

    /** Contacts of the last step, and pairs at rest behind them. */
    private int cachedContacts() {
        return status.get(StatusWord.CONTACTS) + status.get(StatusWord.KEPT_COUNT);
    }

    private void takeMade(int done) {
        seen += done;
        if (done > 0) {
            home.slots = home.circles;
            commands.slotsInOrder();
            warmScale = 1f;
            if (reader != null) {
                reader.made(status, seen, stages, plan, home.circles);
            }
        }
        if (reader != null) {
            reader.beginBatch();
        }
        pending -= done;
    }

    private void enqueueRefused() {
        int refused = pending;
        pending = 0;
        int beforeRequest = requested.missing(seen);
        if (beforeRequest > 0) {
            enqueue(beforeRequest);
            requested.layOut(home.circles);
        }
        if (refused > beforeRequest) {
            enqueue(refused - beforeRequest);
        }
    }

    /** Changes what the step lacked that has been refused. */
    private void adapt() {
        int contacts = cachedContacts();
        if (sleeping && status.has(StatusWord.SLEEPERS)) {
            waking = CALM;
        }
        if (sweeping == 0 && status.has(StatusWord.FAST)) {
            sweeping = CALM;
        }
        if (thinning == 0 && status.has(StatusWord.CROWDED)) {
            thinning = CALM; // the room that the step asked for is for all pairs of the crowd
        } else if (status.has(StatusWord.OUT_OF_ROOM) && contacts > arrays.contactCapacity()) {
            if (thinning == 0 && contacts > LEAST_ROOM + (long) ROOM_PER_CIRCLE * home.circles) {
                thinning = CALM;
            } else {
                arrays.ensureContacts(contacts);
            }
        }
        if (status.has(StatusWord.OUT_OF_ROOM) && status.get(StatusWord.PIECES_FOUND) > arrays.contactCapacity()) {
            arrays.ensureContacts(status.get(StatusWord.PIECES_FOUND));
        }
        if (status.has(StatusWord.OUT_OF_ROOM) && !arrays.ensureCopies(status.get(StatusWord.TILE_COPIES))) {
            // Steps without tiles need no copies.
            for (Plan each : plans) {
                each.learn(Plan.TileUse.NONE_DO, thinning > 0);
            }
        }
        status.clear(
                StatusWord.TILE_COPIES,
                StatusWord.OUT_OF_ROOM,
                StatusWord.FAST,
                StatusWord.CROWDED,
                StatusWord.TILE_PEAK);
        status.write(arrays);
    }
}
