// LZMA, which makes modules a third smaller than the formats that browsers decompress themselves. After the specification by Igor Pavlov (public domain), with
// its names; the whole output is the dictionary.

/** The first index of each kind of probability. */
const IS_MATCH = 0;
const IS_REP = IS_MATCH + (12 << 4);
const IS_REP_G0 = IS_REP + 12;
const IS_REP_G1 = IS_REP_G0 + 12;
const IS_REP_G2 = IS_REP_G1 + 12;
const IS_REP0_LONG = IS_REP_G2 + 12;
const POSITION_SLOT = IS_REP0_LONG + (12 << 4);
const POSITION_SPECIAL = POSITION_SLOT + (4 << 6);
const ALIGN = POSITION_SPECIAL + 115;
const LENGTH = ALIGN + 16;
const LENGTH_SIZE = 2 + (16 << 3) + (16 << 3) + 256;
const REP_LENGTH = LENGTH + LENGTH_SIZE;
const LITERAL = REP_LENGTH + LENGTH_SIZE;

/** Decodes bits with adaptive probabilities. */
class RangeDecoder {
  readonly #source: Uint8Array;
  readonly #probabilities: Uint16Array;
  #at: number;
  // Both as signed integers of 32 bits, with which browsers compute faster than with unsigned ones.
  #range = -1;
  #code = 0;

  constructor(source: Uint8Array, at: number, probabilities: number) {
    this.#source = source;
    this.#probabilities = new Uint16Array(probabilities).fill(1024);
    // The first byte is always zero.
    this.#at = at + 1;
    for (let n = 0; n < 4; n++) this.#code = (this.#code << 8) | this.#next();
  }

  bit(place: number): number {
    const probability = this.#probabilities[place] ?? 0;
    const bound = Math.imul(this.#range >>> 11, probability);
    let bit = 0;
    if (this.#code >>> 0 < bound >>> 0) {
      this.#range = bound;
      this.#probabilities[place] = probability + ((2048 - probability) >> 5);
    } else {
      this.#range = (this.#range - bound) | 0;
      this.#code = (this.#code - bound) | 0;
      this.#probabilities[place] = probability - (probability >> 5);
      bit = 1;
    }
    this.#normalize();
    return bit;
  }

  /** Bits of equal probability for 0 and 1. */
  direct(count: number): number {
    let value = 0;
    for (let n = 0; n < count; n++) {
      this.#range = (this.#range >>> 1) | 0;
      const bit = this.#code >>> 0 >= this.#range >>> 0 ? 1 : 0;
      if (bit === 1) this.#code = (this.#code - this.#range) | 0;
      this.#normalize();
      value = ((value << 1) | bit) >>> 0;
    }
    return value;
  }

  /** Bits, the highest first, each with the probabilities that belong to the bits before it. */
  tree(place: number, count: number): number {
    let symbol = 1;
    for (let n = 0; n < count; n++) symbol = (symbol << 1) | this.bit(place + symbol);
    return symbol - (1 << count);
  }

  /** Bits, the lowest first, with such probabilities. */
  reverseTree(place: number, count: number): number {
    let [symbol, value] = [1, 0];
    for (let n = 0; n < count; n++) {
      const bit = this.bit(place + symbol);
      symbol = (symbol << 1) | bit;
      value |= bit << n;
    }
    return value;
  }

  length(place: number, positionState: number): number {
    if (this.bit(place) === 0) return this.tree(place + 2 + (positionState << 3), 3);
    if (this.bit(place + 1) === 0) return 8 + this.tree(place + 2 + (16 << 3) + (positionState << 3), 3);
    return 16 + this.tree(place + 2 + (32 << 3), 8);
  }

  distance(length: number): number {
    const slot = this.tree(POSITION_SLOT + (Math.min(length, 3) << 6), 6);
    if (slot < 4) return slot;
    const count = (slot >> 1) - 1;
    const base = ((2 | (slot & 1)) << count) >>> 0;
    if (slot < 14) return base + this.reverseTree(POSITION_SPECIAL + base - slot, count);
    return base + this.direct(count - 4) * 16 + this.reverseTree(ALIGN, 4);
  }

  #normalize(): void {
    if ((this.#range & 0xff000000) === 0) {
      this.#range <<= 8;
      this.#code = (this.#code << 8) | this.#next();
    }
  }

  #next(): number {
    return this.#source[this.#at++] ?? 0;
  }
}

/** The content of a file in the format `.lzma`, whose header contains its size. */
export function decompressed(source: Uint8Array): Uint8Array<ArrayBuffer> {
  const header = new DataView(source.buffer, source.byteOffset, 13);
  const properties = header.getUint8(0);
  const [lc, lp, pb] = [properties % 9, Math.floor(properties / 9) % 5, Math.floor(properties / 45)];
  const output = new Uint8Array(header.getUint32(5, true));
  const decoder = new RangeDecoder(source, 13, LITERAL + (0x300 << (lc + lp)));
  let [state, at] = [0, 0];
  let [rep0, rep1, rep2, rep3] = [0, 0, 0, 0];
  while (at < output.length) {
    const positionState = at & ((1 << pb) - 1);
    if (decoder.bit(IS_MATCH + (state << 4) + positionState) === 0) {
      const literalState = ((at & ((1 << lp) - 1)) << lc) + ((output[at - 1] ?? 0) >> (8 - lc));
      output[at] = literal(decoder, LITERAL + 0x300 * literalState, state < 7 ? undefined : (output[at - rep0 - 1] ?? 0));
      at += 1;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let length: number;
    if (decoder.bit(IS_REP + state) === 0) {
      [rep3, rep2, rep1] = [rep2, rep1, rep0];
      length = decoder.length(LENGTH, positionState);
      state = state < 7 ? 7 : 10;
      rep0 = decoder.distance(length);
    } else {
      if (decoder.bit(IS_REP_G0 + state) === 0) {
        if (decoder.bit(IS_REP0_LONG + (state << 4) + positionState) === 0) {
          state = state < 7 ? 9 : 11;
          output[at] = output[at - rep0 - 1] ?? 0;
          at += 1;
          continue;
        }
      } else if (decoder.bit(IS_REP_G1 + state) === 0) [rep1, rep0] = [rep0, rep1];
      else if (decoder.bit(IS_REP_G2 + state) === 0) [rep2, rep1, rep0] = [rep1, rep0, rep2];
      else [rep3, rep2, rep1, rep0] = [rep2, rep1, rep0, rep3];
      length = decoder.length(REP_LENGTH, positionState);
      state = state < 7 ? 8 : 11;
    }
    if (rep0 >= at) throw new Error("the module in the page is damaged");
    for (const end = Math.min(at + length + 2, output.length); at < end; at++) output[at] = output[at - rep0 - 1] ?? 0;
  }
  return output;
}

/** A byte; after a match, the byte that would have followed it selects the probabilities. */
function literal(decoder: RangeDecoder, place: number, match: number | undefined): number {
  let symbol = 1;
  if (match !== undefined) {
    let expected = match;
    do {
      const matchBit = (expected >> 7) & 1;
      expected <<= 1;
      const bit = decoder.bit(place + ((1 + matchBit) << 8) + symbol);
      symbol = (symbol << 1) | bit;
      if (bit !== matchBit) break;
    } while (symbol < 0x100);
  }
  while (symbol < 0x100) symbol = (symbol << 1) | decoder.bit(place + symbol);
  return symbol - 0x100;
}
