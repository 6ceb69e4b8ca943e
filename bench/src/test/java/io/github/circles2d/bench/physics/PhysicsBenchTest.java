package io.github.circles2d.bench.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.Backend;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PhysicsBenchTest {
    @TempDir
    Path folder;

    @Test
    void aRowIsPrintedAndKept() throws IOException {
        String out = run("17", "--quick", "--out", folder.toString());
        assertThat(out).contains("1:10000").contains("how far the heavy one sinks, r");
        assertThat(Files.readString(folder.resolve("rows.csv")))
                .contains("17,1:10000,\"how far the heavy one sinks, r\"");
    }

    @Test
    void rowsThatRunAgainReplaceTheirFiguresAndLeaveTheOthers() throws IOException {
        run("16", "17", "--quick", "--out", folder.toString());
        List<String> before = Files.readAllLines(folder.resolve("rows.csv"));
        run("16", "--quick", "--out", folder.toString());
        assertThat(Files.readAllLines(folder.resolve("rows.csv"))).isEqualTo(before);
    }

    /** Two circles of one size that meet head on at low speed: any engine gets this right. */
    @Test
    void theEnginesAgreeOnWhatIsEasy() {
        for (Physics physics : List.of(new WorldPhysics(Backend.JVM, 1), new Box2dPhysics())) {
            try (Arena arena = physics.open(Setup.around(20, 20).withRestitution(1))) {
                arena.add(-2, 0, 0.5, 1, 4, 0);
                arena.add(2, 0, 0.5, 3, 0, 0);
                arena.step(90);
                State state = arena.state();
                assertThat(state.vx[0]).as(physics.name()).isBetween(-2.05, -1.95);
                assertThat(state.vx[1]).as(physics.name()).isBetween(1.95, 2.05);
            }
        }
    }

    @Test
    void wrongArgumentsAreNamed() {
        assertThatThrownBy(() -> run("19"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("19");
        assertThatThrownBy(() -> run("--seeds", "none"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("none");
    }

    @Test
    void thePageIsThatOfTheKeptFiles() throws IOException {
        assertThat(Files.readString(Path.of("../docs/physics.md"), StandardCharsets.UTF_8))
                .isEqualTo(PhysicsPage.of(Path.of("results/physics")));
    }

    private static String run(String... arguments) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PhysicsBench.run(List.of(arguments), new PrintStream(out, true, StandardCharsets.UTF_8));
        return out.toString(StandardCharsets.UTF_8);
    }
}
