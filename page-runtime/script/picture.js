// Pictures, sample by sample: light gathers in textures, as the bits of numbers, and is developed from there.

// The i-th of an evenly spread sequence of pairs of numbers from 0 to 1 (additive recurrence by the plastic number).
const evenNumbers = i => [0.5 + i / 1.324717957244746, 0.5 + i / 1.7548776662466927].map(value => value - Math.floor(value));
const DIRECTIONS = 16; // Of a square of pixels, to the sky.

function makeFilm(width, height, on = device) {
  const channels = volume.isStreamed ? { sun: 4, sky: 4, told: 1 } : { sun: 4, sky: 4 };
  const lights = [0, 1].map(() => Object.fromEntries(Object.entries(channels).map(([name, count]) => [name, on.integers(width, height, count)])));
  const targets = lights.map(light => on.targetOf(...Object.values(light)));
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
      const { eye, front, right, up, isParallel } = this.view;
      return program.give({ eye, front, right, up, is_parallel: isParallel, size: [width, height], is_smooth: scene.smooth, samples: this.samples });
    },
    // Rows of the next pass.
    expose(programs, first, rows) {
      const { sun, sky, told } = latest(this);
      const program = this.isSketch() && programs.sketch || programs.picture;
      volume.bind(program);
      if (told) program.take({ before_told: told }).give({ is_again: this.isAgain, turn: this.turn, number: volume.figures.rounds });
      this.aim(program).take({ before_sun: sun, before_sky: sky }).give({
        is_sketch: this.isSketch(), is_further: this.passes > 0, is_after_sketch: this.samples === 0, sun: scene.sun, open_scale: 0.06 * size,
        place: evenNumbers(this.samples), numbers: evenNumbers(this.samples * DIRECTIONS),
      }).draw(targets[1 - this.draws % 2], first, rows);
    },
    // All rows are there.
    drawn() { this.draws++; this.isWhole = false; },
    // The pass is whole.
    wind() {
      if (!this.isSketch()) this.samples++;
      this.passes++;
      this.isWhole = true;
    },
    develop(programs, target) {
      const { sun, sky, told } = latest(this);
      this.aim(programs.develop).take({ sun_light: sun, sky_light: sky, told: told || sun })
        .give({ is_partial: !this.isWhole && !this.isSketch(), exposure: scene.exposure, canvas: [target.width, target.height] }).draw(target);
    },
    free() { on.free(...targets, this.feedback, ...lights.flatMap(light => Object.values(light)), this.squares); },
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
      const time = await device.finished();
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

// The first pixel has the device make its code ready, which may take seconds and says nothing of its speed. That it can show something is tried
// out too: there are browsers whose WebGPU ends there.
async function warmUp(programs, on) {
  const film = makeFilm(1, 1, on);
  film.begin(camera.view(1, 1));
  film.expose(programs, 0, 1);
  if (!on.hasShown) film.develop(programs, on.screen);
  await on.finished();
  on.hasShown = true;
  film.free();
}

function learnSpeed(pixels, milliseconds) {
  pixelsAMillisecond = Math.sqrt(pixelsAMillisecond * Math.min(Math.max(pixels / Math.max(milliseconds, 1), 2), 1e6));
}

// The picture of the camera at a size, of so many samples: its red, green, blue and alpha, rows from the top.
async function takePicture(programs, width, height, samples) {
  const film = makeFilm(width, height), shown = device.bytes(width, height), target = device.targetOf(shown);
  film.begin(camera.view(width, height));
  for (let i = 0; i < samples; i++) await exposeSample(programs, film, () => false);
  film.develop(programs, target);
  const picture = await device.pictureOf(target);
  film.free();
  device.free(target, shown);
  return picture;
}
