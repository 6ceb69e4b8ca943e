package io.github.circles2d.bench.games;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class JointCostsTest {
    private static final int N = 480;

    @Test
    void linesHaveTheColumnsOfTheHeader() {
        for (String each : JointCosts.CASES) {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            JointCosts.compare(each, Backend.JVM, N, 0, 1, new PrintStream(bytes, true, StandardCharsets.UTF_8));
            requireColumns(bytes, each + ",machine," + N + ",", JointCosts.HEADER);
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        BlobSwarm.measure(Backend.JVM, 20, 10, 5, new PrintStream(bytes, true, StandardCharsets.UTF_8));
        requireColumns(bytes, "machine,20,480,1200,", BlobSwarm.HEADER);
    }

    private static void requireColumns(ByteArrayOutputStream bytes, String begin, String header) {
        String line = bytes.toString(StandardCharsets.UTF_8).replaceAll("\"[^\"]*\"", "machine");
        assertThat(line).startsWith(begin);
        assertThat(line.strip().split(",", -1)).hasSameSizeAs(header.split(","));
    }

    @Test
    void blobsStayRoundAndLooseCirclesMakeAFlatterPile() {
        try (World with = JointCosts.world("blobs", true, Backend.JVM, N);
                World other = JointCosts.world("blobs", false, Backend.JVM, N)) {
            assertThat(with.joints().size()).isEqualTo(N / JointCosts.RING * JointCosts.SPRINGS);
            assertThat(other.joints().size()).isZero();
            with.step(1 / 60f, 300);
            other.step(1 / 60f, 300);
            assertThat(meanHeight(with)).isGreaterThan(2 * meanHeight(other));
            assertThat(other.stats().contacts()).isGreaterThan(with.stats().contacts());
        }
    }

    @Test
    void aBridgeHangsAboveThePileThatItsLooseCirclesFallOnto() {
        try (World with = JointCosts.world("bridge", true, Backend.JVM, N);
                World other = JointCosts.world("bridge", false, Backend.JVM, N)) {
            assertThat(with.joints().size()).isEqualTo(101);
            assertThat(with.size()).isEqualTo(other.size());
            with.step(1 / 60f, 300);
            other.step(1 / 60f, 300);
            assertThat(meanHeight(with)).isGreaterThan(meanHeight(other) + 3);
        }
    }

    private static double meanHeight(World world) {
        float[] circles = new float[4 * world.size()];
        world.read(circles);
        double sum = 0;
        for (int k = 1; k < circles.length; k += 4) {
            sum += circles[k];
        }
        return sum / world.size();
    }

    @Test
    void wrongArgumentsAreNamed() {
        for (String wrong : new String[] {"GPU", "0", "99", "rope"}) {
            assertThatThrownBy(() -> JointCosts.run(List.of(wrong), System.out))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("'" + wrong + "'");
            assertThatThrownBy(() -> BlobSwarm.run(List.of(wrong), System.out))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("'" + wrong + "'");
        }
    }
}
