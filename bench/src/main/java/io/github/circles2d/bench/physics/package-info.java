/**
 * The measure of World's physics: scenes with a bound each, run on World and on Box2D. A {@link
 * io.github.circles2d.bench.physics.Row} holds the cases of one line of the table, {@link
 * io.github.circles2d.bench.physics.Rows} lists them.
 */
package io.github.circles2d.bench.physics;
