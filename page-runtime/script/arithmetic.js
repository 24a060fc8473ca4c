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
  const program = await device.programOf("arithmetic"), given = device.integers(side, side, 4, pairs);
  const [sums, others] = [device.integers(side, side, 4), device.integers(side, side, 4)], target = device.targetOf(sums, others);
  program.take({ pairs: given }).draw(target);
  const sumBits = await device.contentsOf(target, 0), otherBits = await device.contentsOf(target, 1);
  const told = new Float32Array(sumBits.buffer), numbers = new Float32Array(pairs.buffer);
  device.free(target, sums, others, given);
  const isNear = (told, exact, roundings) => Math.abs(told - exact) <= Math.abs(exact) * roundings / 8388608;
  let isSound = true;
  for (let i = 0; i < pairs.length; i += 4) {
    const [a, b] = [numbers[i], numbers[i + 1]], [floor] = new Uint32Array(Float32Array.of(Math.floor(a)).buffer);
    isSound &&= isNear(told[i], a + b, 1) && isNear(told[i + 1], a - b, 1) &&
      isNear(told[i + 2], a * b, 1) && isNear(told[i + 3], 1 / b, 2.5) &&
      otherBits[i] === floor && otherBits[i + 1] === pairs[i] && otherBits[i + 2] === Math.imul(pairs[i], pairs[i + 1]) >>> 0 &&
      (otherBits[i + 3] | 0) === Math.floor(a);
  }
  return isSound;
}
