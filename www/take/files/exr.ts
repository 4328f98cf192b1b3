/**
 * Heights as an OpenEXR file: one part of scan lines, one channel Y of 32 bit floats, uncompressed (OpenEXR File
 * Layout).
 */
import { FileParts, type RowWriter } from './parts';

/** Attributes with their types. The values are 32 bit numbers, or the list of channels. */
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

/** Writes the file of a map with one channel of 32 bits. */
export class ExrWriter implements RowWriter {
  private readonly side: number;
  private readonly parts = new FileParts();
  private line = 0;

  constructor(side: number) {
    this.side = side;
    const text = new TextEncoder();
    const attributes = ATTRIBUTES(side - 1).flatMap(([name, kind, value]) => [...text.encode(`${name}\0${kind}\0`), ...words(value.length), ...value]);
    const head = Uint8Array.from([...words(20_000_630, 2), ...attributes, 0]);
    // The table holds where each line begins, in 64 bits.
    const begin = head.length + 8 * side;
    const table = new DataView(new ArrayBuffer(8 * side));
    for (let y = 0; y < side; y += 1) table.setUint32(8 * y, begin + y * (8 + 4 * side), true);
    this.parts.add(head);
    this.parts.add(new Uint8Array(table.buffer));
  }

  write(rows: Uint8Array): Promise<void> {
    const { side } = this;
    const values = new DataView(rows.buffer, rows.byteOffset);
    for (let at = 0; at < rows.length; at += 4 * side) {
      const line = new DataView(new ArrayBuffer(8 + 4 * side));
      line.setUint32(0, this.line++, true);
      line.setUint32(4, 4 * side, true);
      // Maps store the high byte first.
      for (let x = 0; x < side; x += 1) line.setFloat32(8 + 4 * x, values.getFloat32(at + 4 * x), true);
      this.parts.add(new Uint8Array(line.buffer));
    }
    return Promise.resolve();
  }

  finish(): Promise<Blob> {
    return Promise.resolve(this.parts.file('image/x-exr'));
  }
}

function words(...numbers: number[]): Uint8Array {
  const view = new DataView(new ArrayBuffer(4 * numbers.length));
  numbers.forEach((number, k) => view.setUint32(4 * k, number, true));
  return new Uint8Array(view.buffer);
}
