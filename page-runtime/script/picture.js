// Pictures, sample by sample: light gathers in textures, as the bits of numbers, and is developed from there.

// The i-th of an evenly spread sequence of pairs of numbers from 0 to 1 (additive recurrence by the plastic number).
const evenNumbers = i => [0.5 + i / 1.324717957244746, 0.5 + i / 1.7548776662466927].map(value => value - Math.floor(value));
const DIRECTIONS = 16; // Of a square of pixels, to the sky.

function makeFilm(width, height) {
  const channels = volume.isStreamed ? { sun: 4, sky: 4, told: 1 } : { sun: 4, sky: 4 };
  const lights = [0, 1].map(() => Object.fromEntries(Object.entries(channels).map(([name, count]) => [name, integers(width, height, count)])));
  const targets = lights.map(light => framebuffer(...Object.values(light)));
  const latest = film => lights[film.draws % 2];
  return {
    // The first pass may be a sketch: where surfaces are, in a light that needs no further rays.
    width, height, draws: 0, passes: 0, samples: 0, view: null,
    isWhole: true, isAgain: false, turn: [0, width * height], // Where pixels wait for pages: only these are traced, and of these some.
    begin(view) { Object.assign(this, { passes: 0, samples: 0, view, isWhole: true, isAgain: false, turn: [0, width * height] }); },
    isSketch() { return (scene.smooth || volume.isStreamed) && this.passes === 0; },
    // Of which pages pixels have told.
    told() { return latest(this).told; },
    // Has a program take the picture of the film's camera.
    aim(program) {
      for (const name of ["eye", "front", "right", "up"]) program.set("3f", name, ...this.view[name]);
      program.set("1i", "is_parallel", this.view.isParallel);
    },
    // Rows of the next pass.
    expose(programs, first, rows) {
      const { sun, sky, told } = latest(this);
      const program = this.isSketch() && programs.sketch || programs.picture;
      volume.bind(program.use());
      if (told)
        program.texture("before_told", told, 4).set("1i", "is_again", this.isAgain).set("2ui", "turn", ...this.turn)
          .set("1i", "number", volume.figures.rounds);
      program.texture("before_sun", sun, 1).texture("before_sky", sky, 2).set("1i", "is_after_sketch", this.samples === 0)
        .set("1i", "is_sketch", this.isSketch()).set("1i", "is_further", this.passes > 0).set("1i", "is_smooth", scene.smooth)
        .set("2i", "size", width, height)
        .set("2f", "place", ...evenNumbers(this.samples)).set("2f", "numbers", ...evenNumbers(this.samples * DIRECTIONS))
        .set("3f", "sun", ...scene.sun).set("1f", "open_scale", 0.06 * size);
      this.aim(program);
      draw(targets[1 - this.draws % 2], width, height, first, rows);
    },
    // All rows are there.
    drawn() { this.draws++; this.isWhole = false; },
    // The pass is whole.
    wind() {
      if (!this.isSketch()) this.samples++;
      this.passes++;
      this.isWhole = true;
    },
    develop(programs, target, pixelsWide, pixelsHigh) {
      const { sun, sky, told } = latest(this);
      programs.develop.use().texture("told", told || sun, 2).set("1i", "is_partial", !this.isWhole && !this.isSketch())
        .texture("sun_light", sun, 0).texture("sky_light", sky, 1)
        .set("1f", "samples", this.samples).set("1i", "is_smooth", scene.smooth).set("1f", "exposure", scene.exposure)
        .set("2f", "canvas", pixelsWide, pixelsHigh);
      this.aim(programs.develop);
      draw(target, pixelsWide, pixelsHigh);
    },
    free() {
      for (const light of lights) Object.values(light).forEach(texture => gl.deleteTexture(texture));
      targets.forEach(target => gl.deleteFramebuffer(target));
      gl.deleteTexture(this.squares || null);
      gl.deleteFramebuffer(this.feedback || null);
    },
  };
}

// Exposes one pass in strips that take the device a twentieth of a second or so, and pixels that wait for pages until they have them; ends
// early where `isStale` says so. `show` is called before they are asked.
let pixelsAMillisecond = 200;
async function exposePass(programs, film, isStale, show = () => {}) {
  if (!film.isSketch()) await programs.lit();
  do {
    for (let first = 0; first < film.height;) {
      const rows = Math.min(Math.max(Math.round(pixelsAMillisecond * 50 / film.width), 4), film.height - first);
      film.expose(programs, first, rows);
      const time = await finished();
      if (!film.isAgain) learnSpeed(rows * film.width, time);
      if (isStale()) return false;
      first += rows;
    }
    film.drawn();
    if (!volume.isStreamed) break;
    show();
  } while (await hasToGoOn(programs, film, isStale));
  film.wind();
  return true;
}

async function exposeSample(programs, film, isStale, show) {
  for (const samples = film.samples; film.samples === samples;)
    if (!await exposePass(programs, film, isStale, show)) return false;
  return true;
}

// The first pixel has the device make its code ready, which may take seconds and says nothing of its speed.
async function warmUp(programs) {
  const film = makeFilm(1, 1);
  film.begin(camera.view(1, 1));
  film.expose(programs, 0, 1);
  await finished();
  film.free();
}

function learnSpeed(pixels, milliseconds) {
  pixelsAMillisecond = Math.sqrt(pixelsAMillisecond * Math.min(Math.max(pixels / Math.max(milliseconds, 1), 2), 1e6));
}

// The picture of the camera at a size, of so many samples: its red, green, blue and alpha, rows from the top.
async function takePicture(programs, width, height, samples) {
  const film = makeFilm(width, height), shown = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, shown);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
  const target = framebuffer(shown), picture = new Uint8Array(4 * width * height);
  film.begin(camera.view(width, height));
  for (let i = 0; i < samples; i++) await exposeSample(programs, film, () => false);
  film.develop(programs, target, width, height);
  const rows = await contentsOf(target, width, height, 0, gl.UNSIGNED_BYTE);
  for (let row = 0; row < height; row++) picture.set(rows.subarray(4 * width * row, 4 * width * (row + 1)), 4 * width * (height - 1 - row));
  film.free();
  gl.deleteTexture(shown);
  gl.deleteFramebuffer(target);
  return picture;
}
