// Times the steps of an engine. The same in Node and in a browser.

/** Steps after which a run can be given up. */
const TRIAL_STEPS = 3;
const TRIAL_SECONDS = 3;

/**
 * Loads the scene and makes all steps, each timed alone; those that are skipped do not count. A run that cannot end in time is given
 * up. Returns the median and the mean in microseconds, or the mean alone of a run that was given up.
 */
export function run(engine, scene, seconds) {
  engine.load(scene);
  const all = scene.skipped + scene.steps;
  const micros = [];
  const begun = performance.now();
  let fastest = Infinity;
  for (let step = 1; step <= all; step++) {
    const from = performance.now();
    engine.step();
    const to = performance.now();
    fastest = Math.min(fastest, to - from);
    if (step > scene.skipped) {
      micros.push(1000 * (to - from));
    }
    const spent = (to - begun) / 1000;
    const least = spent + (all - step) * fastest / 1000;
    if (step < all && step >= TRIAL_STEPS && (spent > seconds || spent > TRIAL_SECONDS && least > seconds)) {
      return { mean: 1e6 * spent / step };
    }
  }
  return { median: median(micros), mean: micros.reduce((sum, value) => sum + value) / micros.length };
}

function median(values) {
  const sorted = Float64Array.from(values).sort();
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}
