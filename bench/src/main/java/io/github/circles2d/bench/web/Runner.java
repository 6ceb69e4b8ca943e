package io.github.circles2d.bench.web;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A process that has an engine and a scene. It makes a run when it is told, and waits meanwhile. */
final class Runner implements AutoCloseable {
    /** Begins each line of an answer; other lines are what engines write. */
    static final String MARK = "circles2d-bench: ";

    private final List<String> command;
    private final Process process;
    private final BufferedReader answers;
    private final Writer orders;
    private final String description;

    /**
     * What a run took, in microseconds a step.
     *
     * @param ended whether it was not given up as too long
     * @param median the median step; NaN of a run that was given up
     * @param mean the mean of the steps that count; of a run that was given up, of those that were made
     */
    record Figures(boolean ended, double median, double mean) {}

    /**
     * Starts the process, and waits until it is ready.
     *
     * @throws IOException if it ends before that
     */
    Runner(List<String> command) throws IOException {
        this.command = command;
        process = new ProcessBuilder(command).redirectError(Redirect.INHERIT).start();
        answers = process.inputReader(StandardCharsets.UTF_8);
        orders = process.outputWriter(StandardCharsets.UTF_8);
        description = answer("ready");
    }

    /** What the engine runs in, with versions. */
    String description() {
        return description;
    }

    /**
     * Makes a run.
     *
     * @param seconds a run that cannot end in this time is given up
     * @throws IOException if the process ends
     */
    Figures run(double seconds) throws IOException {
        orders.write(seconds + "\n");
        orders.flush();
        String[] words = answer("").split(" ");
        return switch (words[0]) {
            case "ok" -> new Figures(true, Double.parseDouble(words[1]), Double.parseDouble(words[2]));
            case "about" -> new Figures(false, Double.NaN, Double.parseDouble(words[1]));
            default -> throw new IOException("a runner said " + String.join(" ", words));
        };
    }

    private String answer(String kind) throws IOException {
        for (String line = answers.readLine(); line != null; line = answers.readLine()) {
            if (line.startsWith(MARK + kind)) {
                return line.substring(MARK.length() + kind.length()).trim();
            }
        }
        throw new IOException("the process ended: " + String.join(" ", command));
    }

    /** Lets the process end: it gets no more orders. */
    @Override
    public void close() {
        try {
            orders.close();
        } catch (IOException e) {
            // It has ended by itself.
            process.destroy();
        }
        try {
            if (!process.waitFor(10, TimeUnit.SECONDS)) {
                process.destroyForcibly();
            }
        } catch (InterruptedException e) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
    }
}
