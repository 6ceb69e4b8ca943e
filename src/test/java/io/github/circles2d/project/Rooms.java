package io.github.circles2d.project;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The rules of the architecture, read off the sources: which room may know which. */
final class Rooms {
    private static final String BASE = "io.github.circles2d";

    /** Each room and the rooms that it may use; "api" is the root package. A room is a package and those below that are no rooms. */
    static final Map<String, Set<String>> MAY_USE = Map.ofEntries(
            entry(
                    "api",
                    "thesis",
                    "world",
                    "world.circles",
                    "world.events",
                    "world.model",
                    "world.queries",
                    "world.changes",
                    "world.reads",
                    "world.replay",
                    "world.reports",
                    "world.saves",
                    "world.search",
                    "world.shared",
                    "world.terrain",
                    "world.joints",
                    "world.bodies",
                    "world.jvm",
                    "world.device",
                    "opencl",
                    "calibration",
                    "world.snapshots"),
            entry("calibration"),
            entry("thesis", "opencl"),
            entry(
                    "world",
                    "world.changes",
                    "world.reads",
                    "world.reports",
                    "world.saves",
                    "world.search",
                    "world.shared",
                    "world.terrain",
                    "world.joints",
                    "world.circles",
                    "world.events",
                    "world.model"),
            entry(
                    "world.replay",
                    "world",
                    "world.changes",
                    "world.reads",
                    "world.shared",
                    "world.terrain",
                    "world.joints",
                    "world.circles",
                    "world.log"),
            entry(
                    "world.saves",
                    "world.changes",
                    "world.shared",
                    "world.circles",
                    "world.log",
                    "world.model",
                    "world.snapshots"),
            entry(
                    "world.reads",
                    "world.changes",
                    "world.shared",
                    "world.bodies",
                    "world.joints",
                    "world.circles",
                    "world.model",
                    "world.snapshots",
                    "world.terrain"),
            entry("world.reports", "world.shared", "world.circles", "world.events", "world.model"),
            entry(
                    "world.changes",
                    "world.search",
                    "world.queries",
                    "world.shared",
                    "world.terrain",
                    "world.bodies",
                    "world.joints",
                    "world.circles",
                    "world.events",
                    "world.model",
                    "world.snapshots"),
            entry(
                    "world.search",
                    "world.shared",
                    "world.terrain",
                    "world.bodies",
                    "world.circles",
                    "world.model",
                    "world.queries"),
            entry(
                    "world.shared",
                    "world.terrain",
                    "world.bodies",
                    "world.joints",
                    "world.circles",
                    "world.events",
                    "world.log",
                    "world.model",
                    "world.queries",
                    "world.snapshots"),
            entry("world.bodies", "world.terrain", "world.circles", "world.model"),
            entry(
                    "world.snapshots",
                    "world.bodies",
                    "world.joints",
                    "world.terrain",
                    "world.events",
                    "world.circles",
                    "world.model"),
            entry("world.joints", "world.bodies", "world.terrain", "world.circles", "world.model"),
            entry("world.terrain", "world.circles", "world.model"),
            entry("world.circles", "world.model"),
            entry("world.events", "world.terrain", "world.circles", "world.model"),
            entry(
                    "world.device",
                    "world.shared",
                    "world.circles",
                    "world.events",
                    "world.jvm",
                    "world.model",
                    "world.device.plan",
                    "world.device.queries",
                    "world.device.memory",
                    "world.queries",
                    "opencl",
                    "world.snapshots",
                    "world.terrain",
                    "world.bodies",
                    "world.joints"),
            entry("world.device.queries", "world.device.memory", "world.queries", "opencl"),
            entry("world.device.plan", "world.device.memory", "world.jvm", "world.model", "opencl"),
            entry("world.device.memory", "world.events", "world.circles", "world.model", "opencl"),
            entry(
                    "world.jvm",
                    "world.jvm.solver",
                    "world.jvm.bodies",
                    "world.jvm.joints",
                    "world.jvm.pieces",
                    "world.jvm.grid",
                    "world.jvm.state",
                    "world.jvm.threads",
                    "world.shared",
                    "world.circles",
                    "world.events",
                    "world.model",
                    "world.snapshots",
                    "world.terrain",
                    "world.bodies",
                    "world.joints"),
            entry(
                    "world.jvm.solver",
                    "world.jvm.bodies",
                    "world.jvm.joints",
                    "world.jvm.pieces",
                    "world.jvm.grid",
                    "world.jvm.state",
                    "world.jvm.threads",
                    "world.events",
                    "world.model",
                    "world.snapshots"),
            entry(
                    "world.jvm.bodies",
                    "world.jvm.joints",
                    "world.jvm.pieces",
                    "world.jvm.state",
                    "world.jvm.threads",
                    "world.bodies",
                    "world.terrain",
                    "world.circles",
                    "world.model"),
            entry("world.jvm.joints", "world.jvm.state", "world.jvm.threads", "world.model"),
            entry(
                    "world.jvm.pieces",
                    "world.jvm.state",
                    "world.jvm.threads",
                    "world.events",
                    "world.circles",
                    "world.model"),
            entry("world.jvm.grid", "world.jvm.state", "world.jvm.threads", "world.circles", "world.model"),
            entry(
                    "world.jvm.state",
                    "world.jvm.threads",
                    "world.snapshots",
                    "world.bodies",
                    "world.joints",
                    "world.terrain",
                    "world.events",
                    "world.circles",
                    "world.model"),
            entry("world.jvm.threads"),
            entry("world.log"),
            entry("world.model"),
            entry("world.queries", "world.bodies", "world.terrain", "world.model"),
            entry("opencl"),
            entry("scenes"),
            entry("demo", "api", "scenes", "opencl"),
            entry("playground", "api", "scenes", "opencl"),
            entry("tools", "api", "opencl"),
            entry("bench", "api", "scenes", "opencl"));

    /** Packages that are for some rooms alone. The benchmarks draw charts. */
    private static final Map<String, Set<String>> RESERVED = Map.of(
            "com.nativelibs4java", Set.of("opencl"),
            "org.bridj", Set.of("opencl"),
            "java.awt", Set.of("demo", "playground", "bench"),
            "javax.swing", Set.of("demo", "playground"),
            "javax.imageio", Set.of("demo", "playground"));

    private static final Pattern COMMENT = Pattern.compile("/\\*.*?\\*/|//[^\\n]*", Pattern.DOTALL);
    private static final Pattern PACKAGE = Pattern.compile("^\\s*package\\s+([\\w.]+)\\s*;", Pattern.MULTILINE);
    private static final Pattern OWN_NAME =
            Pattern.compile("\\bio\\.github\\.circles2d((?:\\.[a-z]\\w*)*)\\.(?=[A-Z*])");

    private Rooms() {}

    private static Map.Entry<String, Set<String>> entry(String room, String... mayUse) {
        return Map.entry(room, Set.of(mayUse));
    }

    /** Returns the rooms that can be reached from a room along the arrows. */
    static Set<String> below(String room) {
        Set<String> below = new TreeSet<>();
        for (String used : MAY_USE.get(room)) {
            below.add(used);
            below.addAll(below(used));
        }
        return below;
    }

    /** Returns what breaks a rule in the Java sources below a folder, one line each. */
    static List<String> violations(Path sources) throws IOException {
        List<String> violations = new ArrayList<>();
        for (Path file : filesBelow(sources, ".java")) {
            String code = COMMENT.matcher(Files.readString(file, StandardCharsets.UTF_8))
                    .replaceAll(" ");
            String room = roomOf(file, code);
            String body = PACKAGE.matcher(code).replaceFirst("");
            if (!MAY_USE.containsKey(room)) {
                violations.add(file + " lies in the unknown room " + room);
                continue;
            }
            for (String used : roomsUsed(body)) {
                if (!used.equals(room) && !MAY_USE.get(room).contains(used)) {
                    violations.add(file + ": " + room + " must not use " + used);
                }
            }
            RESERVED.forEach((name, owners) -> {
                if (!owners.contains(room)
                        && Pattern.compile("\\b" + Pattern.quote(name) + "\\.")
                                .matcher(body)
                                .find()) {
                    violations.add(
                            file + ": " + name + " is for " + String.join(" and ", new TreeSet<>(owners)) + " alone");
                }
            });
        }
        return violations;
    }

    static List<Path> filesBelow(Path folder, String suffix) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(file -> file.toString().endsWith(suffix))
                    .sorted()
                    .collect(Collectors.toList());
        }
    }

    private static String roomOf(Path file, String code) {
        Matcher declaration = PACKAGE.matcher(code);
        if (!declaration.find()) {
            throw new IllegalStateException(file + " declares no package");
        }
        String name = declaration.group(1);
        return room(name.substring(BASE.length()));
    }

    /** The room of a package, which is given without the base; the package itself if it is in none. */
    private static String room(String packageName) {
        String room = packageName.isEmpty() ? "api" : packageName.substring(1);
        while (!MAY_USE.containsKey(room) && room.contains(".")) {
            room = room.substring(0, room.lastIndexOf('.'));
        }
        return room;
    }

    private static Set<String> roomsUsed(String body) {
        return OWN_NAME.matcher(body).results().map(name -> room(name.group(1))).collect(Collectors.toSet());
    }
}
