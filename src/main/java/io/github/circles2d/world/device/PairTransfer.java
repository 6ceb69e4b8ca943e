package io.github.circles2d.world.device;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.EventArrays;
import io.github.circles2d.world.device.memory.GrownBuffer;
import io.github.circles2d.world.device.memory.Status;
import io.github.circles2d.world.device.memory.StatusWord;
import io.github.circles2d.world.device.plan.Stages;
import io.github.circles2d.world.events.ContactEvents;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/** Carries the pairs that touch between the host and the table of a device. No step is pending meanwhile. */
final class PairTransfer implements ContactEvents.Remote, AutoCloseable {
    private static final int PAIR = EventArrays.PAIR;

    private final Session session;
    private final DeviceArrays arrays;
    private final EventArrays deciding;
    private final ContactEvents events;

    /** The kernels of the last step that reported something, and the status of the pipeline. */
    private Stages stages;

    private Status status;

    /** Steps made since the world was. */
    private int stepsMade;

    private final GrownBuffer ids;

    /** Pairs, as the table has them. */
    private int[] words = new int[0];

    private float[] hits = new float[0];

    PairTransfer(Session session, DeviceArrays arrays, EventArrays deciding, ContactEvents events) {
        this.session = session;
        ids = new GrownBuffer(session, "events: circles");
        this.arrays = arrays;
        this.deciding = deciding;
        this.events = events;
    }

    void use(Stages kernels, Status ofPipeline) {
        stages = kernels;
        status = ofPipeline;
    }

    void stepsMade(int steps) {
        stepsMade = steps;
    }

    private int lastStep() {
        return EventArrays.FIRST_STEP + stepsMade - 1;
    }

    void send() {
        int count = events.pairs();
        if (deciding.freePlaces(0) < 2L * count || deciding.touching() == null) {
            DeviceBuffer before = deciding.replaceTable(count);
            if (before != null) {
                before.close();
            }
        }
        deciding.setStep(stepsMade, true, 0);
        status.set(StatusWord.TOUCHING, count);
        status.set(StatusWord.PLACES_USED, 0);
        status.write(arrays);
        stages.events().clear();
        if (count > 0) {
            deciding.ensureRoom(count);
            sendHits();
            ensureWords(count);
            for (int pair = 0; pair < count; pair++) {
                int at = PAIR * pair;
                int hit = events.openHit(pair);
                words[at + EventArrays.PAIR_LOWER] = events.lower(pair);
                words[at + EventArrays.PAIR_HIGHER] = events.higher(pair);
                words[at + EventArrays.PAIR_STEP] = lastStep();
                words[at + EventArrays.PAIR_OPEN] =
                        hit == ContactEvents.NONE ? EventArrays.NO_HIT : EventArrays.openHit(hit, lastStep());
            }
            deciding.newcomers().write(0, IntBuffer.wrap(words, 0, PAIR * count));
            stages.events().add(count);
        }
        events.sent();
    }

    private void sendHits() {
        int count = events.openHits();
        if (count == 0) {
            return;
        }
        deciding.ensureOpenHits(count);
        ensureHits(count);
        for (int hit = 0; hit < count; hit++) {
            events.copyOpenHit(hit, hits, EventArrays.placeOfHit(hit, lastStep()));
        }
        deciding.openHits().write(FloatBuffer.wrap(hits, 0, EventArrays.placeOfHit(count, 0)));
    }

    private void ensureWords(int count) {
        if (words.length < PAIR * (long) count) {
            words = new int[Math.multiplyExact(PAIR, count + (count >> 2))];
        }
    }

    private void ensureHits(int count) {
        if (hits.length < EventArrays.placeOfHit(count, 0)) {
            hits = new float[EventArrays.placeOfHit(count + (count >> 2) + 1, 0)];
        }
    }

    @Override
    public void fetchAll() {
        int places = deciding.places();
        ensureWords(places);
        deciding.touching().read(IntBuffer.wrap(words, 0, PAIR * places));
        receive(places);
    }

    @Override
    public boolean mayKnow(int id) {
        return id < deciding.ids();
    }

    @Override
    public void fetchOf(int[] circles, int count) {
        take(circles, count);
        int found = listed(count);
        if (found > deciding.room()) {
            deciding.ensureRoom(found);
            found = listed(count);
        }
        if (found > 0) {
            ensureWords(found);
            deciding.newcomers().read(IntBuffer.wrap(words, 0, PAIR * found));
            receive(found);
        }
    }

    private int listed(int count) {
        stages.events().ofCircles(ids.get(), count, false);
        status.read(arrays);
        return status.get(StatusWord.PAIRS_MARKED);
    }

    @Override
    public void forgetOf(int[] circles, int count) {
        take(circles, count);
        stages.events().ofCircles(ids.get(), count, true);
    }

    private void take(int[] circles, int count) {
        ids.ensureRoomy((long) Integer.BYTES * count).write(0, IntBuffer.wrap(circles, 0, count));
        deciding.setStep(stepsMade - 1, true, 0);
    }

    /** Hands over the pairs of the first rows of words that touched in the last step. */
    private void receive(int rows) {
        int mostHit = -1;
        for (int row = 0; row < rows; row++) {
            mostHit = Math.max(mostHit, EventArrays.hitOf(words[PAIR * row + EventArrays.PAIR_OPEN], lastStep()));
        }
        if (mostHit >= 0) {
            mostHit = Math.min(mostHit, deciding.openRoom() - 1);
            ensureHits(mostHit + 1);
            deciding.openHits().read(FloatBuffer.wrap(hits, 0, EventArrays.placeOfHit(mostHit + 1, 0)));
        }
        for (int row = 0; row < rows; row++) {
            int at = PAIR * row;
            if (words[at + EventArrays.PAIR_STEP] == lastStep()) {
                int hit = EventArrays.hitOf(words[at + EventArrays.PAIR_OPEN], lastStep());
                events.receive(
                        words[at + EventArrays.PAIR_LOWER],
                        words[at + EventArrays.PAIR_HIGHER],
                        hits,
                        hit < 0 ? -1 : EventArrays.placeOfHit(hit, lastStep()));
            }
        }
    }

    /** Moves the pairs into a table with room for more; those of the last step, whose events lack room, stay as the step found them. */
    void moveToLarger(int count) {
        int places = deciding.places();
        DeviceBuffer before = deciding.replaceTable(count);
        status.set(StatusWord.PLACES_USED, 0);
        status.write(arrays);
        stages.events().clear();
        stages.events().move(before, places);
        session.finish();
        before.close();
        status.read(arrays);
    }

    @Override
    public void close() {
        ids.close();
    }
}
