// Hits of rays through the functions that make the picture.

const RAYS_A_ROW = 128, RAYS_AT_ONCE = 16384;

// Six words a hit, as voxc trace --outputs voxel,t,face,colour writes them; `rays` is a Float32Array, six numbers a ray. `cuts` are planes
// that cut something away.
async function trace(programs, rays, cuts = []) {
  const count = rays.length / 6, hits = new Uint32Array(6 * count), bits = new Uint32Array(rays.buffer, rays.byteOffset, rays.length);
  const bounds = new Float32Array(2 * count);
  for (let i = 0; i < count; i++) bounds.set(boundsOf(rays.subarray(6 * i, 6 * i + 6), cuts), 2 * i);
  for (let first = 0; first < count; first += RAYS_AT_ONCE)
    await traceSome(programs, bits, new Uint32Array(bounds.buffer), hits, first, Math.min(RAYS_AT_ONCE, count - first));
  return hits;
}

// The next float32 before a moment.
function justBefore(moment) {
  const nearest = Float32Array.of(Math.min(Math.max(moment, -3e38), 3e38)), bits = new Int32Array(nearest.buffer);
  if (nearest[0] === 0) return -(2 ** -149);
  bits[0] += nearest[0] > 0 ? -1 : 1;
  return nearest[0];
}

// Between which moments a ray goes through what planes keep, by doubles: the same here and where the page was made.
function boundsOf([x, y, z, dx, dy, dz], cuts) {
  let tmin = cuts.length ? 2 ** -126 : 0, tmax = Infinity;
  for (const [nx, ny, nz, offset] of cuts) {
    const side = nx * x + ny * y + nz * z - offset, speed = nx * dx + ny * dy + nz * dz;
    if (speed > 0) tmin = Math.max(tmin, justBefore(-side / speed));
    else if (speed < 0) tmax = Math.min(tmax, justBefore(-side / speed));
    else if (!(side >= 0)) tmax = -1;
  }
  return [tmin, tmax];
}

// Also of a volume of which some pages are here; rays for which they have no room at once are traced by halves.
async function traceSome(programs, bits, bounds, hits, first, count) {
  const rows = Math.ceil(count / RAYS_A_ROW), given = new Uint32Array(8 * RAYS_A_ROW * rows);
  for (let i = 0; i < count; i++) {
    given.set(bits.subarray(6 * (first + i), 6 * (first + i) + 3), 8 * i);
    given.set(bits.subarray(6 * (first + i) + 3, 6 * (first + i) + 6), 8 * i + 4);
    [given[8 * i + 3], given[8 * i + 7]] = bounds.subarray(2 * (first + i));
  }
  const textures = [device.integers(2 * RAYS_A_ROW, rows, 4, given), device.integers(RAYS_A_ROW, rows, 4), device.integers(RAYS_A_ROW, rows, 4)];
  const target = device.targetOf(textures[1], textures[2]);
  let place, rest, asked;
  if (volume.isStreamed) volume.beginGroup();
  do {
    volume.bind(programs.answer.take({ rays: textures[0] }));
    programs.answer.draw(target);
    [place, rest] = [await device.contentsOf(target, 0), await device.contentsOf(target, 1)];
    asked = volume.isStreamed ? volume.sorted(rest.subarray(0, 4 * count), 4, 3) : new Set();
    if (asked.size && count > 1 && volume.areTooMany(asked)) break;
    if (asked.size) await volume.bring(asked, count === 1);
  } while (asked.size);
  for (let i = 0; i < count; i++)
    hits.set([place[4 * i], place[4 * i + 1], place[4 * i + 2], rest[4 * i], place[4 * i + 3], rest[4 * i + 1]], 6 * (first + i));
  device.free(target, ...textures);
  if (!asked.size) return;
  const half = Math.ceil(count / 2);
  await traceSome(programs, bits, bounds, hits, first, half);
  await traceSome(programs, bits, bounds, hits, first + half, count - half);
}

// Rays from in and around the volume to places in it: the same here and where the page was made.
function checkRays(count) {
  const rays = new Float32Array(6 * count);
  for (let i = 0; i < count; i++)
    for (let axis = 0; axis < 3; axis++) {
      const from = (noise(8 * i + axis) >>> 8) / 16777216 * 2 * extent[axis] - extent[axis] / 2;
      const to = (noise(8 * i + 4 + axis) >>> 8) / 16777216 * extent[axis];
      rays[6 * i + axis] = from;
      rays[6 * i + 3 + axis] = to - from;
    }
  return rays;
}

// Rays of the picture of the page's maker, where `checkRays` would have too many pages read.
function pictureRays({ eye, front, right, up, isParallel }, count) {
  const rays = new Float32Array(6 * count);
  for (let i = 0; i < count; i++) {
    const [across, above] = [noise(2 * i), noise(2 * i + 1)].map(number => (number >>> 20) / 2048 - 1);
    for (let axis = 0; axis < 3; axis++) {
      const aside = (isParallel ? eye : front)[axis] + right[axis] * across + up[axis] * above;
      rays[6 * i + axis] = isParallel ? aside : eye[axis];
      rays[6 * i + 3 + axis] = isParallel ? front[axis] : aside;
    }
  }
  return rays;
}

const raysOfCheck = count => scene.volume ? pictureRays(scene.volume.view, count) : checkRays(count);

// A byte of a hit's voxel and colour.
function digestOf(hits, i) {
  let digest = 0;
  for (let k = 0; k < 4; k++) digest = noise(digest ^ hits[6 * i + k]);
  return digest & 255;
}

// When a ray enters a voxel, by doubles.
function entryOf(rays, hits, i) {
  let latest = 0;
  for (let axis = 0; axis < 3; axis++) {
    const [from, way] = [rays[6 * i + axis], rays[6 * i + 3 + axis]];
    if (way) latest = Math.max(latest, (hits[6 * i + axis] + (way < 0) - from) / way);
  }
  return latest;
}

// Of the rays whose hits the page's maker knew: how many have another voxel here, and how wrong a t is at most, in voxels.
async function errorsHere(programs, checks) {
  const rays = raysOfCheck(checks.length), hits = await trace(programs, rays, scene.cuts), times = new Float32Array(hits.buffer);
  let others = 0, worst = 0;
  checks.forEach((digest, i) => {
    if (digest !== digestOf(hits, i)) others++;
    else if (!(hits[6 * i] >> 31) && times[6 * i + 4] !== Math.fround(entryOf(rays, hits, i)))
      worst = Math.max(worst, Math.abs(times[6 * i + 4] - entryOf(rays, hits, i)) * Math.hypot(...rays.subarray(6 * i + 3, 6 * i + 6)));
  });
  return { others, worst };
}
