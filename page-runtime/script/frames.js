// The frames of an animation: each has a root of its own, which stands in the first word of the volume.

const FRAMES_A_SECOND = 12, frameCount = scene.frames.length;
let frame = 0, shownFrame = 0, isPlaying = false;

// The picture that is drawn next is of this frame.
function chooseFrame(index) {
  frame = (index + frameCount) % frameCount;
  element("frame").value = frame + 1;
  element("number").textContent = `${frame + 1} of ${frameCount}`;
  changed();
}

// Before a picture is begun: one that is half drawn stays of one frame.
function bringFrame() {
  if (frame === shownFrame) return;
  shownFrame = frame;
  volume.showRoot(scene.frames[frame]);
  document.documentElement.dataset.frame = frame + 1;
}

// By the clock: a slow device leaves frames out.
async function play() {
  const begin = performance.now(), first = frame;
  while (isPlaying) {
    await nextFrame();
    const index = (first + Math.floor((performance.now() - begin) * FRAMES_A_SECOND / 1000)) % frameCount;
    if (isPlaying && index !== frame) chooseFrame(index);
  }
}

function setPlaying(plays) {
  if (plays === isPlaying) return;
  isPlaying = plays;
  element("play").textContent = plays ? "Stop" : "Play";
  if (plays) play();
}

function stepFrame(index) {
  setPlaying(false);
  chooseFrame(index);
}

// Once; the keys of the canvas come from `listen`.
function listenToFrames() {
  if (!frameCount) return;
  element("play").addEventListener("click", () => setPlaying(!isPlaying));
  element("frame").addEventListener("input", event => stepFrame(event.target.value - 1));
}

const frameKeys = frameCount ? { " ": () => setPlaying(!isPlaying), ",": () => stepFrame(frame - 1), ".": () => stepFrame(frame + 1) } : {};
