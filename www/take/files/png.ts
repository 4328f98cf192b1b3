/** Pixels as PNG files. Maps may have 16 bits a channel, which a canvas cannot write. */
import type { PixelMap } from '../../module/types';
import { FileParts, type RowWriter } from './parts';

const SIGNATURE = [137, 80, 78, 71, 13, 10, 26, 10];
/** The filter type "Up": each row stores its difference from the row above (PNG specification, section 9). */
const UP = 2;

/** PNG colour types by the number of channels. */
const COLOUR_TYPES: Record<number, number> = { 1: 0, 3: 2, 4: 6 };

/** A PNG file that is compressed as its rows arrive. */
export class PngWriter implements RowWriter {
  private readonly head = new Uint8Array(13);
  private readonly row: number;
  private readonly above: Uint8Array;
  private readonly into: WritableStreamDefaultWriter<BufferSource>;
  private readonly parts = new FileParts();
  private readonly packed: Promise<void>;

  constructor(side: number, channels: number, bits: number) {
    const view = new DataView(this.head.buffer);
    view.setUint32(0, side);
    view.setUint32(4, side);
    this.head.set([bits, COLOUR_TYPES[channels] ?? 0], 8);
    this.row = (side * channels * bits) / 8;
    this.above = new Uint8Array(this.row);
    // The browser's "deflate" is the zlib format that PNG requires.
    const stream = new CompressionStream('deflate');
    this.into = stream.writable.getWriter();
    this.parts.add(Uint8Array.from(SIGNATURE));
    this.parts.add(chunk('IHDR', this.head));
    this.packed = this.pack(stream.readable.getReader());
  }

  async write(rows: Uint8Array): Promise<void> {
    if (rows.length) await this.into.write(this.filtered(rows));
  }

  async finish(): Promise<Blob> {
    await this.into.close();
    await this.packed;
    this.parts.add(chunk('IEND', new Uint8Array()));
    return this.parts.file('image/png');
  }

  /** Writes each compressed piece as a chunk of its own. */
  private async pack(from: ReadableStreamDefaultReader<Uint8Array>): Promise<void> {
    for (let piece = await from.read(); !piece.done; piece = await from.read()) this.parts.add(chunk('IDAT', piece.value));
  }

  private filtered(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
    const { row, above } = this;
    const rows = bytes.length / row;
    const out = new Uint8Array(bytes.length + rows);
    for (let y = 0, at = 0; y < rows; y += 1) {
      out[at++] = UP;
      const line = bytes.subarray(y * row, (y + 1) * row);
      for (let k = 0; k < row; k += 1) out[at++] = (line[k] ?? 0) - (above[k] ?? 0);
      above.set(line);
    }
    return out;
  }
}

export async function png({ side, channels, bits, bytes }: PixelMap): Promise<Blob> {
  const writer = new PngWriter(side, channels, bits);
  await writer.write(bytes);
  return writer.finish();
}

/** Bytes of the signature and of the IHDR chunk, which has to be the first. */
const HEAD = 33;

/** A copy of a PNG file with a text added. Keyword and text are ASCII. */
export async function withText(file: Blob, keyword: string, text: string): Promise<Blob> {
  const head = new Uint8Array(await file.slice(0, HEAD).arrayBuffer());
  const content = new TextEncoder().encode(`${keyword}\0${text}`);
  return new Blob([joined([head, chunk('tEXt', content)]), file.slice(HEAD)], { type: file.type });
}

/** The text with this keyword in a PNG file, or undefined. The first bytes of the file are enough. */
export function textIn(bytes: Uint8Array, keyword: string): string | undefined {
  if (SIGNATURE.some((byte, k) => bytes[k] !== byte)) return undefined;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const words = new TextDecoder('latin1');
  for (let at = SIGNATURE.length; at + 8 <= bytes.length; at += 12 + view.getUint32(at)) {
    const [name, content] = [words.decode(bytes.subarray(at + 4, at + 8)), at + 8];
    const text = words.decode(bytes.subarray(content, content + view.getUint32(at)));
    if (name === 'tEXt' && text.startsWith(`${keyword}\0`)) return text.slice(keyword.length + 1);
    if (name === 'IDAT') return undefined;
  }
  return undefined;
}

function chunk(name: string, content: Uint8Array): Uint8Array<ArrayBuffer> {
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

function joined(parts: Uint8Array[]): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}
