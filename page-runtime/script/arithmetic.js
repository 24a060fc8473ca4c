// Whether this device adds, multiplies and inverts float32 numbers within the bounds on which exact hits stand.

const noise = number => {
  for (let i = 0; i < 3; i++) number = Math.imul(number ^ number >>> 15, 0x9e3779b1) + 1;
  return (number ^ number >>> 15) >>> 0;
};

async function isArithmeticSound() {
  const side = 32, pairs = new Uint32Array(4 * side * side);
  for (let i = 0; i < pairs.length; i++) {
    // Of magnitudes from 2^-20 to 2^20, and of either sign.
    const bits = noise(i);
    pairs[i] = (bits & 0x807fffff | 107 + (noise(~i) % 41) << 23) >>> 0;
  }
  const program = await programOf(shaders["arithmetic.frag"]);
  const [sums, others] = [integers(side, side, 4), integers(side, side, 4)];
  const target = framebuffer(sums, others), given = integers(side, side, 4, pairs);
  program.use().texture("pairs", given, 0);
  draw(target, side, side);
  const sumBits = await contentsOf(target, side, side, 0), otherBits = await contentsOf(target, side, side, 1);
  const told = new Float32Array(sumBits.buffer), numbers = new Float32Array(pairs.buffer);
  gl.deleteFramebuffer(target);
  for (const texture of [sums, others, given]) gl.deleteTexture(texture);
  const isNear = (told, exact, roundings) => Math.abs(told - exact) <= Math.abs(exact) * roundings / 8388608;
  let isSound = true;
  for (let i = 0; i < pairs.length; i += 4) {
    const [a, b] = [numbers[i], numbers[i + 1]], [floor] = new Uint32Array(Float32Array.of(Math.floor(a)).buffer);
    isSound &&= isNear(told[i], a + b, 1) && isNear(told[i + 1], a - b, 1) &&
      isNear(told[i + 2], a * b, 1) && isNear(told[i + 3], 1 / b, 2.5) &&
      otherBits[i] === floor && otherBits[i + 1] === pairs[i] && otherBits[i + 2] === Math.imul(pairs[i], pairs[i + 1]) >>> 0 &&
      otherBits[i + 3] | 0 === Math.floor(a);
  }
  return isSound;
}
