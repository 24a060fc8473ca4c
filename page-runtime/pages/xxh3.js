// The checksum of .hvx files: XXH3 of 64 bits, of seed 0. What is long goes by halves of 32 bits, the rest by big numbers.
function makeXxh3() {
  const SECRET = Uint8Array.from((
    "b8fe6c3923a44bbe7c01812cf721ad1cded46de9839097db7240a4a4b7b3671fcb79e64eccc0e578825ad07dccff7221b8084674f743248ee03590e6813a264c" +
    "3c2852bb91c300cb88d0658b1b532ea371644897a20df94e3819ef46a9deacd8a8fa763fe39c343ff9dcbbc7c70b4f1d8a51e04bcdb45931c89f7ec9d9787364" +
    "eac5ac8334d3ebc3c581a0fffa1363eb170ddd51b7f0da49d316552629d4689e2b16be587d47a1fc8ff8b8d17ad031ce45cb3a8f95160428afd7fbcabb4b407e").match(/../g),
    byte => parseInt(byte, 16));
  const PRIME32 = [0x9e3779b1n, 0x85ebca77n, 0xc2b2ae3dn];
  const PRIME64 = [0x9e3779b185ebca87n, 0xc2b2ae3d27d4eb4fn, 0x165667b19e3779f9n, 0x85ebca77c2b2ae63n, 0x27d4eb2f165667c5n];
  const MIX = [0x165667919e3779f9n, 0x9fb21c651e98df25n];
  const STRIPE = 64, STRIPES_A_BLOCK = 16, BLOCK = STRIPE * STRIPES_A_BLOCK;

  const cut = number => BigInt.asUintN(64, number);
  const viewOf = bytes => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const secret = viewOf(SECRET), key = at => secret.getBigUint64(at, true);
  const folded = (a, b) => cut(a * b) ^ a * b >> 64n;
  const rotated = (number, by) => cut(number << by) | number >> 64n - by;
  const reversed = number => {
    const view = new DataView(new ArrayBuffer(8));
    view.setBigUint64(0, number, true);
    return view.getBigUint64(0, false);
  };
  const avalanche = hash => {
    hash = cut((hash ^ hash >> 37n) * MIX[0]);
    return hash ^ hash >> 32n;
  };
  const avalanche64 = hash => {
    hash = cut((hash ^ hash >> 33n) * PRIME64[1]);
    hash = cut((hash ^ hash >> 29n) * PRIME64[2]);
    return hash ^ hash >> 32n;
  };
  const pair = (view, at, keys) => folded(view.getBigUint64(at, true) ^ key(keys), view.getBigUint64(at + 8, true) ^ key(keys + 8));

  function ofFew(view, size) {
    if (size === 0) return avalanche64(key(56) ^ key(64));
    if (size < 4) {
      const mixed = view.getUint8(0) << 16 | view.getUint8(size >> 1) << 24 | view.getUint8(size - 1) | size << 8;
      return avalanche64(BigInt((mixed ^ secret.getUint32(0, true) ^ secret.getUint32(4, true)) >>> 0));
    }
    if (size < 9) {
      let hash = (BigInt(view.getUint32(size - 4, true)) + (BigInt(view.getUint32(0, true)) << 32n)) ^ key(8) ^ key(16);
      hash = cut((hash ^ rotated(hash, 49n) ^ rotated(hash, 24n)) * MIX[1]);
      hash = cut((hash ^ (hash >> 35n) + BigInt(size)) * MIX[1]);
      return hash ^ hash >> 28n;
    }
    const low = view.getBigUint64(0, true) ^ key(24) ^ key(32), high = view.getBigUint64(size - 8, true) ^ key(40) ^ key(48);
    return avalanche(cut(BigInt(size) + reversed(low) + high + folded(low, high)));
  }

  function ofSome(view, size) {
    let hash = BigInt(size) * PRIME64[0];
    if (size <= 128) {
      for (let i = size - 1 >> 5; i >= 0; i--) hash += pair(view, 16 * i, 32 * i) + pair(view, size - 16 * (i + 1), 32 * i + 16);
      return avalanche(cut(hash));
    }
    for (let i = 0; i < 8; i++) hash += pair(view, 16 * i, 16 * i);
    hash = avalanche(cut(hash));
    for (let i = 8; i < size >> 4; i++) hash += pair(view, 16 * i, 16 * (i - 8) + 3);
    return avalanche(cut(hash + pair(view, size - 16, 119)));
  }

  // Keys as words, from each place in the secret that a stripe takes them from.
  const keysAt = at => new Uint32Array(SECRET.slice(at, at + STRIPE).buffer);
  const stripeKeys = Array.from({ length: STRIPES_A_BLOCK }, (_, i) => keysAt(8 * i));
  const scrambleKeys = keysAt(128), lastKeys = keysAt(121);

  // Eight sums of 64 bits, low word first.
  function accumulate(sums, words, at, keys) {
    for (let i = 0; i < 16; i += 2) {
      const low = words[at + i], high = words[at + i + 1];
      const a = (low ^ keys[i]) >>> 0, b = (high ^ keys[i + 1]) >>> 0;
      // The lower word of the product is exact, and what is left of it is a multiple of 2^32, but for roundings.
      const lower = Math.imul(a, b) >>> 0, upper = (a * b - lower) * 2 ** -32 + 0.5 >>> 0;
      const own = sums[i] + lower, other = sums[i ^ 2] + low;
      sums[i + 1] += upper + (own > 4294967295);
      sums[i] = own;
      sums[(i ^ 2) + 1] += high + (other > 4294967295);
      sums[i ^ 2] = other;
    }
  }

  function scramble(sums) {
    const prime = Number(PRIME32[0]);
    for (let i = 0; i < 16; i += 2) {
      const low = (sums[i] ^ sums[i + 1] >>> 15 ^ scrambleKeys[i]) >>> 0, high = (sums[i + 1] ^ scrambleKeys[i + 1]) >>> 0;
      const lower = Math.imul(low, prime) >>> 0;
      sums[i] = lower;
      sums[i + 1] = Math.imul(high, prime) + ((low * prime - lower) * 2 ** -32 + 0.5 >>> 0);
    }
  }

  function ofMany(bytes) {
    const size = bytes.length, sums = new Uint32Array(16), wide = new DataView(sums.buffer);
    [PRIME32[2], PRIME64[0], PRIME64[1], PRIME64[2], PRIME64[3], PRIME32[1], PRIME64[4], PRIME32[0]]
      .forEach((prime, i) => wide.setBigUint64(8 * i, prime, true));
    const whole = size & ~3, words = new Uint32Array(bytes.byteOffset & 3 ? bytes.slice(0, whole).buffer : bytes.buffer,
      bytes.byteOffset & 3 ? 0 : bytes.byteOffset, whole / 4);
    const stripes = Math.floor((size - 1) / STRIPE);
    for (let stripe = 0; stripe < stripes; stripe++) {
      accumulate(sums, words, stripe * STRIPE / 4, stripeKeys[stripe % STRIPES_A_BLOCK]);
      if (stripe % STRIPES_A_BLOCK === STRIPES_A_BLOCK - 1) scramble(sums);
    }
    accumulate(sums, new Uint32Array(bytes.slice(size - STRIPE).buffer), 0, lastKeys);
    let hash = BigInt(size) * PRIME64[0];
    for (let i = 0; i < 4; i++)
      hash += folded(wide.getBigUint64(16 * i, true) ^ key(11 + 16 * i), wide.getBigUint64(16 * i + 8, true) ^ key(19 + 16 * i));
    return avalanche(cut(hash));
  }

  return bytes => bytes.length <= 16 ? ofFew(viewOf(bytes), bytes.length) : bytes.length <= 240 ? ofSome(viewOf(bytes), bytes.length) : ofMany(bytes);
}
