// Links that have a world in them. Their fragment is #world= and, in base64url without padding, a byte with the number of the format, which
// is 1, and the snapshot, compressed by raw DEFLATE.
const KEY = '#world=';
const FORMAT = 1;
const GREATEST_LENGTH = 32_000; // characters of a fragment: about 500 circles that move

export const isLink = fragment => fragment.startsWith(KEY);

/** The fragment of a snapshot, which is a Uint8Array. */
export async function fragmentOf(snapshot) {
  const compressed = await through(new CompressionStream('deflate-raw'), snapshot);
  const length = KEY.length + Math.ceil((1 + compressed.length) * 4 / 3);
  if (length > GREATEST_LENGTH) {
    throw new Error(`a link would have ${inWords(length)}, and may have ${inWords(GREATEST_LENGTH)}: save a file instead`);
  }
  const text = btoa(String.fromCharCode(FORMAT, ...compressed));
  return KEY + text.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** The snapshot of a fragment. */
export async function snapshotOf(fragment) {
  if (fragment.length > GREATEST_LENGTH) {
    throw new Error(`it has ${inWords(fragment.length)}, and may have ${inWords(GREATEST_LENGTH)}`);
  }
  const bytes = bytesOf(fragment.slice(KEY.length));
  if (bytes.length === 0) {
    throw new Error('it has no world');
  }
  if (bytes[0] !== FORMAT) {
    throw new Error(`it is from a later version of circles2d, or damaged: its format is ${bytes[0]}, and this page reads ${FORMAT}`);
  }
  try {
    return await through(new DecompressionStream('deflate-raw'), bytes.subarray(1));
  } catch {
    throw new Error('it is damaged or cut off');
  }
}

const inWords = length => `${length.toLocaleString('en')} characters`;

function bytesOf(base64url) {
  try {
    return Uint8Array.from(atob(base64url.replaceAll('-', '+').replaceAll('_', '/')), c => c.charCodeAt(0));
  } catch {
    throw new Error('it is damaged: not all of its characters are those of a link');
  }
}

async function through(stream, bytes) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts = [];
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}
