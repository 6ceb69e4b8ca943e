package io.github.circles2d.check;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The same for the JVM: {@code lines}, {@code record FILE} and {@code replay FILE}. */
public final class Jvm {
    private Jvm() {}

    /** Prints what was asked for. */
    public static void main(String[] arguments) throws IOException {
        switch (arguments[0]) {
            case "lines" -> System.out.print(Check.all());
            case "record" -> Files.write(Path.of(arguments[1]), Logs.record());
            case "replay" -> System.out.println(Logs.replay(Files.readAllBytes(Path.of(arguments[1]))));
            default -> throw new IllegalArgumentException(arguments[0]);
        }
    }
}
