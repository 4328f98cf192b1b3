// The places in the source ("src/order.rs", line, column) that a panic would name, in the data of a module.

const dataSection = 11;

/**
 * Writes zeros over all places and the names of their files: as nothing tells them any more, this only makes the
 * module smaller when it is packed.
 * @param {Buffer} module a WebAssembly module with plain data segments, as the linker makes it; it is changed
 * @returns {number} how many places there were
 */
export function eraseLocations(module) {
  let at = 8;
  let found = 0;
  while (at < module.length) {
    const section = module[at++];
    const length = number();
    const next = at + length;
    if (section === dataSection) {
      for (let left = number(); left > 0; left--) {
        // Flags and "i32.const", the address, "end", then the bytes.
        at += 2;
        const address = number();
        at += 1;
        const size = number();
        found += eraseIn(module.subarray(at, at + size), address);
        at += size;
      }
    }
    at = next;
  }
  return found;

  /** The next whole number, seven bits to a byte. */
  function number() {
    let [value, shift, byte] = [0, 0, 0];
    do {
      byte = module[at++] ?? 0;
      value |= (byte & 127) << shift;
      shift += 7;
    } while (byte >= 128);
    return value >>> 0;
  }
}

/**
 * @param {Buffer} segment
 * @param {number} address where it will be in memory
 */
function eraseIn(segment, address) {
  /** @type {Map<number, number>} */
  const names = new Map();
  let found = 0;
  // A place is four words: where its file's name is, the name's length, line and column.
  for (let at = -address & 3; at + 16 <= segment.length; at += 4) {
    const [start, length, line, column] = [0, 4, 8, 12].map((word) => segment.readUInt32LE(at + word));
    const from = start - address;
    if (line === 0 || column === 0 || length > 400 || from < 0 || from + length > segment.length) continue;
    if (!/^[ -~]+\.rs$/.test(segment.toString('latin1', from, from + length))) continue;
    names.set(from, length);
    segment.fill(0, at, at + 16);
    found += 1;
  }
  for (const [from, length] of names) segment.fill(0, from, from + length);
  return found;
}
