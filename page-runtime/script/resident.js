// All words of the volume, in one texture.
const volume = (() => {
  const texture = wordTexture(words);
  return { isStreamed: false, prelude: shaders["words.glsl"], bind: program => program.texture("words", texture, 0) };
})();
