/**
 * Decompresses LZMA piece by piece (the .lzma format of Igor Pavlov's LZMA specification, 2015). LZMA makes the
 * module a fifth smaller than gzip, the format of most hosts. Browsers decompress gzip themselves; they do not
 * support LZMA, and not all support brotli.
 */

const STATES = 12;
const POSITIONS = 16;

/** Offsets of the probabilities in one array. */
const IS_MATCH = 0;
const IS_REP = IS_MATCH + STATES * POSITIONS;
const IS_REP_0 = IS_REP + STATES;
const IS_REP_1 = IS_REP_0 + STATES;
const IS_REP_2 = IS_REP_1 + STATES;
const IS_REP_0_LONG = IS_REP_2 + STATES;
const SLOT = IS_REP_0_LONG + STATES * POSITIONS;
const SPECIAL = SLOT + 4 * 64;
const ALIGN = SPECIAL + 115;
const LENGTH = ALIGN + 16;
const LENGTHS = 2 + 2 * 8 * POSITIONS + 256;
const REP_LENGTH = LENGTH + LENGTHS;
const LITERAL = REP_LENGTH + LENGTHS;

/** Bytes of the header: properties, size of the dictionary, size of the whole. */
const HEAD = 13;

export class Unpacker {
  /** The decompressed bytes so far, in an array of the final size, which is also the dictionary. */
  private readonly out: Uint8Array<ArrayBuffer>;
  private readonly packed: Uint8Array;
  private readonly probabilities: Uint16Array;
  private readonly literalContext: number;
  private readonly literalMask: number;
  private readonly positionMask: number;
  private at = HEAD + 5;
  private made = 0;
  private state = 0;
  /** The last four distances. */
  private readonly distances = new Int32Array(4);
  /** Range and code of the range coder. A typed array avoids boxed numbers. */
  private readonly coder = new Uint32Array(2);

  constructor(packed: Uint8Array) {
    this.packed = packed;
    const view = new DataView(packed.buffer, packed.byteOffset);
    const properties = view.getUint8(0);
    this.literalContext = properties % 9;
    this.literalMask = (1 << (Math.floor(properties / 9) % 5)) - 1;
    this.positionMask = (1 << Math.floor(properties / 45)) - 1;
    this.out = new Uint8Array(view.getUint32(5, true));
    this.probabilities = new Uint16Array(LITERAL + 0x300 * (this.literalMask + 1) * (1 << this.literalContext)).fill(1024);
    this.coder.set([0xffffffff, view.getUint32(HEAD + 1)]);
  }

  /** The next bytes, about `bytes` of them; empty at the end. */
  next(bytes: number): Uint8Array<ArrayBuffer> {
    const from = this.made;
    const to = Math.min(this.out.length, from + bytes);
    while (this.made < to) {
      const position = this.made & this.positionMask;
      if (this.bit(IS_MATCH + this.state * POSITIONS + position)) this.match(position);
      else this.literal();
    }
    return this.out.subarray(from, this.made);
  }

  private bit(place: number): number {
    const { coder, probabilities } = this;
    const probability = probabilities[place] as number;
    let range = coder[0] as number;
    let code = coder[1] as number;
    const bound = (range >>> 11) * probability;
    let bit = 0;
    if (code < bound) {
      range = bound;
      probabilities[place] = probability + ((2048 - probability) >> 5);
    } else {
      range -= bound;
      code -= bound;
      probabilities[place] = probability - (probability >> 5);
      bit = 1;
    }
    if (range < 0x1000000) {
      range *= 256;
      code = code * 256 + (this.packed[this.at++] ?? 0);
    }
    coder[0] = range;
    coder[1] = code;
    return bit;
  }

  private direct(count: number): number {
    let value = 0;
    for (let k = 0; k < count; k += 1) {
      let range = (this.coder[0] as number) >>> 1;
      let code = this.coder[1] as number;
      const bit = code >= range ? 1 : 0;
      if (bit) code -= range;
      if (range < 0x1000000) {
        range *= 256;
        code = code * 256 + (this.packed[this.at++] ?? 0);
      }
      this.coder[0] = range;
      this.coder[1] = code;
      value = value * 2 + bit;
    }
    return value;
  }

  private tree(place: number, bits: number): number {
    let node = 1;
    for (let k = 0; k < bits; k += 1) node = node * 2 + this.bit(place + node);
    return node - (1 << bits);
  }

  private reverse(place: number, bits: number): number {
    let [node, value] = [1, 0];
    for (let k = 0; k < bits; k += 1) {
      const bit = this.bit(place + node);
      node = node * 2 + bit;
      value += bit << k;
    }
    return value;
  }

  private literal(): void {
    const before = this.made ? (this.out[this.made - 1] as number) : 0;
    const context = ((this.made & this.literalMask) << this.literalContext) + (before >> (8 - this.literalContext));
    const place = LITERAL + 0x300 * context;
    let symbol = 1;
    if (this.state >= 7) {
      let matched = this.out[this.made - (this.distances[0] as number) - 1] as number;
      do {
        const expected = (matched >> 7) & 1;
        matched <<= 1;
        const bit = this.bit(place + ((1 + expected) << 8) + symbol);
        symbol = symbol * 2 + bit;
        if (expected !== bit) break;
      } while (symbol < 0x100);
    }
    while (symbol < 0x100) symbol = symbol * 2 + this.bit(place + symbol);
    this.out[this.made++] = symbol;
    this.state = this.state < 4 ? 0 : this.state - (this.state < 10 ? 3 : 6);
  }

  private match(position: number): void {
    const { state, distances } = this;
    if (!this.bit(IS_REP + state)) {
      distances.copyWithin(1, 0, 3);
      const length = this.length(LENGTH, position);
      this.state = state < 7 ? 7 : 10;
      distances[0] = this.distance(length);
      this.copy(length + 2);
      return;
    }
    if (!this.bit(IS_REP_0 + state)) {
      if (!this.bit(IS_REP_0_LONG + state * POSITIONS + position)) {
        this.state = state < 7 ? 9 : 11;
        this.copy(1);
        return;
      }
    } else {
      const which = this.bit(IS_REP_1 + state) ? 2 + this.bit(IS_REP_2 + state) : 1;
      const distance = distances[which] as number;
      distances.copyWithin(1, 0, which);
      distances[0] = distance;
    }
    const length = this.length(REP_LENGTH, position);
    this.state = state < 7 ? 8 : 11;
    this.copy(length + 2);
  }

  private length(place: number, position: number): number {
    if (!this.bit(place)) return this.tree(place + 2 + 8 * position, 3);
    if (!this.bit(place + 1)) return 8 + this.tree(place + 2 + 8 * (POSITIONS + position), 3);
    return 16 + this.tree(place + 2 + 16 * POSITIONS, 8);
  }

  private distance(length: number): number {
    const slot = this.tree(SLOT + 64 * Math.min(length, 3), 6);
    if (slot < 4) return slot;
    const bits = (slot >> 1) - 1;
    const base = (2 + (slot & 1)) * 2 ** bits;
    if (slot < 14) return base + this.reverse(SPECIAL + base - slot, bits);
    return base + this.direct(bits - 4) * 16 + this.reverse(ALIGN, 4);
  }

  private copy(length: number): void {
    const { out } = this;
    const end = Math.min(out.length, this.made + length);
    const back = (this.distances[0] as number) + 1;
    for (let to = this.made; to < end; to += 1) out[to] = out[to - back] as number;
    this.made = end;
  }
}
