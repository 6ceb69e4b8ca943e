package io.github.circles2d.project;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Formulas stand once in Java and once in OpenCL C, in files of one name: the same functions, of as many numbers, in the same order. */
class TwinsTest {
    private static final Path MODEL = Path.of("src/main/java/io/github/circles2d/world/model");
    private static final Path SHARED = Path.of("kernels/world/shared");

    /** Files of kernels that are no formulas of numbers: visits and passes, whose twins are in {@code world.jvm}, and what devices alone need. */
    private static final Set<String> NO_FORMULAS = Set.of(
            "Contact",
            "DeviceBarrier",
            "Drive",
            "JointVisit",
            "Motion",
            "OneBodyRows",
            "PairRows",
            "Piece",
            "PieceTouch",
            "PieceVisit",
            "Turning",
            "Visit",
            "Wall");

    /** Files of one name whose functions take structs in one language, and numbers or rows in the other. */
    private static final Set<String> OTHER_ARGUMENTS = Set.of("OneBody", "Surface");

    /** Kernels have built-ins of these names, which compute in another way; so their own have an f behind it. */
    private static final Set<String> BUILT_IN = Set.of("min", "max", "clamp", "length", "dot");

    /** What Java has by itself, or has no need of. */
    private static final Set<String> IN_KERNELS_ALONE =
            Set.of("addFixed", "boundedShare", "partingNormal", "ringFirst", "turnSince", "wholeLog2");

    /** What kernels compute for a vector at once. */
    private static final Set<String> IN_JAVA_ALONE = Set.of("difference", "greatest");

    /** Numbers of a type of parameter; 1 of others. An array and a place in it are a pointer in kernels. */
    private static final Map<String, Integer> NUMBERS = Map.of("float2", 2, "float4", 4, "Softness", 3, "float[]", 0);

    private static final Pattern COMMENT = Pattern.compile("/\\*.*?\\*/|//[^\\n]*", Pattern.DOTALL);
    private static final Pattern IN_JAVA =
            Pattern.compile("^ {4}(?:public |private )?static \\w+ (\\w+)\\(([^)]*)\\) \\{", Pattern.MULTILINE);
    private static final Pattern IN_KERNELS =
            Pattern.compile("^(?:INLINE )?\\w+ (\\w+)\\(([^)]*)\\) \\{", Pattern.MULTILINE);

    @Test
    void formulasAreTheSameFunctionsInTheSameOrder() throws IOException {
        Set<String> twins = new TreeSet<>(names(SHARED, ".cl"));
        twins.removeAll(NO_FORMULAS);
        twins.removeAll(OTHER_ARGUMENTS);
        assertThat(names(MODEL, ".java")).containsAll(twins).containsAll(OTHER_ARGUMENTS);
        for (String name : twins) {
            List<String> inJava = functions(MODEL.resolve(name + ".java"), IN_JAVA);
            assertThat(functions(SHARED.resolve(name + ".cl"), IN_KERNELS))
                    .as(name)
                    .isNotEmpty()
                    .isEqualTo(inJava);
        }
    }

    private static Set<String> names(Path folder, String suffix) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(suffix))
                    .map(name -> name.substring(0, name.length() - suffix.length()))
                    .collect(Collectors.toSet());
        }
    }

    /** Names, and how many numbers the functions take, which a kernel may take as vectors. */
    private static List<String> functions(Path file, Pattern pattern) throws IOException {
        String code =
                COMMENT.matcher(Files.readString(file, StandardCharsets.UTF_8)).replaceAll("");
        List<String> functions = new ArrayList<>();
        for (Matcher found = pattern.matcher(code); found.find(); ) {
            String name = found.group(1);
            boolean isBuiltIn = name.endsWith("f") && BUILT_IN.contains(name.substring(0, name.length() - 1));
            if (!IN_KERNELS_ALONE.contains(name) && !IN_JAVA_ALONE.contains(name)) {
                functions.add(
                        (isBuiltIn ? name.substring(0, name.length() - 1) : name) + " of " + numbers(found.group(2)));
            }
        }
        return functions;
    }

    private static int numbers(String parameters) {
        return Arrays.stream(parameters.trim().split("\\s*,\\s*"))
                .mapToInt(parameter -> NUMBERS.getOrDefault(parameter.split("\\s+")[0], 1))
                .sum();
    }
}
