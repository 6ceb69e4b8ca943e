package io.github.circles2d.world.device;

import io.github.circles2d.world.circles.SavedCircles;
import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.device.memory.CachedImpulse;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.FieldsStruct;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.snapshots.SavedState;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;

/** A copy of a device's state on the host, for the hash and for snapshots, which are seldom needed. */
final class StateTransfer {
    /** Floats of a circle in each of circle, motion and traits. */
    private static final int FLOATS = 4;

    /** Ints of a circle's turn: its angle, the bits of its angular velocity. */
    private static final int TURN_INTS = 2;

    /** From so many circles on several threads save them. */
    private static final int LEAST_SHARED = 32_768;

    /** Where traits hold what does not follow from the circle. */
    private static final int AT_RESTITUTION = 1;

    /**
     * Memory that a saved state needs on its way to the device. It serves again, for fresh memory takes longer than what is done with it, so
     * arrays may be longer than their contents.
     */
    static final class Links {
        private int[] slotOf = new int[0];
        private int[] firstCached = new int[0];
        private int[] entries = new int[0];
        private int[] fields = new int[0];

        /** As the next three, of circles that can rotate. */
        private int[] turn = new int[0];

        private int[] own = new int[0];
        private float[] cachedRows = new float[0];

        /** Of walls, if the state has none: zeros. */
        private float[] noRows = new float[0];

        /** As the next, of circles that sleep. */
        private int[] sleep = new int[0];

        /** Traits with the inverse masses that steps see. */
        private float[] traits = new float[0];

        /** Of circles that move in another way than those of their kind. */
        private int[] motion = new int[0];

        private final PieceTransfer.Room pieces = new PieceTransfer.Room();

        /** Makes room for a state. */
        void ensure(SavedState from, DeviceArrays arrays) {
            int n = from.circles;
            slotOf = ints(slotOf, arrays.idCapacity());
            firstCached = ints(firstCached, n);
            entries = ints(entries, CachedImpulse.STRIDE * from.impulses);
            fields = ints(fields, FieldsStruct.words(from.ids));
            if (arrays.features().turning()) {
                turn = ints(turn, TURN_INTS * n);
                own = ints(own, FieldsStruct.STRIDE * n);
                cachedRows = floats(cachedRows, ContactRows.of(from.impulses));
                noRows = floats(noRows, from.turns ? 0 : ContactRows.ofWalls(n));
            }
            if (arrays.features().sleeping()) {
                sleep = ints(sleep, Readback.SLEEP_INTS * n);
                traits = floats(traits, FLOATS * n);
            }
            if (arrays.features().ownMotion()) {
                motion = ints(motion, FieldsStruct.STRIDE * from.ids);
            }
            if (arrays.features().terrain()) {
                pieces.ensure(from);
            }
        }
    }

    /** Ints that are held, if they are so many, else others. */
    static int[] ints(int[] held, int count) {
        return held.length < count ? new int[count] : held;
    }

    /** Likewise. */
    static float[] floats(float[] held, int count) {
        return held.length < count ? new float[count] : held;
    }

    private final DeviceArrays arrays;
    private int slots;

    // as the device has them; longer than their contents if they have served before
    private int[] id = new int[0];
    private int[] firstCached = new int[0];
    private int[] slotOf = new int[0];

    /** Entries of the impulse cache, as {@link CachedImpulse} says. */
    private int[] entries = new int[0];

    private boolean turning;

    /** As the next two, of circles that can rotate. */
    private int[] turn = new int[0];

    private float[] wallRows = new float[0];
    private float[] cachedRows = new float[0];

    private boolean sleeping;

    /** Whether circles may have come to rest: else {@link #sleep} is not read. */
    private boolean rests;

    private int[] sleep = new int[0];

    /** It has no copy yet. */
    StateTransfer(DeviceArrays arrays) {
        this.arrays = arrays;
    }

    /** Copies what the device has, with how circles have come to rest, if they may have. */
    StateTransfer copy(int slotsAtHome, int cachedContacts, boolean sleeps) {
        slots = slotsAtHome;
        id = read(DeviceArray.HOME_ID, id, slots);
        firstCached = read(DeviceArray.HOME_FIRST_CACHED, firstCached, slots);
        slotOf = read(DeviceArray.SLOT_OF, slotOf, arrays.idCapacity());
        entries = read(DeviceArray.IMPULSE_CACHE, entries, CachedImpulse.STRIDE * cachedContacts);
        sleeping = arrays.features().sleeping();
        rests = sleeps && sleeping;
        if (rests) {
            sleep = read(DeviceArray.HOME_SLEEP, sleep, Readback.SLEEP_INTS * slots);
        }
        turning = arrays.features().turning();
        if (turning) {
            turn = read(DeviceArray.HOME_TURN, turn, TURN_INTS * slots);
            wallRows = read(DeviceArray.HOME_WALL_ROWS, wallRows, ContactRows.ofWalls(slots));
            cachedRows = read(DeviceArray.ROW_CACHE, cachedRows, ContactRows.of(cachedContacts));
        }
        return this;
    }

    private int[] read(DeviceArray array, int[] held, int count) {
        int[] to = ints(held, count);
        arrays.get(array).read(IntBuffer.wrap(to, 0, count));
        return to;
    }

    private float[] read(DeviceArray array, float[] held, int count) {
        float[] to = floats(held, count);
        arrays.get(array).read(FloatBuffer.wrap(to, 0, count));
        return to;
    }

    private float[] rows(DeviceArray array) {
        return Readback.floats(arrays.get(array), FLOATS * slots);
    }

    long hash() {
        float[] circle = rows(DeviceArray.HOME_CIRCLE);
        float[] motion = rows(DeviceArray.HOME_MOTION);
        float[] traits = rows(DeviceArray.HOME_TRAITS);
        long sum = 0;
        for (int slot = 0; slot < slots; slot++) {
            if (id[slot] >= 0) {
                sum += hashOfCircle(slot, circle, motion, traits) + hashOfMemory(slot);
                sum += turning
                        ? StateHash.turn(
                                id[slot], angle(slot), angularVelocity(slot), wallRows, ContactRows.ofWalls(slot))
                        : 0;
                sum += StateHash.rest(id[slot], rest(slot), drift(slot, 0), drift(slot, 1), turned(slot));
            }
        }
        return sum;
    }

    private int rest(int slot) {
        return sleepOf(slot, 0);
    }

    private float drift(int slot, int axis) {
        return Float.intBitsToFloat(sleepOf(slot, 1 + axis));
    }

    private int turned(int slot) {
        return sleepOf(slot, 3);
    }

    private int sleepOf(int slot, int place) {
        return !rests ? 0 : sleep[Readback.SLEEP_INTS * slot + place];
    }

    private long hashOfCircle(int slot, float[] circle, float[] motion, float[] traits) {
        int s = FLOATS * slot;
        long h = StateHash.absorb(StateHash.circle(), id[slot]);
        for (int k = 0; k < FLOATS; k++) {
            h = StateHash.absorb(h, circle[s + k]);
        }
        for (int k = 0; k < FLOATS; k++) {
            h = StateHash.absorb(h, motion[s + k]);
        }
        for (int k = AT_RESTITUTION; k < FLOATS; k++) {
            h = StateHash.absorb(h, traits[s + k]);
        }
        return h;
    }

    private int angle(int slot) {
        return turn[TURN_INTS * slot];
    }

    private float angularVelocity(int slot) {
        return Float.intBitsToFloat(turn[TURN_INTS * slot + 1]);
    }

    private long hashOfMemory(int slot) {
        long sum = 0;
        for (int c = firstCached[slot]; c >= 0; c = entries[at(c, CachedImpulse.AT_NEXT)]) {
            if (isFound(c)) {
                long h = StateHash.absorb(
                        StateHash.absorb(StateHash.impulse(), id[slot]), entries[at(c, CachedImpulse.AT_HIGHER_ID)]);
                sum += StateHash.absorb(h, Float.intBitsToFloat(entries[at(c, CachedImpulse.AT_IMPULSE)]));
                if (turning) {
                    sum += StateHash.rows(
                            id[slot], entries[at(c, CachedImpulse.AT_HIGHER_ID)], cachedRows, ContactRows.of(c));
                }
            }
        }
        return sum;
    }

    private static int at(int contact, int field) {
        return CachedImpulse.STRIDE * contact + field;
    }

    /** Whether the circle of higher id is still the one that the impulse belongs to. */
    private boolean isFound(int c) {
        int hi = slotOf[entries[at(c, CachedImpulse.AT_HIGHER_ID)]];
        return hi >= 0 && firstCached[hi] != CachedImpulse.FRESH;
    }

    /** Saves the circles whose ids are given, and the impulses; many circles by several threads. */
    void save(SavedState into) {
        into.setTurns(turning);
        into.setSleeps(sleeping);
        saveRows(DeviceArray.HOME_CIRCLE, into, into.circle);
        saveRows(DeviceArray.HOME_MOTION, into, into.motion);
        saveRows(DeviceArray.HOME_TRAITS, into, into.traits);
        int[] places = new int[SavedCircles.PARTS];
        inParts(into, part -> places[part] = countImpulses(into, part));
        into.placeImpulses(places);
        inParts(into, part -> {
            saveFeatures(into, part);
            saveImpulses(into, part, places[part]);
        });
    }

    private static void inParts(SavedState into, IntConsumer work) {
        IntStream parts = IntStream.range(0, SavedCircles.PARTS);
        (into.circles < LEAST_SHARED ? parts : parts.parallel()).forEach(work);
    }

    /** Circles that are asked for as they lie, as on the way to another pipeline, are read to where they go. */
    private void saveRows(DeviceArray array, SavedState into, float[] to) {
        if (Arrays.equals(id, 0, slots, into.id, 0, into.circles)) {
            arrays.get(array).read(FloatBuffer.wrap(to, 0, FLOATS * slots));
            return;
        }
        float[] rows = rows(array);
        inParts(into, part -> {
            for (int k = into.part(part); k < into.part(part + 1); k++) {
                System.arraycopy(rows, FLOATS * slotOf[into.id[k]], to, FLOATS * k, FLOATS);
            }
        });
    }

    private void saveFeatures(SavedState into, int part) {
        int to = into.part(part + 1);
        for (int k = into.part(part); (turning || sleeping) && k < to; k++) {
            int slot = slotOf[into.id[k]];
            if (turning) {
                into.angle[k] = angle(slot);
                into.angularVelocity[k] = angularVelocity(slot);
                System.arraycopy(
                        wallRows,
                        ContactRows.ofWalls(slot),
                        into.wallRows,
                        ContactRows.ofWalls(k),
                        ContactRows.OF_WALLS);
            }
            if (sleeping) {
                into.rest[k] = rest(slot);
                into.drift[2 * k] = drift(slot, 0);
                into.drift[2 * k + 1] = drift(slot, 1);
                into.turned[k] = turned(slot);
            }
        }
    }

    private int countImpulses(SavedState into, int part) {
        int count = 0;
        int to = into.part(part + 1);
        for (int k = into.part(part); k < to; k++) {
            for (int c = firstCached[slotOf[into.id[k]]]; c >= 0; c = entries[at(c, CachedImpulse.AT_NEXT)]) {
                count += isFound(c) ? 1 : 0;
            }
        }
        return count;
    }

    private void saveImpulses(SavedState into, int part, int place) {
        int end = place;
        int to = into.part(part + 1);
        for (int k = into.part(part); k < to; k++) {
            int first = end;
            for (int c = firstCached[slotOf[into.id[k]]]; c >= 0; c = entries[at(c, CachedImpulse.AT_NEXT)]) {
                if (isFound(c)) {
                    into.setImpulse(
                            end++,
                            first,
                            into.id[k],
                            entries[at(c, CachedImpulse.AT_HIGHER_ID)],
                            Float.intBitsToFloat(entries[at(c, CachedImpulse.AT_IMPULSE)]),
                            cachedRows,
                            ContactRows.of(c));
                }
            }
        }
    }

    /** Writes saved circles and impulses to a device that has room for them; slots are in the order of the ids. */
    static void load(SavedState from, DeviceArrays arrays, Links links) {
        int n = from.circles;
        int[] slotOf = links.slotOf;
        int[] firstCached = links.firstCached;
        int[] entries = links.entries;
        Arrays.fill(slotOf, 0, arrays.idCapacity(), CachedImpulse.NONE);
        for (int slot = 0; slot < n; slot++) {
            slotOf[from.id[slot]] = slot;
        }
        Arrays.fill(firstCached, 0, n, CachedImpulse.NONE);
        for (int c = 0; c < from.impulses; c++) {
            int lo = slotOf[from.lo[c]];
            entries[at(c, CachedImpulse.AT_HIGHER_ID)] = from.hi[c];
            entries[at(c, CachedImpulse.AT_IMPULSE)] = Float.floatToRawIntBits(from.normalImpulse[c]);
            entries[at(c, CachedImpulse.AT_NEXT)] = firstCached[lo];
            firstCached[lo] = c;
        }
        arrays.get(DeviceArray.HOME_CIRCLE).write(FloatBuffer.wrap(from.circle, 0, FLOATS * n));
        arrays.get(DeviceArray.HOME_MOTION).write(FloatBuffer.wrap(from.motion, 0, FLOATS * n));
        float[] traits = arrays.features().sleeping() && from.sleeps ? traitsToSteps(from, links) : from.traits;
        arrays.get(DeviceArray.HOME_TRAITS).write(FloatBuffer.wrap(traits, 0, FLOATS * n));
        arrays.get(DeviceArray.HOME_ID).write(0, IntBuffer.wrap(from.id, 0, n));
        arrays.get(DeviceArray.HOME_FIRST_CACHED).write(0, IntBuffer.wrap(firstCached, 0, n));
        arrays.get(DeviceArray.SLOT_OF).write(0, IntBuffer.wrap(slotOf, 0, arrays.idCapacity()));
        arrays.get(DeviceArray.IMPULSE_CACHE)
                .write(0, IntBuffer.wrap(entries, 0, CachedImpulse.STRIDE * from.impulses));
        FieldsStruct.pack(from.fields, from.ids, links.fields);
        arrays.get(DeviceArray.FIELDS).write(0, IntBuffer.wrap(links.fields, 0, FieldsStruct.words(from.ids)));
        if (arrays.features().turning()) {
            loadTurning(from, arrays, links);
        }
        if (arrays.features().sleeping()) {
            loadSleep(from, arrays, links);
        }
        if (arrays.features().ownMotion()) {
            FieldsStruct.packMotion(from.fields, from.ids, links.motion);
            arrays.get(DeviceArray.OWN_MOTION)
                    .write(0, IntBuffer.wrap(links.motion, 0, FieldsStruct.STRIDE * from.ids));
        }
        if (arrays.features().terrain()) {
            links.pieces.load(from, arrays);
        }
    }

    private static void loadSleep(SavedState from, DeviceArrays arrays, Links links) {
        int ints = Readback.SLEEP_INTS * from.circles;
        if (!from.sleeps) {
            Arrays.fill(links.sleep, 0, ints, 0);
        }
        for (int slot = 0; from.sleeps && slot < from.circles; slot++) {
            int s = Readback.SLEEP_INTS * slot;
            links.sleep[s] = from.rest[slot];
            links.sleep[s + 1] = Float.floatToRawIntBits(from.drift[2 * slot]);
            links.sleep[s + 2] = Float.floatToRawIntBits(from.drift[2 * slot + 1]);
            links.sleep[s + 3] = from.turned[slot];
        }
        arrays.get(DeviceArray.HOME_SLEEP).write(0, IntBuffer.wrap(links.sleep, 0, ints));
    }

    /** To steps the mass of one that sleeps is infinite. */
    private static float[] traitsToSteps(SavedState from, Links links) {
        System.arraycopy(from.traits, 0, links.traits, 0, FLOATS * from.circles);
        for (int slot = 0; slot < from.circles; slot++) {
            if (Sleep.isAsleep(from.rest[slot])) {
                links.traits[CircleRow.of(slot) + CircleRow.INVERSE_MASS] = 0;
            }
        }
        return links.traits;
    }

    private static void loadTurning(SavedState from, DeviceArrays arrays, Links links) {
        int n = from.circles;
        int rows = ContactRows.of(from.impulses);
        for (int slot = 0; slot < n; slot++) {
            links.turn[TURN_INTS * slot] = from.turns ? from.angle[slot] : 0;
            links.turn[TURN_INTS * slot + 1] = from.turns ? Float.floatToRawIntBits(from.angularVelocity[slot]) : 0;
        }
        if (from.turns) {
            System.arraycopy(from.rows, 0, links.cachedRows, 0, rows);
        } else {
            Arrays.fill(links.cachedRows, 0, rows, 0f);
        }
        FieldsStruct.packTurning(from.fields, from.id, n, links.own);
        arrays.get(DeviceArray.HOME_TURN).write(0, IntBuffer.wrap(links.turn, 0, TURN_INTS * n));
        arrays.get(DeviceArray.HOME_OWN).write(0, IntBuffer.wrap(links.own, 0, FieldsStruct.STRIDE * n));
        arrays.get(DeviceArray.ROW_CACHE).write(FloatBuffer.wrap(links.cachedRows, 0, rows));
        float[] wallRows = from.turns ? from.wallRows : links.noRows;
        arrays.get(DeviceArray.HOME_WALL_ROWS).write(FloatBuffer.wrap(wallRows, 0, ContactRows.ofWalls(n)));
    }
}
