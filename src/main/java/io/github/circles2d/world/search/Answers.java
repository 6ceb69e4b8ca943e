package io.github.circles2d.world.search;

/** What answers the queries of a batch, and returns how much they find. */
interface Answers {
    /** Queries that find all. */
    int all(QueryBatch batch);

    /** Queries that find one each or none; how many find one. A single query's handle is in element 0. */
    int one(QueryBatch batch);

    /** Queries for the nearest. */
    int nearest(QueryBatch batch);
}
