/** Measuring: the list of what is to be measured, how long it will take, and doing it within a budget of time. */
package io.github.circles2d.bench.measure;
