package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.ForkedJvm;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Steps beside busy threads, in a JVM that has all processors. */
@Timeout(120)
@Tag("each-jdk")
class BusyMachineTest {
    private static final double FACTOR = 1.5;

    private static String run(String what) {
        ForkedJvm.Result result = new ForkedJvm().run(BusySteps.class, what);
        assertThat(result.exitStatus()).as(result.output()).isZero();
        return result.output();
    }

    @Test
    void stepsBesideBusyThreadsHaveTheSameBits() {
        assertThat(run("bits")).contains("same bits: true");
    }

    /** This compares medians. Threads that wait in a wrong way make steps twenty times as long as one thread does. */
    @Test
    @Tag("exhaustive")
    void stepsBesideBusyThreadsAreHardlyLongerThanWithOneThread() {
        String output = run("times");
        assertThat(output).contains("factor ");
        double factor =
                Double.parseDouble(output.replaceAll("(?s).*factor ", "").strip());
        assertThat(factor).as("times of steps over those with one thread").isLessThan(FACTOR);
    }
}
