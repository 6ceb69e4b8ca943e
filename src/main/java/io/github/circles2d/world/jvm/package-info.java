/** The pipeline in Java: the stages of a step in their order, run by a team of threads. Rooms below have the stages. Not part of the public API. */
package io.github.circles2d.world.jvm;
