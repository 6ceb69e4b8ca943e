/**
 * Scenes with published parameters, and the measures by which their outcome is judged. Demos, benchmarks and tests
 * share them, so that a figure means the same wherever it is quoted. Imports nothing of the library.
 */
package io.github.circles2d.scenes;
