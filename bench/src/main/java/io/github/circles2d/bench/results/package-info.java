/** A results folder: one CSV a kind of measurement and the JMH JSON, kept up to date after every run. */
package io.github.circles2d.bench.results;
