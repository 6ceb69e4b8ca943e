package io.github.circles2d.world.device;

import static io.github.circles2d.world.device.memory.TouchArrays.AT_APPROACH;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_ID;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_IMPULSE;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_NORMAL_X;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_NORMAL_Y;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_OTHER;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_POINT_X;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_POINT_Y;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_SAYS;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_THRESHOLD;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_VN;
import static io.github.circles2d.world.device.memory.TouchArrays.HOLDS;
import static io.github.circles2d.world.device.memory.TouchArrays.PARTED;
import static io.github.circles2d.world.device.memory.TouchArrays.RECORD;
import static io.github.circles2d.world.device.memory.TouchArrays.TOUCHING;

import io.github.circles2d.world.device.memory.TouchArrays;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.TouchRecords;

/** Hands over what a device has recorded of the pairs that touch after a step. */
final class TouchReader {
    private final TouchArrays arrays;
    private final ContactEvents events;
    private final TouchRecords records = new TouchRecords();
    private int[] words = new int[0];

    TouchReader(TouchArrays arrays, ContactEvents events) {
        this.arrays = arrays;
        this.events = events;
    }

    /** Whether the next step has to record all pairs in touch. */
    boolean wantsAll() {
        return events.wantsAll();
    }

    /** The speed that counts as a hit; negative: that of the pair. */
    float hitSpeed() {
        return events.hitSpeed();
    }

    /**
     * Ends a step.
     *
     * @param count its records, which are in no order
     * @param all whether they are of all pairs in touch
     */
    void endStep(int count, boolean all) {
        if (count > arrays.room()) {
            throw new IllegalStateException(count + " records of touches do not fit into " + arrays.room());
        }
        if (words.length < RECORD * count) {
            words = new int[RECORD * (count + (count >> 1))];
        }
        arrays.read(words, count);
        records.clear();
        for (int at = 0; at < RECORD * count; at += RECORD) {
            int id = words[at + AT_ID];
            int other = words[at + AT_OTHER];
            int says = words[at + AT_SAYS];
            if ((says & PARTED) != 0) {
                events.part(id, other);
                continue;
            }
            float approach = real(at + AT_APPROACH);
            float impulse = real(at + AT_IMPULSE);
            float threshold = real(at + AT_THRESHOLD);
            if (events.concerns(id, other, (says & TOUCHING) != 0, approach, impulse, threshold)) {
                records.add(
                        id,
                        other,
                        approach,
                        impulse,
                        real(at + AT_NORMAL_X),
                        real(at + AT_NORMAL_Y),
                        real(at + AT_POINT_X),
                        real(at + AT_POINT_Y),
                        real(at + AT_VN),
                        threshold);
            }
        }
        events.endStep(all, records);
        for (int at = 0; at < RECORD * count; at += RECORD) {
            if ((words[at + AT_SAYS] & HOLDS) != 0) {
                events.hold(words[at + AT_ID], words[at + AT_OTHER]);
            }
        }
        arrays.stepMade();
    }

    private float real(int at) {
        return Float.intBitsToFloat(words[at]);
    }
}
