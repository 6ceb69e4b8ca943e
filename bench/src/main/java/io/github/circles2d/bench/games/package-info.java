/** What the features for games cost {@code World}. */
package io.github.circles2d.bench.games;
