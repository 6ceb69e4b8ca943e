/** The contacts of circles, from pairs to impulses, and stage Solver, which makes all passes of a sub-step. */
package io.github.circles2d.world.jvm.solver;
