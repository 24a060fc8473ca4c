// The graphics device: programs, textures of integers, and waiting for what it does.

const canvas = document.querySelector("canvas");
const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, powerPreference: "high-performance" });
if (!gl) throw new Error("this browser has no WebGL 2");
const parallel = gl.getExtension("KHR_parallel_shader_compile");
const PLACES_A_ROW = 4096;

const sleep = milliseconds => new Promise(done => setTimeout(done, milliseconds));
const nextFrame = () => new Promise(requestAnimationFrame);

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

// A program that draws a whole picture by this fragment shader. The page goes on while it is compiled.
async function programOf(fragment) {
  const program = gl.createProgram(), stages = [shader(gl.VERTEX_SHADER, shaders["all.vert"]), shader(gl.FRAGMENT_SHADER, fragment)];
  for (const stage of stages) gl.attachShader(program, stage);
  gl.linkProgram(program);
  while (parallel && !gl.getProgramParameter(program, parallel.COMPLETION_STATUS_KHR) && !gl.isContextLost()) await sleep(10);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS))
    throw new Error("a shader was refused: " + (gl.getShaderInfoLog(stages[1]) || gl.getProgramInfoLog(program)));
  const places = {};
  return {
    use() { gl.useProgram(program); return this; },
    set(kind, name, ...values) {
      places[name] ??= gl.getUniformLocation(program, name);
      gl["uniform" + kind](places[name], ...values);
      return this;
    },
    // Binds a texture to a sampler, by its number.
    texture(name, texture, unit) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      return this.set("1i", name, unit);
    },
  };
}

// A texture of unsigned integers, one or four a place; `words` fills it from its first row on.
function integers(width, height, channels, words) {
  const texture = gl.createTexture(), format = channels === 1 ? gl.RED_INTEGER : gl.RGBA_INTEGER;
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, channels === 1 ? gl.R32UI : gl.RGBA32UI, width, height);
  for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
  const row = width * channels, whole = words ? Math.floor(words.length / row) : 0;
  if (whole) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, whole, format, gl.UNSIGNED_INT, words);
  if (words && words.length > whole * row) {
    const rest = new Uint32Array(row);
    rest.set(words.subarray(whole * row));
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, whole, width, 1, format, gl.UNSIGNED_INT, rest);
  }
  return texture;
}

function framebuffer(...textures) {
  const made = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, made);
  textures.forEach((texture, i) => gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0));
  gl.drawBuffers(textures.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
  return made;
}

// Draws some rows of a picture.
function draw(target, width, height, first = 0, rows = height) {
  gl.bindFramebuffer(gl.FRAMEBUFFER, target);
  gl.viewport(0, 0, width, height);
  gl.enable(gl.SCISSOR_TEST);
  gl.scissor(0, first, width, rows);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
}

// What stands in a target, once the device has drawn it: words, four a place, or with `kind` UNSIGNED_BYTE bytes.
async function contentsOf(target, width, height, attachment = 0, kind = gl.UNSIGNED_INT) {
  const contents = new (kind === gl.UNSIGNED_INT ? Uint32Array : Uint8Array)(4 * width * height), buffer = gl.createBuffer();
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
  gl.bufferData(gl.PIXEL_PACK_BUFFER, contents.byteLength, gl.STREAM_READ);
  gl.bindFramebuffer(gl.FRAMEBUFFER, target);
  gl.readBuffer(gl.COLOR_ATTACHMENT0 + attachment);
  gl.readPixels(0, 0, width, height, kind === gl.UNSIGNED_INT ? gl.RGBA_INTEGER : gl.RGBA, kind, 0);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  await finished();
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
  gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, contents);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  gl.deleteBuffer(buffer);
  return contents;
}

// The words of the volume, as a texture.
function wordTexture(words) {
  const rows = Math.ceil(words.length / PLACES_A_ROW), most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  if (rows > most || PLACES_A_ROW > most)
    throw new Error(`the volume has ${words.length} words, and this device holds ${Math.min(most, PLACES_A_ROW) * most}`);
  return integers(PLACES_A_ROW, rows, 1, words);
}
