/** Pixels as PNG files, with 16 bits a channel where a map has them, which a canvas cannot do. */
import type { PixelMap } from './types';

const SIGNATURE = [137, 80, 78, 71, 13, 10, 26, 10];
/** Each row as the difference to the one above (PNG specification, section 9). */
const UP = 2;

export async function png({ side, channels, bits, bytes }: PixelMap): Promise<Uint8Array> {
  const head = new Uint8Array(13);
  const view = new DataView(head.buffer);
  view.setUint32(0, side);
  view.setUint32(4, side);
  head.set([bits, channels === 1 ? 0 : 2], 8);
  const packed = await deflated(filtered(bytes, (side * channels * bits) / 8));
  return joined([Uint8Array.from(SIGNATURE), chunk('IHDR', head), chunk('IDAT', packed), chunk('IEND', new Uint8Array())]);
}

function filtered(bytes: Uint8Array, row: number): Uint8Array<ArrayBuffer> {
  const rows = bytes.length / row;
  const out = new Uint8Array(bytes.length + rows);
  for (let y = 0, at = 0; y < rows; y += 1) {
    out[at++] = UP;
    for (let k = y * row; k < (y + 1) * row; k += 1) out[at++] = (bytes[k] ?? 0) - (bytes[k - row] ?? 0);
  }
  return out;
}

/** The browser packs in a thread of its own; its “deflate” is the format of zlib that PNG asks for. */
async function deflated(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const packed = new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate'));
  return new Uint8Array(await new Response(packed).arrayBuffer());
}

function chunk(name: string, content: Uint8Array): Uint8Array {
  const named = joined([new TextEncoder().encode(name), content]);
  const ends = new Uint8Array(8);
  const view = new DataView(ends.buffer);
  view.setUint32(0, content.length);
  view.setUint32(4, crc(named));
  return joined([ends.subarray(0, 4), named, ends.subarray(4)]);
}

const REMAINDERS = Uint32Array.from({ length: 256 }, (_, byte) => {
  let rest = byte;
  for (let bit = 0; bit < 8; bit += 1) rest = rest & 1 ? (rest >>> 1) ^ 0xedb88320 : rest >>> 1;
  return rest;
});

function crc(bytes: Uint8Array): number {
  let rest = 0xffffffff;
  for (const byte of bytes) rest = (REMAINDERS[(rest ^ byte) & 255] ?? 0) ^ (rest >>> 8);
  return (rest ^ 0xffffffff) >>> 0;
}

function joined(parts: Uint8Array[]): Uint8Array {
  const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}
