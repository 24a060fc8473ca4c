// What the page does.

const MOST_SAMPLES = 256, MOVING_MILLISECONDS = 45, REST_MILLISECONDS = 150;
const element = id => document.getElementById(id);
const english = number => number.toLocaleString("en");

const wordsOnDevice = wordTexture(words);
const kept = {};

// What draws and answers by one of the two kernels; compiled when it is first asked for.
function programsOf(precision) {
  return kept[precision] ??= (async () => {
    const text = rest => shaders["words.glsl"] + `const bool IS_LABEL = ${scene.labels};\n` + shaders[precision] + rest;
    const [picture, develop] = await Promise.all([programOf(text(shaders["light.glsl"] + shaders["picture.frag"])), programOf(shaders["develop.frag"])]);
    let answer;
    return { words: wordsOnDevice, picture, develop, answering: () => answer ??= programOf(text(shaders["answer.frag"])) };
  })();
}

async function answers(precision) {
  const programs = await programsOf(precision);
  return { ...programs, answer: await programs.answering() };
}

let precision = "exact", moved = true, wake = () => {};
const changed = () => { moved = true; wake(); };

function tellArithmetic(differences) {
  const here = differences === undefined ? "" : differences ? `; here ${english(differences)} of ${english(checks.length)} rays differ` :
    `; here all ${english(checks.length)} rays of a check have the exact hit`;
  element("arithmetic").textContent = (precision === "exact" ? "exact" : `fast: ${scene.fast}`) + here;
  element("switch").textContent = precision === "exact" ? "fast" : "exact";
}

// One picture of as many pixels as the device does quickly.
async function takeQuickPicture(programs, films) {
  const [wide, high] = [canvas.width, canvas.height];
  const wanted = Math.min(1, Math.sqrt(pixelsAMillisecond * MOVING_MILLISECONDS / (wide * high)));
  const part = Math.max(2 ** (Math.floor(Math.log2(wanted) * 2) / 2), 0.1);
  const [width, height] = [Math.ceil(wide * part), Math.ceil(high * part)];
  if (films.quick?.width !== width || films.quick?.height !== height) {
    films.quick?.free();
    films.quick = makeFilm(width, height);
  }
  films.quick.begin(camera.view(wide, high));
  films.quick.expose(programs, 0, height);
  learnSpeed(width * height, await finished());
  films.quick.wind();
  films.quick.develop(programs, null, wide, high);
}

function fitCanvas(films) {
  const scale = Math.min(devicePixelRatio, 2);
  const [width, height] = [Math.max(Math.round(canvas.clientWidth * scale), 1), Math.max(Math.round(canvas.clientHeight * scale), 1)];
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  if (films.whole?.width !== width || films.whole?.height !== height) {
    films.whole?.free();
    films.whole = makeFilm(width, height);
    films.whole.several = true;
  }
}

async function checkHere() {
  const checked = precision, differences = await countDifferences(await answers(checked), checks);
  document.documentElement.dataset.differences = differences;
  if (precision === checked) tellArithmetic(differences);
}

// Draws for as long as the page is there: few pixels while the camera moves, then all of them again and again.
async function show() {
  const films = {};
  let restsSince = 0, isChecked = null;
  for (;;) {
    const programs = await programsOf(precision);
    await nextFrame();
    if (moved) {
      moved = false;
      fitCanvas(films);
      films.whole.begin(camera.view(canvas.width, canvas.height));
      await takeQuickPicture(programs, films);
      restsSince = performance.now();
    } else if (performance.now() - restsSince < REST_MILLISECONDS) {
      await sleep(10);
    } else if (films.whole.samples < MOST_SAMPLES) {
      if (!await exposeSample(programs, films.whole, () => moved)) continue;
      films.whole.develop(programs, null, canvas.width, canvas.height);
      element("status").textContent = `${english(films.whole.samples)} of ${MOST_SAMPLES} samples a pixel`;
      document.documentElement.dataset.samples = films.whole.samples;
      if (isChecked !== precision) {
        isChecked = precision;
        await checkHere();
      }
    } else {
      await new Promise(done => wake = done);
    }
  }
}

// The place that is seen at a pixel.
async function pick(x, y) {
  const { eye, front, right, up } = camera.view(canvas.clientWidth, canvas.clientHeight);
  const [across, down] = [2 * x / canvas.clientWidth - 1, 2 * y / canvas.clientHeight - 1];
  const ray = new Float32Array([...eye, ...add(add(front, right, across), up, -down)]);
  const hits = await trace(await answers(precision), ray);
  const t = new Float32Array(hits.buffer)[4];
  return hits[0] >> 31 ? null : [0, 1, 2].map(axis => ray[axis] + t * ray[3 + axis]);
}

// For tests and the curious.
window.voxc = {
  scene, camera, checkRays, changed,
  trace: async (rays, kernel = precision) => trace(await answers(kernel), rays),
  picture: async (width, height, samples) => takePicture(await programsOf(precision), width, height, samples),
};

async function start() {
  if (!await isArithmeticSound()) precision = "fast";
  tellArithmetic();
  element("switch").hidden = false;
  element("switch").addEventListener("click", () => {
    precision = precision === "exact" ? "fast" : "exact";
    element("status").textContent = scene.wait;
    tellArithmetic();
    changed();
  });
  if (matchMedia("(max-width: 600px)").matches) element("about").open = false;
  canvas.addEventListener("webglcontextlost", () => element("status").textContent = "The graphics device was lost; load the page again.");
  listen(changed, pick);
  await programsOf(precision);
  document.documentElement.dataset.arithmetic = precision;
  await show();
}
return start();
