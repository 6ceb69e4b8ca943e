// Obeys the benchmark: it writes a line for each run, with a limit in seconds, and gets a line of figures back.
import { writeFileSync } from 'node:fs';
import { createInterface } from 'node:readline';

const MARK = 'circles2d-bench:'; // other lines are what engines write

/** Says what it is, then answers each line until there is none; `run(seconds)` gives figures and an end state. */
export async function obey(description, stateFile, run) {
  console.log(MARK, 'ready', description);
  for await (const line of createInterface({ input: process.stdin })) {
    const { figures, state } = await run(Number(line));
    if (figures.median === undefined) {
      console.log(MARK, 'about', figures.mean);
    } else {
      writeFileSync(stateFile, bytes(state));
      console.log(MARK, 'ok', figures.median, figures.mean);
    }
  }
}

function bytes(state) {
  const all = Buffer.alloc(4 * state.length);
  state.forEach((value, k) => all.writeFloatLE(value, 4 * k));
  return all;
}
