/** What is made of a results folder: the tables on the console, the charts, and the results page. */
package io.github.circles2d.bench.report;
