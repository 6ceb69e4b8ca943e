package io.github.circles2d.project;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The page that compares this library with others has the figures of the files that it names. */
class ComparisonTest {
    /** What a row begins with; the file, the engine and the threads of its figures; how many sizes have one. */
    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "| circles2d, NVIDIA H200 | - |; intel-xeon-processor-16-nvidia-h200/series.csv; world@nvidia-h200; -; 4",
                "| circles2d, JVM | 2 |; amd-epyc-2/series.csv; world-jvm; 2; 3",
                "| circles2d, JVM | 1 |; amd-epyc-2/series.csv; world-jvm; 1; 3",
                "| Box2D v3 | 2 |; amd-epyc-2/series.csv; box2d-v3; 2; 3",
                "| Box2D v3 | 1 |; amd-epyc-2/series.csv; box2d-v3; 1; 2",
                "| gdx-box2d | 1 |; amd-epyc-2/series.csv; gdx-box2d; 1; 2",
                "| dyn4j | 1 |; amd-epyc-2/series.csv; dyn4j; 1; 2"
            })
    void packedCirclesTakeWhatTheFileSays(String row, String file, String engine, String threads, int measured)
            throws IOException {
        String[] shown = cells(rest(page(), row));
        String[] sizes = {"1250", "10000", "100000", "1000000"};
        for (int k = 0; k < sizes.length; k++) {
            if (k >= measured) {
                assertThat(shown[k]).isEqualTo("not measured");
                continue;
            }
            String key = engine + ",packed-similar," + sizes[k] + "," + threads + ",";
            String[] figures = rest(results(file), key).split(",");
            assertRounded(shown[k], figures[3]); // after skipped steps, steps and runs
            if (k == 1) {
                assertRounded(shown[4], figures[6]);
            }
        }
    }

    @Test
    void theHashIsThatOfEachFileThatItNames() throws IOException {
        Matcher hash = Pattern.compile("the hash of the state is (\\w+)").matcher(page());
        assertThat(hash.find()).isTrue();
        for (String key : List.of(
                "amd-epyc-2/series.csv world-jvm,packed-similar,1250,1,",
                "amd-epyc-2/series.csv world-jvm,packed-similar,1250,2,",
                "intel-xeon-processor-16/series.csv world-jvm,packed-similar,1250,16,",
                "intel-xeon-processor-16-nvidia-h200/series.csv world@nvidia-h200,packed-similar,1250,-,",
                "amd-epyc-2/web.csv world,Node,1250,",
                "amd-epyc-2/web.csv world,Chromium,1250,")) {
            String[] parts = key.split(" ");
            assertThat(rest(results(parts[0]), parts[1])).as(key).contains("," + hash.group(1) + ",");
        }
    }

    /** What follows this beginning of a line. */
    private static String rest(String text, String beginning) {
        Matcher line =
                Pattern.compile("(?m)^" + Pattern.quote(beginning) + "(.*)$").matcher(text);
        assertThat(line.find()).as(beginning).isTrue();
        return line.group(1);
    }

    private static String[] cells(String row) {
        return row.replaceAll("^ *\\|? *| *\\| *$", "").split(" *\\| *");
    }

    /** To as many digits as are shown. */
    private static void assertRounded(String shown, String figure) {
        BigDecimal value = new BigDecimal(shown.replace(",", ""));
        BigDecimal difference = value.subtract(new BigDecimal(figure)).abs();
        assertThat(difference)
                .as("%s for %s", shown, figure)
                .isLessThanOrEqualTo(value.ulp().multiply(new BigDecimal("0.5001")));
    }

    private static String page() throws IOException {
        return Files.readString(Path.of("docs/why.md"));
    }

    private static String results(String file) throws IOException {
        return Files.readString(Path.of("bench/results", file));
    }
}
