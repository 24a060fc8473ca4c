// Pictures, sample by sample: light gathers in a texture, as the bits of four numbers a pixel, and is developed from there.

// The i-th of an evenly spread sequence of pairs of numbers from 0 to 1 (additive recurrence by the plastic number).
const evenNumbers = i => [0.5 + i / 1.324717957244746, 0.5 + i / 1.7548776662466927].map(value => value - Math.floor(value));
const DIRECTIONS = 16; // Of a square of pixels, to the sky.

function makeFilm(width, height) {
  const textures = [integers(width, height, 4), integers(width, height, 4)];
  const targets = textures.map(texture => framebuffer(texture));
  return {
    width, height, samples: 0, view: null, light: textures[0],
    begin(view) { this.samples = 0; this.view = view; },
    // Rows of the next sample.
    expose(programs, first, rows) {
      const { eye, front, right, up } = this.view, next = 1 - this.samples % 2;
      programs.picture.use().texture("words", programs.words, 0).texture("before", textures[1 - next], 1)
        .set("1i", "samples", this.samples).set("2i", "size", width, height)
        .set("3f", "eye", ...eye).set("3f", "front", ...front).set("3f", "right", ...right).set("3f", "up", ...up)
        .set("2f", "place", ...(this.samples || this.several ? evenNumbers(this.samples) : [0.5, 0.5]))
        .set("2f", "numbers", ...evenNumbers(this.samples * DIRECTIONS))
        .set("3f", "sun", ...scene.sun).set("1f", "open_scale", 0.06 * size);
      draw(targets[next], width, height, first, rows);
    },
    // The sample is whole.
    wind() { this.light = textures[1 - this.samples++ % 2]; },
    develop(programs, target, pixelsWide, pixelsHigh) {
      const { front, right, up } = this.view;
      programs.develop.use().texture("light", this.light, 0).set("1f", "samples", this.samples).set("1f", "exposure", scene.exposure)
        .set("2f", "canvas", pixelsWide, pixelsHigh).set("3f", "front", ...front).set("3f", "right", ...right).set("3f", "up", ...up);
      draw(target, pixelsWide, pixelsHigh);
    },
    free() {
      textures.forEach(texture => gl.deleteTexture(texture));
      targets.forEach(target => gl.deleteFramebuffer(target));
    },
  };
}

// Exposes one sample in strips that take the device a twentieth of a second or so; ends early where `isStale` says so.
let pixelsAMillisecond = 200;
async function exposeSample(programs, film, isStale) {
  for (let first = 0; first < film.height;) {
    const rows = Math.min(Math.max(Math.round(pixelsAMillisecond * 50 / film.width), 4), film.height - first);
    film.expose(programs, first, rows);
    learnSpeed(rows * film.width, await finished());
    if (isStale()) return false;
    first += rows;
  }
  film.wind();
  return true;
}

function learnSpeed(pixels, milliseconds) {
  pixelsAMillisecond = Math.sqrt(pixelsAMillisecond * Math.min(Math.max(pixels / Math.max(milliseconds, 1), 2), 1e6));
}

// The picture of the camera at a size, of so many samples: its red, green, blue and alpha, rows from the top.
async function takePicture(programs, width, height, samples) {
  const film = makeFilm(width, height), shown = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, shown);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
  const target = framebuffer(shown), rows = new Uint8Array(4 * width * height), picture = new Uint8Array(rows.length);
  film.begin(camera.view(width, height));
  film.several = samples > 1;
  for (let i = 0; i < samples; i++) await exposeSample(programs, film, () => false);
  film.develop(programs, target, width, height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rows);
  for (let row = 0; row < height; row++) picture.set(rows.subarray(4 * width * row, 4 * width * (row + 1)), 4 * width * (height - 1 - row));
  film.free();
  gl.deleteTexture(shown);
  gl.deleteFramebuffer(target);
  return picture;
}
