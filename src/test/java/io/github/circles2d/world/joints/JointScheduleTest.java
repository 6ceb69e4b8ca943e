package io.github.circles2d.world.joints;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The order of joints keeps what steps and devices build on; so do springs and partners, while joints come and go. */
class JointScheduleTest {
    private static final int CIRCLES = 3000;

    private final JointTable table = new JointTable();
    private final JointSchedule schedule = new JointSchedule(table);
    private final JointStep step = new JointStep();
    private final SplittableRandom random = new SplittableRandom(11);

    private int add(int a, int b) {
        JointForm form;
        if (random.nextInt(3) == 0) {
            form = new JointForm(JointRow.AXIAL | JointRow.ELASTIC)
                    .set(JointSetting.SPRING, 1 + random.nextInt(40), random.nextInt(3));
        } else {
            form = new JointForm(JointRow.AXIAL | JointRow.RIGID);
        }
        if (random.nextInt(4) == 0) {
            form.set(JointSetting.COLLIDING, 1, 0);
        }
        table.ensure(1, CIRCLES);
        table.ensureSprings(1);
        return table.add(form, a, b);
    }

    private void make() {
        schedule.makeRoom(step, CIRCLES);

        table.springs.makeRoom(step);
        schedule.make(step, CIRCLES);
        schedule.makePartners(step);
        table.springs.fill(step, 1 / 240f);
        table.publish(step);
    }

    /** Pairs near each other, some hubs, and chains, of which some are longer than a batch. */
    private void fill(int joints, int reach) {
        for (int k = 0; k < joints; k++) {
            int a = random.nextInt(CIRCLES);
            int b = reach == 0 ? JointRow.NONE : (a + 1 + random.nextInt(reach)) % CIRCLES;
            int hub = random.nextInt(20) == 0 ? a % 5 : a;
            add(hub == b ? a : hub, b);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 50})
    void theOrderHasEachJointOnceByBatchAndColour(int reach) {
        for (int round = 0; round < 6; round++) {
            fill(900, reach);
            for (int joint = 0; joint < table.ids.end(); joint++) {
                if (table.ids.lives(joint) && random.nextInt(4) == 0) {
                    table.remove(joint);
                }
            }
            make();
            checkOrder();
            checkColours();
            checkSprings();
            checkPartners();
        }
        table.clear();
        make();
        assertThat(step.count).isZero();
        assertThat(step.batches).isZero();
        assertThat(step.partnered).isZero();
    }

    private void checkOrder() {
        assertThat(step.count).isEqualTo(table.ids.size());
        Set<Integer> seen = new HashSet<>();
        for (int k = 0; k < step.count; k++) {
            assertThat(table.ids.lives(step.order[k])).isTrue();
            assertThat(seen.add(step.order[k])).isTrue();
        }
        int[] batchOfCircle = new int[CIRCLES];
        Arrays.fill(batchOfCircle, -1);
        int place = 0;
        for (int batch = 0; batch <= step.batches; batch++) {
            int first = JointStep.BATCH_STRIDE * batch;
            assertThat(step.starts[first]).isEqualTo(place);
            for (int colour = 0; colour < JointStep.COLOURS; colour++) {
                for (; place < step.starts[first + colour + 1]; place++) {
                    int joint = step.order[place];
                    assertThat(table.colour(joint)).isEqualTo(colour);
                    assertThat(colour).isLessThan(step.colours);
                    boolean follows = place > step.starts[first + colour];
                    assertThat(!follows || step.order[place - 1] < joint).isTrue();
                    enter(batchOfCircle, table.a(joint), batch);
                    if (table.b(joint) != JointRow.NONE) {
                        enter(batchOfCircle, table.b(joint), batch);
                    }
                }
            }
            int joints = place - step.starts[first];
            assertThat(batch == step.batches || joints > 0 && joints <= JointStep.BATCH)
                    .isTrue();
        }
        assertThat(place).isEqualTo(step.splitStart);
        checkSplit();
    }

    private static void enter(int[] batchOfCircle, int circle, int batch) {
        assertThat(batchOfCircle[circle]).isIn(-1, batch);
        batchOfCircle[circle] = batch;
    }

    private void checkSplit() {
        for (int k = 1; k < step.splitCircles; k++) {
            assertThat(step.splitIds[k]).isGreaterThan(step.splitIds[k - 1]);
        }
        for (int k = step.splitStart; k < step.count; k++) {
            int joint = step.order[k];
            int at = 2 * (k - step.splitStart);
            assertThat(table.colour(joint)).isEqualTo(JointTable.SPLIT);
            assertThat(k == step.splitStart || step.order[k - 1] < joint).isTrue();
            assertThat(step.splitIds[step.splitEnds[at]]).isEqualTo(table.a(joint));
            if (table.b(joint) == JointRow.NONE) {
                assertThat(step.splitEnds[at + 1]).isEqualTo(-1);
            } else {
                assertThat(step.splitIds[step.splitEnds[at + 1]]).isEqualTo(table.b(joint));
            }
        }
    }

    /** No two joints of a circle have one colour, and lists of circles have their joints. */
    private void checkColours() {
        int[] colours = new int[CIRCLES];
        int[] count = new int[CIRCLES];
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (table.ids.lives(joint)) {
                for (int circle : new int[] {table.a(joint), table.b(joint)}) {
                    if (circle != JointRow.NONE) {
                        int bit = table.colour(joint) == JointTable.SPLIT ? 0 : 1 << table.colour(joint);
                        assertThat(colours[circle] & bit).isZero();
                        colours[circle] |= bit;
                        count[circle]++;
                    }
                }
            }
        }
        for (int circle = 0; circle < CIRCLES; circle++) {
            int listed = 0;
            for (int at = table.firstOfCircle(circle); at >= 0; at = table.nextOfCircle(at)) {
                int joint = JointTable.jointAt(at);
                assertThat(table.a(joint) == circle || table.b(joint) == circle).isTrue();
                listed++;
            }
            assertThat(listed).isEqualTo(count[circle]);
        }
    }

    /** Each spring has a row of its own, which is filled; there are not more than were ever there at a time. */
    private void checkSprings() {
        assertThat(step.springCount).isLessThanOrEqualTo(1 + 40 * 3);
        float[] expected = new float[JointSpring.STRIDE];
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (table.ids.lives(joint)) {
                int row = table.trait(joint, JointRow.SPRING);
                assertThat(row > 0).isEqualTo((table.form(joint) & JointRow.ELASTIC) != 0);
                if (row > 0) {
                    JointSpring.fill(expected, 0, table.frequency(joint), table.dampingRatio(joint), 1 / 240f);
                    int at = JointSpring.of(row);
                    assertThat(Arrays.copyOfRange(step.springs, at, at + JointSpring.STRIDE))
                            .isEqualTo(expected);
                }
            }
        }
    }

    private void checkPartners() {
        int expected = 0;
        for (int joint = 0; joint < table.ids.end(); joint++) {
            boolean parts = table.ids.lives(joint)
                    && table.b(joint) != JointRow.NONE
                    && (table.form(joint) & JointRow.COLLIDE) == 0;
            if (parts) {
                expected += 2;
                assertThat(has(table.a(joint), table.b(joint), joint)).isTrue();
                assertThat(has(table.b(joint), table.a(joint), joint)).isTrue();
            }
        }
        assertThat(step.partnerStart[step.partnered]).isEqualTo(expected);
        assertThat(step.parts).isEqualTo(expected > 0);
    }

    private boolean has(int circle, int partner, int joint) {
        int found = 0;
        for (int k = step.partnerStart[circle]; k < step.partnerStart[circle + 1]; k++) {
            assertThat(k == step.partnerStart[circle] || step.partners[2 * k - 1] < step.partners[2 * k + 1])
                    .isTrue();
            found += step.partners[2 * k] == partner && step.partners[2 * k + 1] == joint ? 1 : 0;
        }
        return found == 1;
    }

    @Test
    void aColourIsTheLeastThatIsFreeAtBothCirclesAndStays() {
        for (int k = 0; k < JointStep.HUB; k++) {
            assertThat(table.colour(add(0, 1 + k))).isEqualTo(k);
        }
        assertThat(table.colour(add(2, 5))).isZero();
        assertThat(table.colour(add(5, 3))).isEqualTo(1);
        table.remove(3);
        assertThat(table.colour(add(200, 0))).isEqualTo(3);
        assertThat(table.colour(1)).isEqualTo(1);
        for (int k = 0; k < JointStep.COLOURS; k++) {
            assertThat(table.colour(add(300, JointRow.NONE))).isEqualTo(k);
        }
        assertThat(table.colour(add(300, JointRow.NONE))).isEqualTo(JointTable.SPLIT);
        assertThat(table.colour(add(300, 301))).isEqualTo(JointTable.SPLIT);
    }

    @Test
    void allJointsOfAHubWithOthersAreSplitOnceAndForAll() {
        int pin = add(0, JointRow.NONE);
        for (int k = 0; k < JointStep.HUB; k++) {
            assertThat(table.colour(add(1 + k, 0))).isEqualTo(k + 1);
        }
        int last = add(0, 100);
        assertThat(table.colour(pin)).isZero();
        for (int joint = pin + 1; joint <= last; joint++) {
            assertThat(table.colour(joint)).isEqualTo(JointTable.SPLIT);
        }
        assertThat(table.colour(add(0, 101))).isEqualTo(JointTable.SPLIT);
        assertThat(table.colour(add(100, 3))).isZero();
        for (int joint = last - 2; joint <= last; joint++) {
            table.remove(joint);
        }
        assertThat(table.colour(1)).isEqualTo(JointTable.SPLIT);
        assertThat(table.colour(add(0, 102))).isEqualTo(1);
        assertThat(table.colour(add(0, 103))).isEqualTo(JointTable.SPLIT);
        make();
        checkOrder();
        checkColours();
    }

    @Test
    void whatDevicesCopyHasAnotherVersionAndARangeIfItChanges() {
        fill(100, 1);
        make();
        int version = step.version;
        int joint = 40;
        table.set(joint, JointSetting.BREAKING, 7, 7);
        table.publish(step);
        assertThat(step.version).isEqualTo(version + 1);
        assertThat(step.changedFrom).isEqualTo(40);
        assertThat(step.changedTo).isEqualTo(41);
        assertThat(step.breakable).isTrue();
        table.publish(step);
        assertThat(step.version).isEqualTo(version + 1);
        table.set(50, JointSetting.COLLIDING, 0, 0);
        table.remove(45);
        table.publish(step);
        assertThat(step.changedFrom).isEqualTo(45);
        assertThat(step.changedTo).isEqualTo(51);
    }

    @Test
    void aRangeIsOfTheJointsOfARestoredState() {
        for (int joints : new int[] {3, 1, 0}) {
            make();
            int version = step.version;
            fill(100, 1); // no step sees them
            table.load(new int[joints], joints);
            table.publish(step);
            assertThat(step.joints).isEqualTo(joints);
            assertThat(step.version).isEqualTo(version + (joints > 0 ? 1 : 0));
            if (joints > 0) {
                assertThat(step.changedFrom).isZero();
                assertThat(step.changedTo).isEqualTo(joints);
            }
        }
    }

    @Test
    void aJointWhoseLimitsComeOrGoBeginsAnew() {
        int joint = add(0, 1);
        table.remove(joint);
        table.add(new JointForm(JointRow.AXIAL).set(JointSetting.LIMITS, 1, 2), 0, 1);
        int serial = table.serial(joint);
        table.set(joint, JointSetting.LIMITS, 1.5f, 3);
        assertThat(table.serial(joint)).isEqualTo(serial);
        table.set(joint, JointSetting.LIMITS, 0, 3);
        assertThat(table.serial(joint)).isNotEqualTo(serial);
    }
}
