package io.github.circles2d.world.device;

import io.github.circles2d.opencl.CopyQueue;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.EventArrays;
import io.github.circles2d.world.device.memory.GrownBuffer;
import io.github.circles2d.world.device.memory.SensingArrays;
import io.github.circles2d.world.device.memory.Status;
import io.github.circles2d.world.device.memory.StatusWord;
import io.github.circles2d.world.device.memory.TouchArrays;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Stages;
import io.github.circles2d.world.device.plan.Steps;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.EventRow;
import io.github.circles2d.world.model.StepReports;
import java.nio.IntBuffer;

/**
 * What a world on a device reports: the memory for it, what it takes around a step, and the events of steps that have been made. Steps
 * that the host reads together are a batch; while it reads one batch, the steps of the next write into the other half of the memory.
 */
final class ReportReader implements AutoCloseable {
    private static final int NONE = -1;

    /** Events that a first read takes at least. */
    private static final int LEAST_READ = 64;

    private static final int ROW_BYTES = Integer.BYTES * EventRow.STRIDE;

    private final Session session;
    private final DeviceArrays arrays;
    private final ContactEvents events;
    private final TouchArrays touches;
    private final EventArrays deciding;
    private final SensingArrays sensing;
    private final PairTransfer pairs;

    /** What of the steps that have been enqueued is reported. */
    private boolean recording;

    private boolean ofPieces;
    private boolean sensed;
    private boolean statics;
    private boolean bodies;
    private int seekingVersion;

    /** The half that the steps of the batch write into, and whether it has one. */
    private int half;

    private boolean batchBegun;

    /** Steps made, since the world was, of which events have been published. */
    private int published;

    /** Events of the batch read last: about as many are read at once of the next. */
    private int lastCount;

    private final GrownBuffer.OnHost read;

    /** Events of the batch, as it is, that {@link #read} has or is about to have; 0 if it has none. */
    private int readAhead;

    /** Null until events are requested, as what they arrive in. */
    private CopyQueue copies;

    private final GrownBuffer.OnHost arriving;

    /** The half of the batch that is being copied, or NONE; the steps made behind it; how many events are copied. */
    private int requestedHalf = NONE;

    private int requestedSteps;
    private int requestedRows;

    ReportReader(Session session, ContactEvents events, DeviceArrays arrays, int stepsMade) {
        this.session = session;
        read = new GrownBuffer.OnHost(session);
        arriving = new GrownBuffer.OnHost(session);
        this.arrays = arrays;
        this.events = events;
        published = stepsMade;
        touches = new TouchArrays(session, events.hasWalls());
        deciding = new EventArrays(session);
        sensing = new SensingArrays(session);
        pairs = new PairTransfer(session, arrays, deciding, events);
        pairs.stepsMade(stepsMade);
        events.setRemote(pairs);
    }

    TouchArrays touches() {
        return touches;
    }

    EventArrays deciding() {
        return deciding;
    }

    /** Takes down what of the steps to come is reported; none are pending. */
    void learn(StepReports k) {
        recording = k.recording;
        ofPieces = k.pieces;
        sensed = k.sensing;
        statics = k.statics;
        bodies = k.bodies;
        seekingVersion = k.seekingVersion;
    }

    /** Whether steps report what was taken down. */
    boolean areOf(StepReports k) {
        return recording == k.recording
                && ofPieces == k.pieces
                && sensed == k.sensing
                && statics == k.statics
                && bodies == k.bodies
                && seekingVersion == k.seekingVersion;
    }

    /** Whether steps record what contacts and walls do. */
    boolean isRecording() {
        return recording;
    }

    /** Whether pairs are looked for that are only sensed. */
    boolean isSensing() {
        return sensed;
    }

    /** Whether the device has something to decide. */
    boolean isActive() {
        return recording || sensed;
    }

    /** Compiles what only the steps of some worlds need. None are pending. */
    void compile(Stages stages) {
        if (sensed) {
            stages.sensing().prepare(statics, bodies);
        }
    }

    /** Makes ready for the steps to come, whose kernels are loaded and bound; none are pending. */
    void prepare(StepReports k, Stages stages, Status status) {
        if (!isActive()) {
            events.bringHere();
            return;
        }
        deciding.ensure(arrays, recording ? arrays.slotCapacity() : 0);
        if (sensed) {
            sensing.ensure(arrays);
            sensing.send(k);
        }
        touches.setPieces(ofPieces);
        deciding.send(events);
        deciding.setHitSpeed(events.tracker.hitSpeed());
        pairs.use(stages, status);
        if (!events.areThere()) {
            pairs.send();
        }
        events.leave();
    }

    /** Comes before steps are enqueued that one launch makes, or one step. */
    void before(Stages stages, Plan plan, Steps steps, int stepsMade) {
        if (recording) {
            touches.ensure(arrays); // there may be room for more contacts than before
        }
        deciding.setStep(stepsMade, !batchBegun, half);
        batchBegun = true;
        if (!plan.decidesEvents(steps)) {
            stages.events().begin();
        }
        if (sensed) {
            stages.sensing().begin(sensing, steps.slots());
        }
    }

    /** Comes behind them. */
    void behind(Stages stages, Plan plan, Steps steps) {
        if (!plan.decidesEvents(steps)) {
            if (!plan.tells()) {
                tell(stages, plan, steps.circles());
            }
            decide(stages, steps.circles());
        }
    }

    private void tell(Stages stages, Plan plan, int circles) {
        if (recording) {
            plan.tell(circles);
        }
    }

    private void decide(Stages stages, int circles) {
        if (sensed) {
            stages.sensing().find(sensing, circles);
        }
        stages.events().decide(circles);
    }

    /** Has the events of the batch read together with the status, which the caller reads next: a wait of its own costs more. */
    void readAhead() {
        if (isActive() && batchBegun && requestedHalf == NONE) {
            readAhead = guess();
            deciding.decided(half).readLater(read.ensure(bytes(readAhead)), bytes(readAhead));
        }
    }

    /** Publishes the events of steps; the status then has no lack of room for events. */
    void made(Status status, int stepsMade, Stages stages, Plan plan, int circles) {
        pairs.stepsMade(stepsMade);
        if (!isActive()) {
            return; // published already
        }
        if (status.has(StatusWord.EVENTS_LACK)) {
            publish(stepsMade - 1);
            makeUp(status, stepsMade, stages, plan, circles);
        }
        publish(stepsMade);
    }

    /** Begins another batch: all steps that have been made are published, and those that have been refused will be enqueued once more. */
    void beginBatch() {
        if (requestedHalf != NONE) {
            copies.finish();
            requestedHalf = NONE;
        }
        batchBegun = false;
        readAhead = 0;
    }

    /** Publishes steps that tell of nothing, made or not: the first ends the pairs that touched. */
    void publishSilent(int steps) {
        if (published < steps) {
            events.endStep();
            published++;
        }
        if (published < steps) {
            events.emptySteps(steps - published);
            published = steps;
        }
    }

    /** Makes the room that the last step lacked for its events, and has them decided once more. */
    private void makeUp(Status status, int stepsMade, Stages stages, Plan plan, int circles) {
        readAhead = 0; // it has the steps before alone
        while (status.has(StatusWord.EVENTS_LACK)) {
            int newcomers = status.get(StatusWord.NEWCOMERS);
            int wanted = Math.max(status.get(StatusWord.DRAFTS), newcomers);
            deciding.setStep(stepsMade - 1, true, half);
            deciding.ensureRoom(wanted + (wanted >> 2));
            deciding.ensureOpenHits(status.get(StatusWord.OPEN_HITS));
            if (newcomers > deciding.freePlaces(status.get(StatusWord.PLACES_BEFORE))) {
                pairs.moveToLarger(status.get(StatusWord.TOUCHING) + newcomers);
            }
            status.clear(StatusWord.EVENTS_LACK, StatusWord.OUT_OF_ROOM);
            status.write(arrays);
            stages.events().begin();
            tell(stages, plan, circles);
            decide(stages, circles);
            stages.end(circles);
            status.read(arrays);
        }
    }

    /** Publishes the events of the steps up to one. */
    private void publish(int steps) {
        if (requestedHalf != NONE) {
            copies.finish();
            readHalf(requestedHalf, Math.min(steps, requestedSteps));
            requestedHalf = NONE;
        }
        readHalf(half, steps);
    }

    private void readHalf(int which, int steps) {
        if (published >= steps) {
            return;
        }
        DeviceBuffer decided = deciding.decided(which);
        int guess = readAhead;
        readAhead = 0;
        if (guess == 0) {
            guess = guess();
            decided.read(0, read.ensure(bytes(guess)), 0, bytes(guess));
        }
        int count = read.get().ints().get(EventArrays.HEADER_EVENTS);
        if (count > guess) {
            decided.read(0, read.ensure(bytes(count)), 0, bytes(count));
        }
        publish(read.get().ints(), steps);
    }

    private int guess() {
        return Math.min(deciding.room(), Math.max(LEAST_READ, lastCount + (lastCount >> 2)));
    }

    private static long bytes(int rows) {
        return (1L + rows) * ROW_BYTES;
    }

    /** Publishes the events of a batch up to a step. words: the header, as long as an event, and events. */
    private void publish(IntBuffer words, int steps) {
        int end = 1 + words.get(EventArrays.HEADER_EVENTS);
        boolean ordered = words.get(EventArrays.HEADER_UNORDERED) == 0;
        lastCount = end - 1;
        int row = 1;
        for (; published < steps; published++) {
            int first = row;
            int number = EventArrays.FIRST_STEP + published;
            while (row < end && words.get(EventRow.STRIDE * row + EventRow.STEP) == number) {
                row++;
            }
            events.publishDecided(words, first, row - first, ordered);
        }
    }

    /** Has the events of the batch copied, and begins another. */
    void request(int steps) {
        if (!isActive() || !batchBegun) {
            return;
        }
        if (copies == null) {
            copies = session.copyQueue();
        }
        requestedRows = guess();
        copies.read(deciding.decided(half), arriving.ensure(bytes(requestedRows)), bytes(requestedRows));
        requestedHalf = half;
        requestedSteps = steps;
        half = 1 - half;
        batchBegun = false;
    }

    /** Whether a batch has been requested and not been published. */
    boolean hasRequest() {
        return requestedHalf != NONE;
    }

    /** Publishes the events of the batch that was requested. Returns false if they are not there: some step has not been made. */
    boolean finishRequest() {
        copies.finish();
        IntBuffer words = arriving.get().ints();
        int last = EventArrays.FIRST_STEP + requestedSteps - 1;
        if (words.get(EventArrays.HEADER_STEP) != last || words.get(EventArrays.HEADER_EVENTS) > requestedRows) {
            return false;
        }
        publish(words, requestedSteps);
        requestedHalf = NONE;
        return true;
    }

    @Override
    public void close() {
        if (requestedHalf != NONE) {
            copies.finish();
        }
        read.close();
        arriving.close();
        touches.close();
        deciding.close();
        sensing.close();
        pairs.close();
    }
}
