package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.ForkedJvm;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Steps on a machine with as many other busy threads as processors, in a JVM that has all of these. */
@Timeout(120)
@Tag("each-jdk")
class BusyMachineTest {
    private static final double FACTOR = 20;

    private static String run(String what) {
        ForkedJvm.Result result = new ForkedJvm().run(BusySteps.class, what);
        assertThat(result.exitStatus()).as(result.output()).isZero();
        return result.output();
    }

    @Test
    void stepsBesideBusyThreadsHaveTheSameBits() {
        assertThat(run("bits")).contains("same bits: true");
    }

    /**
     * This measures time, so it asks only that steps are not tens of times as long: threads that wait in a wrong way make them a
     * hundred times as long.
     */
    @Test
    @Tag("exhaustive")
    void stepsBesideBusyThreadsTakeFewTimesAsLong() {
        String output = run("times");
        assertThat(output).contains("factor ");
        double factor =
                Double.parseDouble(output.replaceAll("(?s).*factor ", "").strip());
        assertThat(factor).as("times of steps over those on an idle machine").isLessThan(FACTOR);
    }
}
