/** The command line of {@code benchmarks.jar}: the sweep, its reports, and JMH itself. */
package io.github.circles2d.bench;
