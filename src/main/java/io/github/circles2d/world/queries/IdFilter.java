package io.github.circles2d.world.queries;

/** Says which circles a search may find. Where a search takes one, null admits all and costs nothing. */
@FunctionalInterface
public interface IdFilter {
    /** A search asks only about circles that it would find without a filter. */
    boolean admits(int id);
}
