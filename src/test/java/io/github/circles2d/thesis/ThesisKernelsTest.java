package io.github.circles2d.thesis;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** The names that the thesis gives: other hosts may be written against them. */
class ThesisKernelsTest {
    private static String source() throws IOException {
        try (InputStream in =
                ThesisKernelsTest.class.getResourceAsStream("/io/github/circles2d/kernels/CirclePhysV2.cl")) {
            return new String(in.readAllBytes(), StandardCharsets.US_ASCII);
        }
    }

    @Test
    void circlePhysV2HasTheSevenKernelsWithTheirArgumentsInOrder() throws IOException {
        Matcher kernel = Pattern.compile("__kernel void (\\w+)\\(([^)]*)\\)").matcher(source());
        Map<String, String> kernels = new LinkedHashMap<>();
        while (kernel.find()) {
            kernels.put(kernel.group(1), arguments(kernel.group(2)));
        }
        assertThat(kernels)
                .containsOnly(
                        Map.entry(
                                "update_position",
                                "float4* circle, float2* velocities, float2* gravity, int circles, float time_step,"
                                        + " float restitution"),
                        Map.entry(
                                "detect_collisions",
                                "float4* circle, float2* collision, int potential_collisions, int circles"),
                        Map.entry(
                                "detect_collisions_precomputed_rows",
                                "float4* circle, float2* collision, int2* rows, int potential_collisions, int circles"),
                        Map.entry(
                                "detect_collisions_precomputed_pairs",
                                "float4* circle, float2* collision, int2* indexes, int potential_collisions"),
                        Map.entry(
                                "resolve_collisions",
                                "float4* circle, float2* collision, float2* velocities, int potential_collisions,"
                                        + " int circles, float restitution"),
                        Map.entry(
                                "resolve_collisions_with_rows",
                                "float4* circle, float2* collision, float2* velocities, int2* rows,"
                                        + " int potential_collisions, int circles, float restitution"),
                        Map.entry(
                                "resolve_collisions_with_pairs",
                                "float4* circle, float2* collision, float2* velocities, int2* indexes,"
                                        + " int potential_collisions, float restitution"));
    }

    private static String arguments(String list) {
        return Arrays.stream(list.split(","))
                .map(argument -> argument.replaceAll("__global|const", "")
                        .replaceAll("\\s*\\*\\s*", "* ")
                        .trim()
                        .replaceAll("\\s+", " "))
                .collect(Collectors.joining(", "));
    }

    @Test
    void everyStrategyOfTheThesisHasItsMappingFunction() throws IOException {
        assertThat(source()).contains("collision_map_s1(", "collision_map_s2(", "collision_map_s3(");
    }
}
