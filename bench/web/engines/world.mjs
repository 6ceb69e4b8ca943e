// World in WebAssembly. The program builds the scene itself, with the same numbers.

/** `program` is the file, as bytes or as an address. */
export async function createWorld(runtime, program) {
  const { exports: world } = await runtime.load(program);
  return {
    load: scene => world.load(scene.n),
    step: () => world.step(),
    state: () => world.state(),
  };
}
