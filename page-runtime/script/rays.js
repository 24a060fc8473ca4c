// Hits of rays through the functions that make the picture.

const RAYS_A_ROW = 128, RAYS_AT_ONCE = 16384;

// Six words a hit, as voxc trace --outputs voxel,t,face,colour writes them; `rays` is a Float32Array, six numbers a ray.
async function trace(programs, rays) {
  const count = rays.length / 6, hits = new Uint32Array(6 * count), bits = new Uint32Array(rays.buffer, rays.byteOffset, rays.length);
  for (let first = 0; first < count; first += RAYS_AT_ONCE)
    await traceSome(programs, bits, hits, first, Math.min(RAYS_AT_ONCE, count - first));
  return hits;
}

async function traceSome(programs, bits, hits, first, count) {
  const rows = Math.ceil(count / RAYS_A_ROW), given = new Uint32Array(8 * RAYS_A_ROW * rows);
  for (let i = 0; i < count; i++) {
    given.set(bits.subarray(6 * (first + i), 6 * (first + i) + 3), 8 * i);
    given.set(bits.subarray(6 * (first + i) + 3, 6 * (first + i) + 6), 8 * i + 4);
  }
  const textures = [integers(2 * RAYS_A_ROW, rows, 4, given), integers(RAYS_A_ROW, rows, 4), integers(RAYS_A_ROW, rows, 4)];
  const target = framebuffer(textures[1], textures[2]);
  programs.answer.use().texture("words", programs.words, 0).texture("rays", textures[0], 1);
  draw(target, RAYS_A_ROW, rows);
  await finished();
  gl.bindFramebuffer(gl.FRAMEBUFFER, target);
  const [place, rest] = [0, 1].map(attachment => {
    const read = new Uint32Array(4 * RAYS_A_ROW * rows);
    gl.readBuffer(gl.COLOR_ATTACHMENT0 + attachment);
    gl.readPixels(0, 0, RAYS_A_ROW, rows, gl.RGBA_INTEGER, gl.UNSIGNED_INT, read);
    return read;
  });
  for (let i = 0; i < count; i++)
    hits.set([place[4 * i], place[4 * i + 1], place[4 * i + 2], rest[4 * i], place[4 * i + 3], rest[4 * i + 1]], 6 * (first + i));
  gl.deleteFramebuffer(target);
  textures.forEach(texture => gl.deleteTexture(texture));
}

// Rays from in and around the volume to places in it: the same here and where the page was made.
function checkRays(count) {
  const rays = new Float32Array(6 * count);
  for (let i = 0; i < count; i++)
    for (let axis = 0; axis < 3; axis++) {
      const from = (noise(8 * i + axis) >>> 16) / 65536 * 2 * extent[axis] - extent[axis] / 2;
      const to = (noise(8 * i + 4 + axis) >>> 16) / 65536 * extent[axis];
      rays[6 * i + axis] = from;
      rays[6 * i + 3 + axis] = to - from;
    }
  return rays;
}

// A byte of each hit's voxel, colour and t.
function digestOf(hits, i) {
  let digest = 0;
  for (let k = 0; k < 5; k++) digest = noise(digest ^ hits[6 * i + k]);
  return digest & 255;
}

// How many of the rays whose hits the page's maker knew have another hit here.
async function countDifferences(programs, checks) {
  const hits = await trace(programs, checkRays(checks.length));
  return checks.reduce((count, digest, i) => count + (digest !== digestOf(hits, i)), 0);
}
