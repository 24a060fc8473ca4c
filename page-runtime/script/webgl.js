// Drawing by WebGL 2.

function makeWebGl() {
  const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, powerPreference: "high-performance" });
  if (!gl) throw new Error("this browser has no WebGL 2");
  const parallel = gl.getExtension("KHR_parallel_shader_compile"), language = "essl", texts = shaders[language], most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  const PLACES_A_ROW = 4096;
  canvas.addEventListener("webglcontextlost", lossOf(canvas));

  // Waits until the device has done all that it was told, and tells how long that took in milliseconds.
  async function finished() {
    const begin = performance.now();
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) await sleep(1);
    gl.deleteSync(fence);
    return performance.now() - begin;
  }

  function shader(kind, text) {
    const made = gl.createShader(kind);
    gl.shaderSource(made, text);
    gl.compileShader(made);
    return made;
  }

  function constants() {
    const planes = scene.cuts.map(plane => `vec4(${plane.map(number => number.toExponential())})`);
    return `const bool IS_LABEL = ${scene.labels};\nconst vec3 SPACING = vec3(${scene.spacing});\n${volume.constants}` +
      (planes.length ? `const int PLANE_COUNT = ${planes.length};\nconst vec4 PLANES[] = vec4[](${planes});\n` : "");
  }

  // The program of a pass; `functions` are those of the kernel. The page goes on while it is compiled.
  async function programOf(name, functions) {
    const { traces } = PASSES[name], textures = [...PASSES[name].textures, ...traces ? volume.textures : []];
    const fragment = texts.begin + shaders.given + "uniform Given given;\n" + textures.map(name => `uniform highp usampler2D ${name};\n`).join("") +
      (traces ? constants() + texts.words + functions : "") + texts[name];
    const made = gl.createProgram(), stages = [shader(gl.VERTEX_SHADER, texts.vertex), shader(gl.FRAGMENT_SHADER, fragment)];
    for (const stage of stages) gl.attachShader(made, stage);
    gl.linkProgram(made);
    while (parallel && !gl.getProgramParameter(made, parallel.COMPLETION_STATUS_KHR) && !gl.isContextLost()) await sleep(10);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS))
      throw new Error("a shader was refused: " + (gl.getShaderInfoLog(stages[1]) || gl.getProgramInfoLog(made)));
    const places = {}, placeOf = name => places[name] ??= gl.getUniformLocation(made, name);
    // Draws some rows of a target.
    return programFor(function (target, first = 0, rows = target.height) {
      gl.useProgram(made);
      for (const name in this.given) gl["uniform" + givenMembers[name].setter](placeOf("given." + name), ...[].concat(this.given[name]));
      textures.forEach((name, unit) => {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, this.taken[name] ?? null);
        gl.uniform1i(placeOf(name), unit);
      });
      gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
      gl.viewport(0, 0, target.width, target.height);
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(0, first, target.width, rows);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    });
  }

  function textureOf(format, width, height) {
    const texture = Object.assign(gl.createTexture(), { width, height });
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
    return texture;
  }

  // Writes words into a part of a texture, one or four a place.
  function write(texture, x, y, width, height, channels, words) {
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, x, y, width, height, channels === 1 ? gl.RED_INTEGER : gl.RGBA_INTEGER, gl.UNSIGNED_INT, words);
  }

  // A texture of unsigned integers, one or four a place; `words` fills it from its first row on.
  function integers(width, height, channels, words) {
    const texture = textureOf(channels === 1 ? gl.R32UI : gl.RGBA32UI, width, height);
    const row = width * channels, whole = words ? Math.floor(words.length / row) : 0;
    if (whole) write(texture, 0, 0, width, whole, channels, words);
    if (words && words.length > whole * row) {
      const rest = new Uint32Array(row);
      rest.set(words.subarray(whole * row));
      write(texture, 0, whole, width, 1, channels, rest);
    }
    return texture;
  }

  function targetOf(...textures) {
    const framebuffer = gl.createFramebuffer(), [{ width, height }] = textures;
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    textures.forEach((texture, i) => gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0));
    gl.drawBuffers(textures.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
    return { framebuffer, width, height };
  }

  // What stands in a texture of a target, once the device has drawn it: words, four a place, or bytes.
  async function contentsOf(target, attachment = 0, isBytes = false) {
    const { width, height } = target, contents = new (isBytes ? Uint8Array : Uint32Array)(4 * width * height), buffer = gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.bufferData(gl.PIXEL_PACK_BUFFER, contents.byteLength, gl.STREAM_READ);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
    gl.readBuffer(gl.COLOR_ATTACHMENT0 + attachment);
    gl.readPixels(0, 0, width, height, isBytes ? gl.RGBA : gl.RGBA_INTEGER, isBytes ? gl.UNSIGNED_BYTE : gl.UNSIGNED_INT, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    await finished();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, contents);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.deleteBuffer(buffer);
    return contents;
  }

  // A picture of a target, rows from the top.
  async function pictureOf(target) {
    const rows = await contentsOf(target, 0, true), picture = new Uint8Array(rows.length), { width, height } = target;
    for (let row = 0; row < height; row++) picture.set(rows.subarray(4 * width * row, 4 * width * (row + 1)), 4 * width * (height - 1 - row));
    return picture;
  }

  // Has the device hold the words of the volume.
  function hold(words) {
    const rows = Math.ceil(words.length / PLACES_A_ROW);
    if (rows > most || PLACES_A_ROW > most)
      throw new Error(`the volume has ${words.length} words, and this device holds ${Math.min(most, PLACES_A_ROW) * most}`);
    const texture = integers(PLACES_A_ROW, rows, 1, words);
    return { textures: ["words"], constants: "", bind: program => program.take({ words: texture }),
      showRoot: root => write(texture, 0, 0, 1, 1, 1, new Uint32Array([root])) };
  }

  return {
    name: "WebGL 2", language, most, PLACES_A_ROW, finished, programOf, write, integers, targetOf, contentsOf, pictureOf, hold,
    bytes: (width, height) => textureOf(gl.RGBA8, width, height),
    screen: { framebuffer: null, get width() { return canvas.width; }, get height() { return canvas.height; } },
    free: (...things) => things.forEach(thing => thing?.framebuffer ? gl.deleteFramebuffer(thing.framebuffer) : gl.deleteTexture(thing ?? null)),
  };
}
