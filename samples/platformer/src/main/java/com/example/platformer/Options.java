package com.example.platformer;

import io.github.circles2d.Backend;
import java.util.List;

/** What the command line asks for: frames to play alone (0: a window to play in), what to run on, and a file for a picture or "". */
record Options(int frames, Backend backend, String picture) {
    private static final List<String> NAMES = List.of("--frames", "--backend", "--picture");
    private static final String USAGE =
            "usage: platformer [--frames N [--picture FILE.png]] [--backend auto|jvm|cpu|gpu]\n\n"
                    + "With --frames it plays by itself, without a window, and prints what became of it.";
    private static final int MOST_FRAMES = 1_000_000;

    /** Reads the command line. If it asks for help or makes no sense, says so and ends the program. */
    static Options read(String... arguments) {
        if (List.of(arguments).contains("--help") || List.of(arguments).contains("-h")) {
            System.out.println(USAGE);
            System.exit(0);
        }
        try {
            return parse(arguments);
        } catch (IllegalArgumentException e) {
            throw end(2, e.getMessage(), "--help lists the options");
        }
    }

    /** Ends the program with the exit status of the playground: 2 for a wrong command line, 1 for what cannot be done here. */
    static IllegalStateException end(int status, String... lines) {
        for (String line : lines) {
            System.err.println("platformer: " + line);
        }
        System.exit(status);
        return new IllegalStateException(); // for the compiler
    }

    private static Options parse(String... arguments) {
        int frames = 0;
        Backend backend = Backend.AUTO;
        String picture = "";
        for (int k = 0; k < arguments.length; k += 2) {
            require(NAMES.contains(arguments[k]), "there is no option '" + arguments[k] + "'");
            require(k + 1 < arguments.length, arguments[k] + " needs a value");
            switch (arguments[k]) {
                case "--frames" -> frames = frames(arguments[k + 1]);
                case "--backend" -> backend = backend(arguments[k + 1]);
                default -> picture = arguments[k + 1];
            }
        }
        require(picture.isEmpty() || frames > 0, "--picture needs --frames");
        return new Options(frames, backend, picture);
    }

    private static int frames(String value) {
        boolean isShort = value.matches("[0-9]{1,7}");
        int frames = isShort ? Integer.parseInt(value) : 0;
        String allowed = "--frames takes a whole number from 1 to " + MOST_FRAMES;
        require(frames >= 1 && frames <= MOST_FRAMES, allowed + ", not '" + value + "'");
        return frames;
    }

    private static Backend backend(String value) {
        return switch (value) {
            case "auto", "AUTO" -> Backend.AUTO;
            case "jvm", "JVM" -> Backend.JVM;
            case "cpu", "OPENCL_CPU" -> Backend.OPENCL_CPU;
            case "gpu", "OPENCL_GPU" -> Backend.OPENCL_GPU;
            default -> throw new IllegalArgumentException("--backend takes auto, jvm, cpu or gpu, not '" + value + "'");
        };
    }

    private static void require(boolean holds, String message) {
        if (!holds) {
            throw new IllegalArgumentException(message);
        }
    }
}
