/** Two engines for rigid, non-rotating circles in two dimensions. */
package io.github.circles2d;
