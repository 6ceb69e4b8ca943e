package io.github.circles2d.world.device.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HeadcountTest {
    /** What a step takes one work-group that has its processor. */
    private static final double ALONE = 40;

    private static final IntToDoubleFunction IDLE = groups -> ALONE / groups;

    /** A machine on which work-groups that wait for each other take a hundred times as long; one takes twice as long. */
    private static final IntToDoubleFunction BUSY = groups -> groups == 1 ? 2 * ALONE : 100 * ALONE;

    /** The number of work-groups that can be of use; a test may change it. */
    private int useful = 2;

    private Headcount headcount = new Headcount(2);

    /** Steps until some time has passed; returns the share of it in which there were so many work-groups. */
    private double shareOf(int counted, double time, IntToDoubleFunction stepTime, double waitingShare) {
        double all = 0;
        double with = 0;
        while (all < time) {
            int groups = Math.min(useful, headcount.most());
            double step = stepTime.applyAsDouble(groups);
            double waiting = groups == 1 ? 0 : waitingShare * step;
            headcount.learn(groups, useful, 1, Math.round(groups * step), Math.round(groups * waiting));
            all += step;
            with += groups == counted ? step : 0;
        }
        return with / all;
    }

    @Test
    void allMakeStepsIfNobodyWaits() {
        assertThat(shareOf(2, 1e6, IDLE, 0)).isOne();
    }

    @Test
    void shortWaitingNeverMatters() {
        assertThat(shareOf(2, 1e6, IDLE, 0.2)).isOne();
    }

    @Test
    void oneMakesStepsWhileTheOthersHaveNoProcessors() {
        shareOf(2, 2 * 100 * ALONE, BUSY, 0.45);
        assertThat(headcount.most()).isOne();
        assertThat(shareOf(1, 1e6, BUSY, 0.45)).isGreaterThan(0.95);
    }

    @Test
    void allComeBackSoonAfterABusyTime() {
        shareOf(1, 1e7, BUSY, 0.45);
        shareOf(1, 70 * 100 * ALONE, IDLE, 0);
        assertThat(headcount.most()).isEqualTo(2);
        assertThat(shareOf(2, 1e6, IDLE, 0)).isOne();
    }

    @Test
    void allMakeStepsIfFewerAreSlowerHoweverLongTheyWait() {
        assertThat(shareOf(2, 1e7, IDLE, 0.5)).isGreaterThan(0.95);
    }

    @ParameterizedTest
    @ValueSource(ints = {16, 12, 7})
    void asManyMakeStepsAsAreFastest(int greatest) {
        headcount = new Headcount(greatest);
        useful = greatest;
        int best = greatest / 2 / 2;
        IntToDoubleFunction stepTime = groups -> ALONE / groups * (groups > best ? 20 : 1);
        assertThat(shareOf(best, 1e7, stepTime, 0.45)).isGreaterThan(0.9);
        shareOf(best, 1e6, IDLE, 0);
        assertThat(headcount.most()).isEqualTo(greatest);
    }

    @Test
    void aWorldThatHasUseForTwoOfManyIsMadeByOneToo() {
        headcount = new Headcount(16);
        assertThat(shareOf(1, 1e7, BUSY, 0.45)).isGreaterThan(0.95);
        useful = 16;
        shareOf(16, 1e6, IDLE, 0);
        assertThat(headcount.most()).isEqualTo(16);
    }

    @Test
    void launchesThatMadeNoStepAreNoReasonToChange() {
        headcount.learn(2, 2, 0, 100 * Headcount.WINDOW, 90 * Headcount.WINDOW);
        assertThat(headcount.most()).isEqualTo(2);
    }
}
