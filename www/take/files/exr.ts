/** Heights as an OpenEXR file: one part of scan lines, one channel Y of 32 bit floats, not packed (OpenEXR File Layout). */
import type { PixelMap } from '../../module/types';

/** Attributes with their types; the values are numbers of 32 bits, or the list of channels. */
const ATTRIBUTES = (last: number): readonly (readonly [name: string, kind: string, value: Uint8Array])[] => {
  const window = words(0, 0, last, last);
  const one = words(0x3f800000);
  return [
    ['channels', 'chlist', Uint8Array.from([89, 0, ...words(2, 0, 1, 1), 0])],
    ['compression', 'compression', new Uint8Array(1)],
    ['dataWindow', 'box2i', window],
    ['displayWindow', 'box2i', window],
    ['lineOrder', 'lineOrder', new Uint8Array(1)],
    ['pixelAspectRatio', 'float', one],
    ['screenWindowCenter', 'v2f', words(0, 0)],
    ['screenWindowWidth', 'float', one],
  ];
};

/** The file of a map of one channel of 32 bits. */
export function exr({ side, bytes }: PixelMap): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder();
  const attributes = ATTRIBUTES(side - 1).flatMap(([name, kind, value]) => [...text.encode(`${name}\0${kind}\0`), ...words(value.length), ...value]);
  const head = Uint8Array.from([...words(20_000_630, 2), ...attributes, 0]);
  // The table tells where each line begins, in 64 bits.
  const begin = head.length + 8 * side;
  const line = 8 + 4 * side;
  const file = new Uint8Array(begin + side * line);
  const out = new DataView(file.buffer);
  const values = new DataView(bytes.buffer, bytes.byteOffset);
  file.set(head);
  for (let y = 0; y < side; y += 1) {
    const at = begin + y * line;
    out.setUint32(head.length + 8 * y, at, true);
    out.setUint32(at, y, true);
    out.setUint32(at + 4, 4 * side, true);
    // Maps have the high byte first.
    for (let x = 0; x < side; x += 1) out.setFloat32(at + 8 + 4 * x, values.getFloat32(4 * (y * side + x)), true);
  }
  return file;
}

function words(...numbers: number[]): Uint8Array {
  const view = new DataView(new ArrayBuffer(4 * numbers.length));
  numbers.forEach((number, k) => view.setUint32(4 * k, number, true));
  return new Uint8Array(view.buffer);
}
