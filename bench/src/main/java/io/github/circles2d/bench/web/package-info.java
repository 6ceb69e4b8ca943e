/**
 * World on the JVM, in Node and in a browser, beside engines for JavaScript, each in a process of its own, in turns. {@link
 * io.github.circles2d.bench.web.Entrant} lists them.
 */
package io.github.circles2d.bench.web;
