/** The sweep: which runs there are, how long they will take, and running them within a budget of time. */
package io.github.circles2d.bench.sweep;
