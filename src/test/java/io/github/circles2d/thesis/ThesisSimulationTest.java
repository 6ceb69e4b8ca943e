package io.github.circles2d.thesis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import org.junit.jupiter.api.Tag;

@Tag("each-jdk")
class ThesisSimulationTest {
    private static final Parameters PARAMETERS = Parameters.of(1 / 60f, 0.5f, new float[] {0, -0.01f});

    @OnEachDevice
    void itHoldsWhatItsMemoryNeedSaysAndGivesAllOfItBack(Device device) {
        CircleList circles = TestScene.crowd(70, 0.05f, 1).circles();
        for (PairStrategy strategy : ThesisStages.strategies()) {
            try (Session session = Session.open(device)) {
                Program program = session.build(ThesisSimulation.source(strategy, 70, device));
                ThesisSimulation simulation = ThesisSimulation.start(session, program, strategy, circles, PARAMETERS);
                simulation.step();
                assertThat(session.allocatedBytes()).isEqualTo(simulation.deviceBytes());
                MemoryNeed.of(strategy, 70).requireRoom(device, simulation.deviceBytes());
                assertThatThrownBy(() -> MemoryNeed.of(strategy, 70).requireRoom(device, simulation.deviceBytes() - 1))
                        .isInstanceOf(OpenClException.class);
                simulation.close();
                simulation.close();
                assertThat(session.allocatedBytes()).isZero();
            }
        }
    }

    @OnEachDevice
    void aStartThatFailsHalfWayReleasesWhatItMade(Device device) {
        CircleList circles = TestScene.crowd(70, 0.05f, 1).circles();
        for (Failing.Stage stage : Failing.Stage.values()) {
            try (Session session = Session.open(device)) {
                Failing strategy = new Failing(stage);
                Program program = session.build(ThesisSimulation.source(strategy, 70, device));
                assertThatThrownBy(() -> ThesisSimulation.start(session, program, strategy, circles, PARAMETERS))
                        .isInstanceOf(OpenClException.class)
                        .hasMessage(stage.name());
                assertThat(session.allocatedBytes()).isZero();
            }
        }
    }

    /** A row search that fails at a chosen stage, as a driver may. */
    private static final class Failing extends PairStrategy {
        enum Stage {
            OPEN,
            DETECT,
            RESOLVE,
            COUNT
        }

        private final RowSearchPairs rows = new RowSearchPairs();
        private final Stage stage;

        Failing(Stage stage) {
            super("none", "none");
            this.stage = stage;
        }

        private void failAt(Stage now) {
            if (now == stage) {
                throw new OpenClException(stage.name());
            }
        }

        @Override
        public KernelSource source(int circles) {
            return rows.source(circles);
        }

        @Override
        void open(Session session, int circles) {
            rows.open(session, circles);
            failAt(Stage.OPEN);
        }

        @Override
        Kernel detect(Program program, State state) {
            failAt(Stage.DETECT);
            return rows.detect(program, state);
        }

        @Override
        Kernel resolve(Program program, State state, float restitution) {
            failAt(Stage.RESOLVE);
            return rows.resolve(program, state, restitution);
        }

        @Override
        long countWrongSlots(Session session, Program program, State state) {
            failAt(Stage.COUNT);
            return 0;
        }

        @Override
        public void close() {
            rows.close();
        }
    }
}
