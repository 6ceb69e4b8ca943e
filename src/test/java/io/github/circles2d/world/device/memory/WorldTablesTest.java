package io.github.circles2d.world.device.memory;

import static io.github.circles2d.Refusals.assertIllegalState;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.KernelBuildException;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.circles.CircleField;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** The tables of the host, and what compilers of devices make of them. */
class WorldTablesTest {

    @OnEachDevice
    void theDeviceTakesTheSizesOfStructsAndElementsForWhatTheHostDoes(Device device) {
        List<String> probed = new ArrayList<>(List.of("StepConstants", "Levels", "WallMotion"));
        List<Integer> onHost = new ArrayList<>(List.of(
                4 * StepParameters.CONSTANTS.words(),
                4 * StepParameters.LEVELS.words(),
                4 * StepParameters.WALLS.words()));
        for (DeviceArray array : DeviceArray.values()) {
            if (array.index() != DeviceArray.Index.STRUCT) {
                probed.add("*w." + array.kernelName());
                onHost.add(array.elementBytes());
            }
        }
        assertThat(sizes(device, probed)).isEqualTo(onHost);
    }

    @Test
    void elementsOfNewCirclesBeginWithTheInitialValueOfEachField() {
        for (CircleField field : CircleField.OF_STEPS) {
            if (field.isOfTurning()) {
                assertThat(FieldsStruct.initialTurning()[FieldsStruct.turningPlace(field)])
                        .as(field.label())
                        .isEqualTo((int) field.initial());
            } else if (field.isOfMotion()) {
                assertThat(FieldsStruct.initialMotion()[FieldsStruct.motionPlace(field)])
                        .as(field.label())
                        .isEqualTo((int) field.initial());
            }
        }
    }

    private static List<Integer> sizes(Device device, List<String> probed) {
        StringBuilder probe = new StringBuilder("kernel void probe(global int *out) {\n    World w;\n");
        for (int i = 0; i < probed.size(); i++) {
            probe.append("    out[" + i + "] = (int) sizeof(" + probed.get(i) + ");\n");
        }
        KernelSource source = WorldSource.tables()
                .define("TURNING", 1)
                .define("TERRAIN", 1)
                .define("SLEEPING", 1)
                .define("OWN_MOTION", 1)
                .define("JOINTS", 1)
                .and(KernelSource.ofText("probe", probe + "}\n"));
        int[] sizes = new int[probed.size()];
        try (Session session = Session.open(device);
                DeviceBuffer out = session.allocate("sizes", 4L * sizes.length)) {
            session.build(source, StageKernels.options(device))
                    .kernel("probe")
                    .arg(0, out)
                    .run(1);
            out.read(IntBuffer.wrap(sizes));
        }
        return Arrays.stream(sizes).boxed().toList();
    }

    @OnEachDevice
    void compilersNameTheFileAndLineOfAnErrorBehindTheTables(Device device) {
        assumeFalse(device.platform().contains("NVIDIA"), "NVIDIA's compiler counts lines from the start of the text");
        KernelSource source = WorldSource.tables().and(KernelSource.ofText("wrong.cl", "\nint wrong = nothing;\n"));
        try (Session session = Session.open(device)) {
            assertThatThrownBy(() -> session.build(source))
                    .isInstanceOf(KernelBuildException.class)
                    .hasMessageContaining("wrong.cl:2");
        }
    }

    @Test
    void everyStatusWordHasAPlaceOfItsOwn() {
        Set<Integer> places = new HashSet<>();
        for (StatusWord word : StatusWord.values()) {
            assertThat(word.index()).as(word.name()).isBetween(0, StatusWord.WORDS - 1);
            assertThat(places.add(word.index())).as(word.name()).isTrue();
        }
    }

    @Test
    void fieldsOfAnElementShareComponentsOnlyIfTheTableSaysSo() {
        for (DeviceArray array : DeviceArray.values()) {
            StringBuilder taken = new StringBuilder();
            for (ElementField field : ElementField.values()) {
                // A field of two components has rows of one for each beside it, or none.
                boolean isOwn = field.array() == array && field.aliasOf() == null;
                if (isOwn && field.components().length() == 1) {
                    assertThat(taken).as(field.name()).doesNotContain(field.components());
                    taken.append(field.components());
                }
            }
        }
    }

    @Test
    void anArrayInTheMemoryOfAnotherHasElementsThatFitThere() {
        for (SharedArray array : SharedArray.values()) {
            assertThat(array.elementBytes())
                    .as(array.name())
                    .isLessThanOrEqualTo(array.aliasOf().elementBytes());
        }
    }

    @Test
    void aFieldLiesWithinTheElementsOfItsArray() {
        for (ElementField field : ElementField.values()) {
            int end =
                    4 * ("xyzw".indexOf(field.components()) + field.components().length());
            assertThat(field.array().elementBytes()).as(field.name()).isGreaterThanOrEqualTo(end);
            if (field.aliasOf() != null) {
                assertThat(field.components())
                        .as(field.name())
                        .isEqualTo(field.aliasOf().components());
            }
        }
    }

    @Test
    void aStructPacksItsRowsInOrderAndLeavesAloneWhatIsSetApart() {
        HostStruct<float[]> struct = new HostStruct<float[]>("Some")
                .field("float", "first", (from, to) -> to.put(from[0]), "one")
                .apart("between", "another")
                .field("float", "last[2]", 2, (from, to) -> to.put(from[1]).put(from[2]), "two");
        int[] words = {0, 7, 0, 0};
        struct.pack(new float[] {1f, 2f, -0f}, words);
        assertThat(words)
                .containsExactly(
                        Float.floatToRawIntBits(1f), 7, Float.floatToRawIntBits(2f), Float.floatToRawIntBits(-0f));
        assertThat(struct.at("between")).isEqualTo(1);
        assertThat(struct.text())
                .isEqualTo("typedef struct {\n    float first; // one\n    int between; // another\n"
                        + "    float last[2]; // two\n} Some;\n");
    }

    @Test
    void aRowOfAnotherLengthThanItSaysIsRefused() {
        HostStruct<float[]> struct =
                new HostStruct<float[]>("Some").field("float", "both[2]", 2, (from, to) -> to.put(from[0]), "two");
        assertIllegalState("Some.both[2]", () -> struct.pack(new float[] {1f}, new int[2]));
    }
}
