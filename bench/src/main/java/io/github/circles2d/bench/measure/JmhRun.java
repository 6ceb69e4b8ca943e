package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.results.Statistics;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.openjdk.jmh.results.IterationResult;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;

/**
 * How a task went in a JVM of its own.
 *
 * @param result the figures, or null
 * @param failure why there are none, in one line
 */
record JmhRun(RunResult result, String failure) {
    /** The first line of a stack trace: class and message. */
    private static final Pattern FAILURE = Pattern.compile("(?m)^(?:Caused by: )?([\\w.$]+(?:Exception|Error)): (.*)$");

    /** How the failure of a run begins that took too long. */
    static final String GIVEN_UP = "given up";

    /**
     * Runs a task.
     *
     * @param warmups iterations that do not count
     * @param runs iterations that count
     * @param timeoutSeconds after which the run is given up and its JVM killed
     */
    static JmhRun of(Task task, int warmups, int runs, long timeoutSeconds) throws IOException {
        Path log = Files.createTempFile("circles2d-jmh", ".log");
        PrintStream console = System.err;
        ByteArrayOutputStream errors = new ByteArrayOutputStream();
        CompletableFuture<Void> watchdog = killChildrenAfter(timeoutSeconds);
        try {
            // JMH passes on what the other JVM writes to its standard error, past the log.
            System.setErr(new PrintStream(errors, true, StandardCharsets.UTF_8));
            ChainedOptionsBuilder options = new OptionsBuilder()
                    .include("^" + Pattern.quote(task.benchmark()) + "$")
                    .operationsPerInvocation(task.steps())
                    .warmupIterations(warmups)
                    .measurementIterations(runs)
                    // not JMH's to give up: it would interrupt the run and go on waiting for it
                    .timeout(TimeValue.seconds(2 * timeoutSeconds + 600))
                    .output(log.toString());
            for (Map.Entry<String, String> parameter : task.parameters().entrySet()) {
                options.param(parameter.getKey(), parameter.getValue());
            }
            Collection<RunResult> results = new Runner(options.build()).run();
            if (watchdog.isDone()) {
                return new JmhRun(null, GIVEN_UP + " after " + timeoutSeconds + " s");
            }
            if (results.isEmpty()) {
                String said = Files.readString(log, StandardCharsets.UTF_8) + errors.toString(StandardCharsets.UTF_8);
                return new JmhRun(null, reason(said));
            }
            return new JmhRun(results.iterator().next(), "");
        } catch (RunnerException e) {
            return new JmhRun(null, e.getMessage());
        } finally {
            watchdog.cancel(false);
            System.setErr(console);
            Files.delete(log);
        }
    }

    /** What a failed run's log says of the cause. */
    static String reason(String log) {
        Matcher matcher = FAILURE.matcher(log);
        if (matcher.find()) {
            String name = matcher.group(1).substring(matcher.group(1).lastIndexOf('.') + 1);
            return name + ": " + matcher.group(2);
        }
        Matcher exit = Pattern.compile("exit code (\\d+)").matcher(log);
        return exit.find() ? "the JVM ended with exit code " + exit.group(1) : "no result";
    }

    /** Ms a step of the iterations that counted. */
    Statistics millis() {
        return Statistics.of(iterations().stream()
                .mapToDouble(iteration -> iteration.getPrimaryResult().getScore())
                .toArray());
    }

    /** The mean of a counter over the iterations that counted; NaN where the benchmark has none of that name. */
    double counter(String name) {
        double sum = 0;
        for (IterationResult iteration : iterations()) {
            Result<?> counter = iteration.getSecondaryResults().get(name);
            sum += counter == null ? Double.NaN : counter.getScore();
        }
        return sum / iterations().size();
    }

    private Collection<IterationResult> iterations() {
        return result.getBenchmarkResults().iterator().next().getIterationResults();
    }

    /** Kills the JVMs that this one has started, unless that is cancelled in time. */
    static CompletableFuture<Void> killChildrenAfter(long seconds) {
        return CompletableFuture.runAsync(
                () -> ProcessHandle.current().children().forEach(ProcessHandle::destroyForcibly),
                CompletableFuture.delayedExecutor(seconds, TimeUnit.SECONDS));
    }
}
