package io.github.circles2d.bench.results;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.results.format.ResultFormatFactory;
import org.openjdk.jmh.results.format.ResultFormatType;

/** JMH's own JSON of all runs of a folder. A run of the same benchmark with the same parameters replaces the last one. */
final class JmhJson {
    private static final Pattern BENCHMARK = Pattern.compile("\"benchmark\"\\s*:\\s*\"([^\"]*)\"");
    private static final Pattern JVM = Pattern.compile("(?<=\"jvm\" : \")[^\"]*[/\\\\]([^\"/\\\\]+)(?=\")");
    private static final Pattern PARAMETERS = Pattern.compile("\"params\"\\s*:\\s*\\{([^}]*)\\}");

    private final Map<String, String> runs = new LinkedHashMap<>();

    static JmhJson read(Path file) throws IOException {
        JmhJson json = new JmhJson();
        if (Files.exists(file)) {
            Files.readAllLines(file).stream()
                    .filter(line -> line.startsWith("{"))
                    .forEach(line -> json.put(line.replaceFirst(",$", "")));
        }
        return json;
    }

    void put(RunResult result) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(bytes, true, StandardCharsets.UTF_8);
        ResultFormatFactory.getInstance(ResultFormatType.JSON, out).writeOut(List.of(result));
        // One line a run: JMH's texts hold no line breaks.
        String array = bytes.toString(StandardCharsets.UTF_8).replaceAll("\\s*\n\\s*", " ");
        put(array.substring(array.indexOf('{'), array.lastIndexOf('}') + 1));
    }

    void save(Path file) throws IOException {
        Table.replace(file, "[\n" + String.join(",\n", runs.values()) + "\n]\n");
    }

    private void put(String run) {
        // Where Java is installed is nobody's business.
        String line = JVM.matcher(run).replaceFirst("$1");
        runs.put(first(BENCHMARK, line) + " " + first(PARAMETERS, line), line);
    }

    private static String first(Pattern pattern, String text) {
        Matcher matcher = pattern.matcher(text);
        return matcher.find() ? matcher.group(1) : "";
    }
}
