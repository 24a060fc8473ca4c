// What the page does.

const MOST_SAMPLES = 256, FEW_SAMPLES = 8, MOVING_MILLISECONDS = 45, REST_MILLISECONDS = 150, PATIENCE_MILLISECONDS = 15000;
const element = id => document.getElementById(id);
const english = number => number.toLocaleString("en");

let device, volume, kept = {}; // Programs, by precision.

// The functions of the exact kernel or of the fast one: what one of them has alone is marked.
function functionsOf(precision) {
  const other = precision === "exact" ? "+" : "-";
  return shaders.functions.map(piece => piece[device.language]).join("").split("\n").filter(line => line[0] !== other).map(line => line.slice(1)).join("\n");
}

// What draws and answers by one of the two kernels; compiled when it is first asked for.
function programsOf(precision) {
  return kept[precision] ??= (async () => {
    const on = device, functions = functionsOf(precision), made = name => on.programOf(name, functions);
    const programs = {}, names = volume.isStreamed ? ["develop", "sketch", "collect"] : ["develop", "picture"]; // First what shows something.
    for (const name of names) programs[name] = made(name);
    for (const name in programs) programs[name] = await programs[name];
    await warmUp(programs, on);
    if (volume.isStreamed) noteMoment("ready");
    const lit = async () => programs.picture ??= await made("picture");
    let lighting;
    programs.lit = () => programs.picture || (lighting ??= lit());
    let answer;
    return Object.assign(programs, { answering: () => answer ??= made("answer") });
  })();
}

// Those of the precision that was chosen. Where the device does not take the exact kernel, the page goes on with the fast one and says why.
async function chosenPrograms() {
  const chosen = precision;
  try {
    return await programsOf(chosen);
  } catch (problem) {
    if (chosen === "fast") throw problem;
    if (precision === chosen) choose("fast", `; the exact kernel is not taken here: ${problem.message}`);
    return programsOf("fast");
  }
}

async function answers(precision) {
  const programs = await programsOf(precision);
  return Object.assign(programs, { answer: await programs.answering() });
}

let precision = "exact", moved = true, wake = () => {}, why = "";
const changed = () => { moved = true; wake(); };

// What is known of the hits, and of those that this browser finds.
function tellArithmetic(errors) {
  const isExact = precision === "exact", { rays, others } = scene.fast, checked = english(checks.length);
  const kind = isExact ? "exact" : `fast: plain float32; of ${english(rays)} rays on the maker's cpu ${english(others)} hit another voxel`;
  let here = "";
  if (errors && isExact && !errors.others && !errors.worst)
    here = `: here, all ${checked} rays of a check have the exact hit`;
  else if (errors)
    here = `${isExact ? ", but not here" : "; here"}: of ${checked} rays ${english(errors.others)} hit another voxel, ` +
      `and t is off by ${errors.worst.toPrecision(2)} voxels at most`;
  element("arithmetic").textContent = kind + here + why;
  element("switch").textContent = `switch to ${isExact ? "fast" : "exact"}`;
}

// A film of a part of the canvas's pixels along each side, kept under a name.
function filmOf(films, name, part) {
  const [width, height] = [Math.ceil(canvas.width * part), Math.ceil(canvas.height * part)];
  if (films[name]?.width !== width || films[name]?.height !== height) {
    films[name]?.free();
    films[name] = makeFilm(width, height);
  }
  films[name].begin(camera.view(canvas.width, canvas.height));
  return films[name];
}

function fitCanvas() {
  const scale = Math.min(devicePixelRatio, 2);
  const [width, height] = [Math.max(Math.round(canvas.clientWidth * scale), 1), Math.max(Math.round(canvas.clientHeight * scale), 1)];
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
}

// What is asked for beside the pictures goes before them, one after the other: rays of both would take each other's pages away.
let asking = null;
function answered(task) {
  const before = asking, answer = (async () => { await before; return task(); })();
  const settled = answer.catch(() => {}).then(() => { if (asking === settled) asking = null; });
  asking = settled;
  return answer;
}
const isLate = () => moved || asking;

// The poster lies over the canvas until its picture is about as fine, or of another place than the maker's.
const placeOfEye = () => String([camera.yaw, camera.pitch, camera.distance, camera.half, camera.isParallel, ...camera.look]), placeOfPoster = placeOfEye();
function tellPicture(film, part) {
  document.documentElement.dataset.part = part; // Of the canvas's pixels along a side.
  if (part < 0.5 && placeOfEye() === placeOfPoster && shownFrame === 0 && element("poster")) return;
  element("poster")?.remove();
  if (part < 1) element("status").textContent = `${english(film.width)} × ${english(film.height)} pixels so far`;
  else tellSamples(film.samples);
}

// What puts a film on the canvas, as far as it is exposed.
const showing = (programs, film) => () => {
  film.develop(programs, device.screen);
  if (volume.isStreamed) tellPages(film);
};

// A picture of as many pixels as the device does quickly. Tells which part that is.
async function takeQuickPicture(programs, films) {
  const wanted = Math.sqrt(pixelsAMillisecond * MOVING_MILLISECONDS / (canvas.width * canvas.height));
  const part = Math.min(Math.max(2 ** (Math.floor(Math.log2(wanted) * 2) / 2), 1 / 8), 1);
  const film = filmOf(films, "quick", part), show = showing(programs, film);
  if (volume.isStreamed) await exposePass(programs, film, () => film.isAgain && isLate(), show);
  else await exposeSample(programs, film, () => false);
  show();
  tellPicture(film, part);
  return part;
}

async function checkHere() {
  const checked = precision, errors = await errorsHere(await answers(checked), checks);
  if (loss) throw loss; // What it answers then is nothing.
  if (precision !== checked) return;
  document.documentElement.dataset.checked = JSON.stringify({ precision, ...errors });
  tellArithmetic(errors);
}

// Draws for as long as the page is there: few pixels while the camera moves, then more, then all of them again and again.
async function show() {
  const films = {};
  let restsSince = 0, part = 1, film = null, isChecked = null;
  for (;;) {
    const programs = await chosenPrograms();
    await nextFrame();
    if (loss) throw loss;
    while (asking) await asking;
    if (moved) {
      moved = false;
      bringFrame();
      fitCanvas();
      part = await takeQuickPicture(programs, films);
      film = null;
      restsSince = performance.now();
    } else if (performance.now() - restsSince < REST_MILLISECONDS) {
      await sleep(10);
    } else if (!film || film.samples < mostSamples()) {
      if (!film || part < 1) film = filmOf(films, "still", part = film ? Math.min(2 * part, 1) : part < 0.5 ? 2 * part : 1);
      const show = showing(programs, film);
      if (!await exposeSample(programs, film, isLate, show)) continue;
      show();
      tellPicture(film, part);
      if (part === 1 && isChecked !== precision && shownFrame === 0) {
        isChecked = precision;
        await checkHere();
      }
    } else {
      await new Promise(done => wake = done);
    }
  }
}

// Where pages have to make room for others, each sample has some read again.
const mostSamples = () => volume.isStreamed && volume.figures.gone ? FEW_SAMPLES : MOST_SAMPLES;

function tellSamples(samples) {
  const most = mostSamples();
  element("status").textContent = `${english(samples)} of ${most} samples a pixel` + (samples < most ? "" : ": the picture is finished");
  document.documentElement.dataset.samples = samples;
}

// The place that is seen at a pixel.
async function pick(x, y) {
  const { eye, front, right, up, isParallel } = camera.view(canvas.clientWidth, canvas.clientHeight);
  const [across, down] = [2 * x / canvas.clientWidth - 1, 2 * y / canvas.clientHeight - 1];
  const aside = add(add(isParallel ? eye : front, right, across), up, -down);
  const [from, way] = isParallel ? [aside, front] : [eye, aside];
  const ray = new Float32Array([...from, ...way].map((value, i) => value / spacing[i % 3]));
  const hits = await answered(async () => trace(await answers(precision), ray, scene.cuts));
  const t = new Float32Array(hits.buffer)[4];
  return hits[0] >> 31 ? null : add(from, way, t);
}

// For tests and the curious.
window.voxc = {
  scene, camera, checkRays, changed, get pages() { return volume.figures; },
  trace: (rays, kernel = precision) => answered(async () => trace(await answers(kernel), rays)),
  picture: (width, height, samples) => answered(async () => takePicture(await programsOf(precision), width, height, samples)),
};

function choose(chosen, because = "") {
  [precision, why] = [chosen, because];
  element("status").textContent = scene.wait;
  tellArithmetic();
  changed();
}

// Exact where the device can: its arithmetic is sound, and its compiler takes the kernel, within some patience. Where it cannot, and there is
// another device, false.
async function choosePrecision(isLast) {
  const exact = programsOf("exact").then(() => "", problem => `; the exact kernel is not taken here: ${problem.message}`);
  const isSound = await isArithmeticSound(), late = "; the exact kernel is still being compiled here";
  const because = isSound ? await Promise.race([exact, sleep(PATIENCE_MILLISECONDS).then(() => late)])
    : "; this browser's arithmetic is not what exact hits need";
  if (!because) return true;
  if (!isLast && because !== late) return false;
  choose("fast", because);
  if (isSound) exact.then(problem => problem || precision === "exact" || choose("exact"));
  return true;
}

// A lost device draws nothing, whatever it is told, and raises no errors; that of a canvas that was given up may go.
let loss = null;
const lossOf = own => () => {
  if (own !== canvas) return;
  loss = new Error("the graphics device was lost; load the page again");
  wake();
};

// A canvas draws by one kind of device alone.
function renewCanvas() {
  const fresh = canvas.cloneNode();
  canvas.replaceWith(fresh);
  canvas = fresh;
}

// Draws by WebGPU where the browser has it, and else by WebGL 2; behind # the address of the page may name one.
async function chooseDevice() {
  const kinds = scene.volume ? { "#webgl": makeWebGl } : { "#webgpu": makeWebGpu, "#webgl": makeWebGl };
  const makers = location.hash in kinds ? [kinds[location.hash]] : Object.values(kinds);
  for (const make of makers) {
    const isLast = make === makers.at(-1);
    try {
      device = await make();
      [volume, kept, shownFrame] = [makeVolume(), {}, 0];
      listen(changed, pick);
      if (await choosePrecision(isLast)) return;
    } catch (problem) {
      if (isLast) throw problem;
    }
    renewCanvas();
  }
}

async function start() {
  tellArithmetic();
  listenToFrames();
  element("switch").hidden = false;
  element("switch").addEventListener("click", () => choose(precision === "exact" ? "fast" : "exact"));
  if (matchMedia("(max-width: 600px)").matches) element("about").open = false;
  await chooseDevice();
  element("device").textContent = device.name;
  await chosenPrograms();
  Object.assign(document.documentElement.dataset, { ready: precision, device: device.name });
  await show();
}
return start().catch(problem => { throw loss || problem; });
