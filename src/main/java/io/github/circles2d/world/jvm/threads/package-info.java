/** A team of threads that run one piece of work together, and the barrier between its parts. Not part of the public API. */
package io.github.circles2d.world.jvm.threads;
