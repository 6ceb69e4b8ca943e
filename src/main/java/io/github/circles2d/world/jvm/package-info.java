/** The pipeline in Java: each stage of a step is a class, run by a team of threads. Not part of the public API. */
package io.github.circles2d.world.jvm;
