package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.results.Numbers;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * The bytes that a stage of World must move at the least: what it takes from the stage before it and leaves to the next one,
 * once a pass, in the sizes of the engine's own records. Whatever an engine keeps beside them (counts, links, tables) is not
 * in it, nor what is read twice. Caches that hold data from one pass to the next can beat it; they do in small worlds.
 *
 * @param stage the stage, as result files name it
 * @param column of the results, with its time
 * @param perCircle bytes a circle and step
 * @param perContact bytes a contact and step
 * @param passes how often it goes over its data in a step
 * @param counted what is counted, in words
 */
public record WorldTraffic(String stage, String column, int perCircle, int perContact, int passes, String counted) {
    private static final int SUB_STEPS = 4;

    /** Position, radius, mass, displacement, velocity, traits, id, memory. */
    private static final int STATE = 3 * 16 + 2 * 4;

    /** Passes over the contacts a step: one that pushes and one that relaxes, each sub-step. */
    private static final int PASSES = 2 * SUB_STEPS;

    /** The stages whose traffic is counted. */
    public static final List<WorldTraffic> STAGES = List.of(
            new WorldTraffic(
                    "Grid",
                    "grid_us",
                    2 * STATE,
                    0,
                    1,
                    "the state of a circle, " + STATE + " bytes, read and written in the order of the cells"),
            new WorldTraffic(
                    "Contacts",
                    "contacts_us",
                    20,
                    16 + 8 + 32 + 4,
                    1,
                    "position, speculative distance and id of a circle read; of a contact 16 bytes of the impulse cache read,"
                            + " its pair (8), what stays for the step (32) and its impulse (4) written"),
            new WorldTraffic(
                    "Solver",
                    "solver_us",
                    PASSES * (16 + 16 + 16) + STATE,
                    PASSES * (8 + 32 + 4 + 4) + 16,
                    PASSES,
                    "a pass reads and writes the motion of a circle (2 x 16) and reads its traits (16), reads pair, what stays and"
                            + " impulse of a contact (44) and writes the impulse (4); two passes in each of "
                            + SUB_STEPS
                            + " sub-steps; at the end the state (" + STATE
                            + ") and a contact's entry in the impulse cache (16) are written"),
            new WorldTraffic(
                    "Resident",
                    "resident_us",
                    2 * STATE + 20 + PASSES * (16 + 16 + 16) + STATE,
                    16 + 8 + 32 + 4 + PASSES * (8 + 32 + 4 + 4) + 16,
                    PASSES + 2,
                    "the three above: whole steps in one launch"));

    /**
     * Whether the plan of a run goes by stages: then Grid, Contacts and Solver all take time. In a plan that makes whole steps in one
     * launch, no stage runs, and their time is that of what World counts for its statistics.
     *
     * @param run a row of the results of World
     */
    static boolean byStages(Map<String, String> run) {
        return Stream.of("grid_us", "contacts_us", "solver_us").allMatch(column -> Numbers.parse(run.get(column)) > 0);
    }

    /** Bytes a step. */
    public double movedBytes(double circles, double contacts) {
        return perCircle * circles + perContact * contacts;
    }
}
