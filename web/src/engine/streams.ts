// The code of a WebAssembly module as streams of bytes that are alike: operators, numbers of locals, offsets, constants by their use. LZMA, which
// predicts a byte from those before it, makes that an eighth smaller than the code as it stands. Hints of alignment, which change no result, and
// the sizes of functions, which are counted again, are left out.

const enum Stream {
  Operators,
  Types,
  Labels,
  Locals,
  Declarations,
  Loads,
  Stores,
  Added,
  Passed,
  Stored,
  First,
  Constants,
  Calls,
  Globals,
  Long,
  Floats,
  Count,
}

/** Numbers of 32 bits before the streams: lengths of the module and of what precedes its functions, their number, and the lengths of the streams. */
const HEADER = 3 + Stream.Count;
/** Most bytes of a number of 32 bits. */
const LONGEST = 5;

/** Moves the bytes of functions from one form to the other. */
interface Mover {
  /** Moves a number of this stream, seven bits in a byte, and returns it. */
  number(stream: Stream): number;
  /** Moves as many bytes of this stream. */
  bytes(stream: Stream, count: number): void;
  operator(): number;
  /** The operator after a number that is still to be moved. */
  following(): number;
  alignment(): void;
}

/** The module of such streams. */
export function joined(split: Uint8Array): Uint8Array<ArrayBuffer> {
  const [length = 0, before = 0, functions = 0, ...lengths] = new Uint32Array(split.slice(0, 4 * HEADER).buffer);
  let end = 4 * HEADER;
  const places = Uint32Array.from(lengths, (length) => (end += length) - length);
  const made = new Uint8Array(length + LONGEST);
  made.set(split.subarray(end, end + before));
  let at = before;
  const mover: Mover = {
    number(stream) {
      let from = places[stream]!;
      for (let [value, shift] = [0, 0]; ; shift += 7) {
        const byte = (made[at++] = split[from++]!);
        value |= (byte & 127) << shift;
        if (byte < 128) {
          places[stream] = from;
          return value;
        }
      }
    },
    bytes(stream, count) {
      while (count-- > 0) made[at++] = split[places[stream]!++]!;
    },
    operator: () => (made[at++] = split[places[Stream.Operators]!++]!),
    following: () => split[places[Stream.Operators]!]!,
    alignment: () => (made[at++] = 0),
  };
  for (let count = functions; count > 0; count--) {
    const start = at;
    at += LONGEST;
    moveFunction(mover);
    let size = at - start - LONGEST;
    made.copyWithin(start + bytesOf(size), start + LONGEST, at);
    at = start + bytesOf(size) + size;
    let to = start;
    for (; size > 127; size >>>= 7) made[to++] = (size & 127) | 128;
    made[to] = size;
  }
  made.set(split.subarray(end + before), at);
  return made.subarray(0, length);
}

/** The streams of a module, for the build of the page; fails at an operator that is not listed below. */
export function split(module: Uint8Array): Uint8Array {
  const CODE = 10;
  const streams = Array.from({ length: Stream.Count }, (): number[] => []);
  // After the magic number and the version.
  let at = 8;
  const number = (): number => {
    for (let [value, factor] = [0, 1]; ; factor *= 128) {
      const byte = module[at++]!;
      value += (byte & 127) * factor;
      if (byte < 128) return value;
    }
  };
  for (let kind = module[at++], size = number(); kind !== CODE; kind = module[at++], size = number()) at += size;
  const functions = number();
  const before = at;
  const mover: Mover = {
    number(stream) {
      const from = at;
      const value = number();
      streams[stream]!.push(...module.subarray(from, at));
      return value;
    },
    bytes(stream, count) {
      while (count-- > 0) streams[stream]!.push(module[at++]!);
    },
    operator() {
      streams[Stream.Operators]!.push(module[at]!);
      return module[at++]!;
    },
    following() {
      let next = at;
      while (module[next++]! > 127);
      return module[next]!;
    },
    alignment: () => at++,
  };
  for (let count = functions; count > 0; count--) {
    const size = number();
    const end = at + size;
    moveFunction(mover);
    if (at !== end) throw new Error(`a function ends at ${at} in place of ${end}`);
  }
  const header = new Uint32Array([module.length, before, functions, ...streams.map((stream) => stream.length)]);
  const parts = [new Uint8Array(header.buffer), ...streams, module.subarray(0, before), module.subarray(at)];
  const made = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  parts.reduce((to, part) => (made.set(part, to), to + part.length), 0);
  return made;
}

function bytesOf(size: number): number {
  return size < 128 ? 1 : 1 + bytesOf(size >>> 7);
}

/** Moves a function: its locals, and operators with their immediate values to the end of the outermost block (WebAssembly 2.0, section 5.4). */
function moveFunction(mover: Mover): void {
  for (let groups = mover.number(Stream.Declarations); groups > 0; groups--) {
    mover.number(Stream.Declarations);
    mover.bytes(Stream.Declarations, 1);
  }
  for (let depth = 1; depth > 0; ) {
    const operator = mover.operator();
    if (operator >= 0x20 && operator <= 0x22) mover.number(Stream.Locals);
    else if (operator >= 0x45 && operator <= 0xc4) continue;
    else if (operator === 0x41) mover.number(use(mover.following()));
    else if (operator >= 0x28 && operator <= 0x3e) {
      mover.alignment();
      mover.number(operator < 0x36 ? Stream.Loads : Stream.Stores);
    } else if (operator === 0x0b) depth--;
    else if (operator >= 0x02 && operator <= 0x04) {
      depth++;
      mover.number(Stream.Types);
    } else if (operator === 0x0c || operator === 0x0d) mover.number(Stream.Labels);
    else if (operator === 0x0e) {
      for (let labels = mover.number(Stream.Labels); labels >= 0; labels--) mover.number(Stream.Labels);
    } else if (operator === 0x10) mover.number(Stream.Calls);
    else if (operator === 0x11) {
      mover.number(Stream.Globals);
      mover.number(Stream.Globals);
    } else if (operator === 0x1c) mover.bytes(Stream.Types, mover.number(Stream.Types));
    else if (operator === 0x23 || operator === 0x24) mover.number(Stream.Globals);
    else if (operator === 0x3f || operator === 0x40) mover.bytes(Stream.Types, 1);
    else if (operator === 0x42) mover.number(Stream.Long);
    else if (operator === 0x43) mover.bytes(Stream.Floats, 4);
    else if (operator === 0x44) mover.bytes(Stream.Floats, 8);
    else if (operator === 0xfc) {
      // Conversions have no further values, memory.copy has two, memory.fill one.
      const kind = mover.number(Stream.Types);
      if (kind > 7 && kind !== 10 && kind !== 11) throw new Error(`operator 0xfc ${kind}`);
      mover.bytes(Stream.Types, kind === 10 ? 2 : kind === 11 ? 1 : 0);
    } else if (![0x00, 0x01, 0x05, 0x0f, 0x1a, 0x1b].includes(operator)) throw new Error(`operator ${operator}`);
  }
}

/** The stream of a constant with this operator after it. */
function use(next: number): Stream {
  if (next === 0x6a) return Stream.Added;
  if (next === 0x10) return Stream.Passed;
  if (next >= 0x36 && next <= 0x3e) return Stream.Stored;
  return next === 0x20 || next === 0x41 ? Stream.First : Stream.Constants;
}
