/**
 * The JMH benchmarks. Each iteration builds the same start anew, runs a fixed number of steps (the operations per
 * invocation, {@code -opi}) and checks the end state.
 */
package io.github.circles2d.bench.jmh;
