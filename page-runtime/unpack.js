// From the text of the page to its script and the words of the volume.
(async () => {
  const status = document.getElementById("status");
  try {
    const text = document.getElementById("packed").textContent;
    // A character below 128 is seven bits; others are one that HTML would change, and the seven bits behind it.
    const bytes = new Uint8Array(Math.ceil(text.length * 14 / 8));
    let size = 0, held = 0, bits = 0;
    const put = seven => {
      held = held << 7 & 0x3fff | seven;
      bits += 7;
      if (bits >= 8) bytes[size++] = held >> (bits -= 8);
    };
    for (let i = 0; i < text.length; i++) {
      const code = text.charCodeAt(i);
      if (code < 128) put(code);
      else {
        put([0, 13, 60][code - 256 >> 7]);
        put(code & 127);
      }
    }
    const stream = new Blob([bytes.subarray(0, ${BYTES})]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    const whole = new Uint8Array(await new Response(stream).arrayBuffer());
    const script = new TextDecoder().decode(whole.subarray(0, ${SCRIPT_BYTES}));
    // The bytes of rank 0 of a block of words, then those of rank 1 and so on.
    const words = new Uint32Array(${WORDS}), block = ${BLOCK_WORDS};
    let from = ${SCRIPT_BYTES};
    for (let first = 0; first < words.length; first += block) {
      const count = Math.min(block, words.length - first);
      for (let rank = 0; rank < 4; rank++)
        for (let i = 0; i < count; i++) words[first + i] |= whole[from + rank * count + i] << 8 * rank;
      from += 4 * count;
    }
    const checks = whole.subarray(from);
    const Asynchronous = (async () => {}).constructor;
    await new Asynchronous("words", "checks", "status", script + "\n//# sourceURL=voxc.js")(words, checks, status);
  } catch (problem) {
    status.textContent = "This page cannot be shown here: " + (problem.message || problem);
    document.documentElement.dataset.problem = problem.message || problem;
    throw problem;
  }
})();
