package io.github.circles2d.demo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class OptionsTest {

    @Test
    void withoutOptionsTheConstantsAreThoseOfTheThesis() throws UsageException {
        Options options = Options.parse();

        assertThat(options.circles()).isEqualTo(1250);
        assertThat(options.packed()).isFalse();
        assertThat(options.strategy()).isEqualTo(2);
        assertThat(options.restitution()).isEqualTo(0.5f);
        assertThat(options.gravityX()).isEqualTo(0f);
        assertThat(options.gravityY()).isEqualTo(-0.01f);
        assertThat(options.size()).isEqualTo(480);
        assertThat(options.frames()).isZero();
        assertThat(options.png()).isNull();
        assertThat(Options.TIME_STEP).isEqualTo(1 / 60f);
        assertThat(SimulationLoop.FRAME_NANOS).isEqualTo(17_000_000);
    }

    @Test
    void everyOptionIsRead(@TempDir Path folder) throws UsageException {
        Path file = folder.resolve("picture.png");

        Options options = Options.parse(
                "-n",
                "99",
                "--packed",
                "--strategy",
                "3",
                "--restitution=0.25",
                "--gravity",
                "-0.5,1e-3",
                "--device",
                "cpu",
                "--seed",
                "-7",
                "--frames",
                "12",
                "--png",
                file.toString(),
                "--size",
                "640",
                "--no-overlay",
                "--quiet");

        assertThat(options)
                .isEqualTo(
                        new Options(99, true, 3, 0.25f, -0.5f, 0.001f, "cpu", -7, 12, file, 640, false, true, false));
    }

    @Test
    void theLastOneCountsWhereAnOptionComesTwice() throws UsageException {
        assertThat(Options.parse("--circles", "5", "-n", "6").circles()).isEqualTo(6);
    }

    @Test
    void nothingAfterHelpIsLookedAt() throws UsageException {
        assertThat(Options.parse("--help", "--nonsense").help()).isTrue();
    }

    @Test
    void theUsageTextNamesEveryOptionThatTheTestsUse() {
        assertThat(OptionsParser.usage())
                .contains("-n, --circles", "--strategy", "--restitution", "--gravity", "--device", "--seed")
                .contains("--frames", "--png", "--size", "--no-overlay", "--quiet", "--help", "space pause");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "--circles; many; takes a whole number from 1 to 10000000, not 'many'",
                "--circles; 0; takes a whole number from 1 to 10000000, not '0'",
                "--circles; 99999999999; not '99999999999'",
                "--strategy; 4; takes a whole number from 0 to 3, not '4'",
                "--restitution; 1.01; takes a number from 0.0 to 1.0, not '1.01'",
                "--restitution; NaN; takes a number from 0.0 to 1.0, not 'NaN'",
                "--gravity; 1; takes two numbers with a comma between them",
                "--gravity; 1,2,3; takes two numbers with a comma between them",
                "--gravity; 0,Infinity; not 'Infinity'",
                "--gravity; 0,; not ''",
                "--seed; x; takes a whole number of at most 64 bits, not 'x'",
                "--frames; 0; takes a whole number from 1 to 2147483647, not '0'",
                "--size; 99; takes a whole number from 100 to 8192, not '99'",
                "--device; ' '; takes best, gpu, cpu",
                "--png; /no/such/folder/a.png; a folder that exists, which /no/such/folder does not",
            })
    void aBadValueIsRefusedWithTheOptionTheRuleAndTheValue(String option, String value, String message) {
        assertThatThrownBy(() -> Options.parse(option, value))
                .isInstanceOf(UsageException.class)
                .hasMessageStartingWith(option)
                .hasMessageContaining(message);
        assertThatThrownBy(() -> Options.parse(option + "=" + value)).isInstanceOf(UsageException.class);
    }

    @Test
    void aFolderIsNoPictureFile(@TempDir Path folder) {
        assertThatThrownBy(() -> Options.parse("--png", folder.toString()))
                .isInstanceOf(UsageException.class)
                .hasMessageContaining("the name of a file");
    }

    @ParameterizedTest
    @ValueSource(strings = {"--circles", "--png", "--gravity", "-n"})
    void anOptionWithoutItsValueIsRefused(String option) {
        assertThatThrownBy(() -> Options.parse(option))
                .isInstanceOf(UsageException.class)
                .hasMessageContaining("needs a value");
    }

    @Test
    void aFlagTakesNoValue() {
        assertThatThrownBy(() -> Options.parse("--quiet=yes")).hasMessage("--quiet takes no value");
    }

    @Test
    void anUnknownWordIsRefused() {
        assertThatThrownBy(() -> Options.parse("--speed", "1")).hasMessage("unknown option --speed");
        assertThatThrownBy(() -> Options.parse("1250")).hasMessage("unexpected argument 1250");
    }
}
