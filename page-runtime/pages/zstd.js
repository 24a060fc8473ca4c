// One frame of zstd (RFC 8878) that states its size and needs no dictionary, as .hvx files store pages.
function makeZstd() {
  const LENGTHS = { // Of literals and of matches: where the codes that have more bits begin, and how many.
    literal: [[16, 18, 20, 22, 24, 28, 32, 40, 48, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768, 65536],
      [1, 1, 1, 1, 2, 2, 3, 3, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]],
    match: [[35, 37, 39, 41, 43, 47, 51, 59, 67, 83, 99, 131, 259, 515, 1027, 2051, 4099, 8195, 16387, 32771, 65539],
      [1, 1, 1, 1, 2, 2, 3, 3, 4, 4, 5, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]],
  };
  const MOST_OFFSET_BITS = 24;
  const damaged = () => { throw new Error("not a frame of zstd"); };
  const log2 = number => 31 - Math.clz32(number);
  const codes = ([bases, bits], plain, first) => ({
    base: Uint32Array.from([...Array(plain).keys()].map(code => code + first).concat(bases)),
    bits: Uint8Array.from([...Array(plain).fill(0), ...bits]),
  });
  const literalCodes = codes(LENGTHS.literal, 16, 0), matchCodes = codes(LENGTHS.match, 32, 3);

  // Bits from the end of a range of bytes to its beginning; below the highest bit that is set.
  class Bits {
    constructor(bytes, from, to) {
      if (to <= from || !bytes[to - 1]) damaged();
      this.bytes = bytes;
      this.from = 8 * from;
      this.at = 8 * (to - 1) + log2(bytes[to - 1]);
    }
    // At most 24.
    peek(count, at = this.at - count) {
      const { bytes } = this, i = at >> 3;
      return (bytes[i] | bytes[i + 1] << 8 | bytes[i + 2] << 16 | bytes[i + 3] << 24) >>> (at & 7) & (1 << count) - 1;
    }
    read(count) {
      this.at -= count;
      return this.peek(0 + count, this.at);
    }
    left() { return this.at - this.from; }
  }

  // A table of states: the symbol of each, how many bits lead to the next, and from where they count.
  function statesOf(shares, log2Size) {
    const size = 1 << log2Size, symbol = new Uint8Array(size), bits = new Uint8Array(size), base = new Uint16Array(size);
    const next = shares.map(share => Math.abs(share));
    let rare = size;
    shares.forEach((share, i) => { if (share < 0) symbol[--rare] = i; });
    let at = 0;
    shares.forEach((share, i) => {
      for (let k = 0; k < share; k++) {
        symbol[at] = i;
        do at = at + (size >> 1) + (size >> 3) + 3 & size - 1; while (at >= rare);
      }
    });
    for (let state = 0; state < size; state++) {
      const count = next[symbol[state]]++;
      bits[state] = log2Size - log2(count);
      base[state] = (count << bits[state]) - size;
    }
    return { symbol, bits, base, log2Size };
  }

  const only = symbol => ({ symbol: Uint8Array.of(symbol), bits: Uint8Array.of(0), base: Uint16Array.of(0), log2Size: 0 });

  // Reads how often symbols are; gives their states, and leaves `place.at` behind it.
  function readStates(bytes, place, mostLog2, mostSymbol) {
    let at = 8 * place.at;
    const forward = count => {
      const i = at >> 3;
      return (bytes[i] | bytes[i + 1] << 8 | bytes[i + 2] << 16) >>> (at & 7) & (1 << count) - 1;
    };
    const log2Size = forward(4) + 5, shares = [];
    at += 4;
    if (log2Size > mostLog2) damaged();
    for (let left = 1 << log2Size; left > 0;) {
      const count = log2(left + 1) + 1, lower = (1 << count - 1) - 1, surplus = (1 << count) - 2 - left;
      let value = forward(count);
      if ((value & lower) < surplus) {
        value &= lower;
        at += count - 1;
      } else {
        if (value > lower) value -= surplus;
        at += count;
      }
      shares.push(value - 1);
      left -= Math.abs(value - 1);
      for (let more = value === 1 ? 3 : 0; more === 3;) {
        more = forward(2);
        at += 2;
        for (let i = 0; i < more; i++) shares.push(0);
      }
      if (left < 0 || shares.length > mostSymbol + 1) damaged();
    }
    place.at = at + 7 >> 3;
    return statesOf(shares, log2Size);
  }

  // The lengths of codes, as weights: by a table of states, or four bits each.
  function readWeights(bytes, place) {
    const head = bytes[place.at++], weights = [];
    if (head > 127) {
      for (let i = 0; i < head - 127; i++) weights.push(i & 1 ? bytes[place.at + (i >> 1)] & 15 : bytes[place.at + (i >> 1)] >> 4);
      place.at += head - 126 >> 1;
      return weights;
    }
    const end = place.at + head, states = readStates(bytes, place, 6, 255), bits = new Bits(bytes, place.at, end);
    let state = bits.read(states.log2Size), other = bits.read(states.log2Size);
    while (weights.length < 256) {
      weights.push(states.symbol[state]);
      state = states.base[state] + bits.read(states.bits[state]);
      if (bits.left() < 0) {
        weights.push(states.symbol[other]);
        break;
      }
      [state, other] = [other, state];
    }
    place.at = end;
    return weights;
  }

  // A table of all words of as many bits as the longest code has: the symbol and the length, in one number.
  function readCodes(bytes, place) {
    const weights = readWeights(bytes, place);
    const sum = weights.reduce((sum, weight) => sum + (weight && 1 << weight - 1), 0), longest = log2(sum) + 1;
    const left = (1 << longest) - sum;
    if (!sum || longest > 11 || left & left - 1) damaged();
    weights.push(log2(left) + 1);
    const table = new Uint16Array(1 << longest);
    for (let weight = 1, at = 0; weight <= longest; weight++)
      weights.forEach((own, symbol) => {
        if (own === weight) table.fill(symbol << 4 | longest + 1 - weight, at, at += 1 << weight - 1);
      });
    return { table, longest };
  }

  function readCoded({ table, longest }, bytes, from, to, out, first, end) {
    const bits = new Bits(bytes, from, to), mask = (1 << longest) - 1;
    let at = bits.at - longest;
    for (let i = first; i < end; i++) {
      const byte = at >> 3, entry = table[(bytes[byte] | bytes[byte + 1] << 8 | bytes[byte + 2] << 16) >>> (at & 7) & mask];
      out[i] = entry >> 4;
      at -= entry & 15;
    }
    if (at + longest !== bits.from) damaged();
  }

  function readLiterals(bytes, place, kept, size) {
    const head = bytes[place.at], kind = head & 3, form = head >> 2 & 3;
    const number = (count, shift) => {
      let value = 0;
      for (let i = count - 1; i >= 0; i--) value = value * 256 + bytes[place.at + i];
      place.at += count;
      return Math.floor(value / 2 ** shift);
    };
    if (kind < 2) {
      const count = form === 1 ? number(2, 4) : form === 3 ? number(3, 4) : number(1, 3);
      if (count > size) damaged();
      const from = place.at;
      place.at += kind ? 1 : count;
      return kind ? new Uint8Array(count).fill(bytes[from]) : bytes.subarray(from, place.at);
    }
    const width = [10, 10, 14, 18][form], both = number([3, 3, 4, 5][form], 4);
    const count = both % 2 ** width, end = place.at + Math.floor(both / 2 ** width);
    if (count > size || end > place.end) damaged();
    if (kind === 2) kept.codes = readCodes(bytes, place);
    if (!kept.codes) damaged();
    const literals = new Uint8Array(count);
    if (form === 0) {
      readCoded(kept.codes, bytes, place.at, end, literals, 0, count);
    } else {
      const part = count + 3 >> 2;
      let from = place.at + 6;
      for (let i = 0; i < 4; i++) {
        const to = i < 3 ? from + (bytes[place.at + 2 * i] | bytes[place.at + 2 * i + 1] << 8) : end;
        if (to > end) damaged();
        readCoded(kept.codes, bytes, from, to, literals, i * part, i < 3 ? (i + 1) * part : count);
        from = to;
      }
    }
    place.at = end;
    return literals;
  }

  const often = (text, rare) => [...text].map(Number).concat(Array(rare).fill(-1));
  const KINDS = [ // Of sequences: their states if nothing is said, and the bounds of others.
    { name: "literal", predefined: statesOf(often("43222222222221112222222223211111", 4), 6), mostLog2: 9, mostSymbol: 35 },
    { name: "offset", predefined: statesOf(often("111111222111111111111111", 5), 5), mostLog2: 8, mostSymbol: 31 },
    { name: "match", predefined: statesOf(often("1432222221111111111111111111111111111111111111", 7), 6), mostLog2: 9, mostSymbol: 52 },
  ];

  function readSequences(bytes, place, kept, literals, out, at) {
    let count = bytes[place.at++], taken = 0;
    if (count > 127) count = count < 255 ? (count - 128 << 8) + bytes[place.at++] : bytes[place.at++] + (bytes[place.at++] << 8) + 0x7f00;
    const put = (from, to) => {
      if (to > literals.length || at + to - from > out.length) damaged();
      for (let i = from; i < to; i++) out[at++] = literals[i];
    };
    if (count) {
      const modes = bytes[place.at++];
      KINDS.forEach(({ name, predefined, mostLog2, mostSymbol }, i) => {
        const mode = modes >> 6 - 2 * i & 3;
        if (mode === 0) kept[name] = predefined;
        else if (mode === 1) kept[name] = only(bytes[place.at++]);
        else if (mode === 2) kept[name] = readStates(bytes, place, mostLog2, mostSymbol);
        if (!kept[name]) damaged();
      });
      const { literal, offset, match, recent } = kept, bits = new Bits(bytes, place.at, place.end);
      let l = bits.read(literal.log2Size), o = bits.read(offset.log2Size), m = bits.read(match.log2Size);
      for (let i = 0; i < count; i++) {
        const offsetBits = offset.symbol[o], literalCode = literal.symbol[l], matchCode = match.symbol[m];
        if (offsetBits > MOST_OFFSET_BITS || literalCode > 35 || matchCode > 52) damaged();
        const value = (1 << offsetBits) + bits.read(offsetBits);
        const length = matchCodes.base[matchCode] + bits.read(matchCodes.bits[matchCode]);
        const before = literalCodes.base[literalCode] + bits.read(literalCodes.bits[literalCode]);
        put(taken, taken += before);
        const which = value > 3 ? 3 : before ? value - 1 : value;
        const far = value > 3 ? value - 3 : which < 3 ? recent[which] : recent[0] - 1;
        if (which > 1) recent[2] = recent[1];
        if (which > 0) recent[1] = recent[0];
        recent[0] = far;
        if (far < 1 || far > at || at + length > out.length) damaged();
        for (const end = at + length; at < end; at++) out[at] = out[at - far];
        if (i === count - 1) break;
        l = literal.base[l] + bits.read(literal.bits[l]);
        m = match.base[m] + bits.read(match.bits[m]);
        o = offset.base[o] + bits.read(offset.bits[o]);
        if (bits.left() < 0) damaged();
      }
      if (bits.left() !== 0) damaged();
    }
    put(taken, literals.length);
    return at;
  }

  // The bytes of a frame of exactly `size`.
  return (frame, size) => {
    // Bits are read in threes and fours of bytes.
    const bytes = new Uint8Array(frame.length + 4), out = new Uint8Array(size);
    bytes.set(frame);
    const view = new DataView(bytes.buffer), head = bytes[4], isSingle = head >> 5 & 1, log2Stated = head >> 6;
    if (view.getUint32(0, true) !== 0xfd2fb528 || head & 11) damaged();
    let at = 6 - isSingle;
    const stated = log2Stated ? [0, view.getUint16(at, true) + 256, view.getUint32(at, true), Number(view.getBigUint64(at, true))][log2Stated]
      : isSingle ? bytes[at] : size;
    at += log2Stated ? 1 << log2Stated : isSingle;
    if (stated !== size) damaged();
    const kept = { recent: [1, 4, 8] };
    let done = 0;
    for (let isLast = false; !isLast;) {
      const block = view.getUint32(at, true) & 0xffffff, kind = block >> 1 & 3, length = block >> 3;
      isLast = block & 1;
      at += 3;
      const end = at + (kind === 1 ? 1 : length);
      if (end > frame.length || kind === 3 || kind < 2 && done + length > size) damaged();
      if (kind === 2) {
        const place = { at, end }, literals = readLiterals(bytes, place, kept, size);
        done = readSequences(bytes, place, kept, literals, out, done);
      } else {
        if (kind) out.fill(bytes[at], done, done + length);
        else out.set(bytes.subarray(at, end), done);
        done += length;
      }
      at = end;
    }
    if (done !== size || at + 4 * (head >> 2 & 1) !== frame.length) damaged();
    return out;
  };
}
