// Where the picture is taken from: a place that is looked at, a direction, and how far off the eye is. All of it is in spaced space: that of
// voxels, stretched to their sides.

const extent = scene.extent, spacing = scene.spacing;
const sides = extent.map((side, axis) => side * spacing[axis]), size = Math.max(...sides);
const add = (a, b, times = 1) => a.map((value, axis) => value + b[axis] * times);
const dot = (a, b) => a.reduce((sum, value, axis) => sum + value * b[axis], 0);
const camera = {
  // The camera of the page's maker.
  reset() {
    const { eye, look, up, fov, height } = scene.camera;
    this.isParallel = false;
    this.aim(eye, look);
    // Straight down or up, the way up tells where the right is: along the way x up.
    const way = add(look, eye, -1), [x, z] = [way[1] * up[2] - way[2] * up[1], way[0] * up[1] - way[1] * up[0]];
    if (x || z) this.yaw = Math.atan2(z, -x);
    this.tangent = Math.tan(fov * Math.PI / 360);
    this.setParallel(height > 0, height / 2);
    this.wide = this.widthOfBox();
  },
  // Parallel rays show as much of the plane of what is looked at as those from the eye do, or half as high as is said. What lies behind the
  // plane of the eye is not seen.
  setParallel(isParallel, half = this.tangent * this.distance) {
    if (this.isParallel && !isParallel) this.distance = this.reach();
    this.isParallel = isParallel;
    this.half = isParallel ? half : 0;
    this.hasAllInFront = this.nearest() > 0;
  },
  // From how far off an eye would see as much of the plane of what is looked at.
  reach() { return this.isParallel ? this.half / this.tangent : this.distance; },
  ways() {
    const eye = this.eye();
    return [0, 1, 2, 3, 4, 5, 6, 7].map(corner => add(sides.map((side, axis) => corner >> axis & 1 ? side : 0), eye, -1));
  },
  // How far in front of the plane of the eye the volume's box begins.
  nearest() { return Math.min(...this.ways().map(way => dot(way, this.axes().front))); },
  // How wide a picture of height 1 must be to have the volume's box in it, and no more than the maker's camera has.
  widthOfBox() {
    const { front, right } = this.axes(), most = scene.camera.aspect;
    const wide = Math.max(...this.ways().map(way => {
      const half = this.isParallel ? this.half : dot(way, front) * this.tangent;
      return half > 0 ? Math.abs(dot(way, right)) / half * 1.04 : most;
    }));
    return Math.min(wide, most);
  },
  axes() {
    const [s, c, sp, cp] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    return { front: [cp * s, sp, cp * c], right: [-c, 0, s], up: [-sp * s, cp, -sp * c] };
  },
  eye() { return add(this.look, this.axes().front, -this.distance); },
  isInside() { return !this.isParallel && this.eye().every((value, axis) => value >= 0 && value < sides[axis]); },
  // A picture that is too narrow is taken with a wider angle, from outside also from further off.
  view(width, height) {
    const { front, right, up } = this.axes();
    const narrow = Math.max(1, this.wide * height / width);
    if (this.isParallel) {
      const [x, y] = [this.half * narrow * width / height, this.half * narrow];
      const further = this.hasAllInFront ? Math.max(size / 100 - this.nearest(), 0) : 0;
      return { eye: add(this.eye(), front, -further), front, right: right.map(v => v * x), up: up.map(v => v * y), isParallel: true };
    }
    const wider = Math.min(narrow, this.isInside() ? 1.7 : 1.3);
    const further = this.isInside() ? 0 : this.distance * (narrow / wider - 1);
    const [x, y] = [this.tangent * wider * width / height, this.tangent * wider];
    return { eye: add(this.eye(), front, -further), front, right: right.map(v => v * x), up: up.map(v => v * y), isParallel: false };
  },
  // Inside, the eye turns where it stands; outside, it goes around what it looks at.
  turn(yaw, pitch) {
    const eye = this.isInside() && this.eye();
    this.yaw += yaw;
    this.pitch = Math.min(Math.max(this.pitch + pitch, -Math.PI / 2), Math.PI / 2);
    if (eye) this.look = add(eye, this.axes().front, this.distance);
  },
  // By parts of how far off the eye is, but for steps of a size that one sees.
  move(x, y, z = 0) {
    const { front, right, up } = this.axes(), far = Math.max(this.reach(), this.isParallel ? 0 : size / 8);
    this.look = add(add(add(this.look, right, x * far), up, y * far), front, this.isParallel ? 0 : z * far);
    if (this.isParallel && z) this.approach(1 + z);
  },
  // Comes so many times as near; what is looked at recedes from an eye that would meet it. A camera that began further off stays there.
  approach(times) {
    if (this.isParallel) {
      this.half = Math.min(Math.max(this.half / times, Math.min(size / 10000, this.half)), Math.max(size * 20, this.half));
      return;
    }
    const least = size / 50, eye = this.eye();
    const next = this.distance / times;
    if (times > 1 && next < least) this.look = add(eye, this.axes().front, this.distance + least / 2);
    else this.distance = Math.min(next, Math.max(size * 20, this.distance));
  },
  aim(eye, look) {
    if (this.isParallel) {
      this.look = [...look];
      return;
    }
    const way = add(look, eye, -1), distance = Math.hypot(...way);
    if (!distance) return; // The eye stands in the voxel that is looked at: there is no direction.
    this.distance = distance;
    this.look = [...look];
    this.yaw = Math.atan2(way[0], way[2]);
    this.pitch = Math.asin(way[1] / this.distance);
  },
};
camera.reset();
