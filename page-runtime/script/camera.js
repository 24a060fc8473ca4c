// Where the picture is taken from: a place that is looked at, a direction, and how far off the eye is. All of it is in spaced space: that of
// voxels, stretched to their sides.

const extent = scene.extent, spacing = scene.spacing;
const sides = extent.map((side, axis) => side * spacing[axis]), size = Math.max(...sides);
const add = (a, b, times = 1) => a.map((value, axis) => value + b[axis] * times);
const dot = (a, b) => a.reduce((sum, value, axis) => sum + value * b[axis], 0);
const camera = {
  // The camera of the page's maker.
  reset() {
    const { eye, look, up, fov } = scene.camera;
    this.aim(eye, look);
    // Straight down or up, the way up tells where the right is: along the way x up.
    const way = add(look, eye, -1), [x, z] = [way[1] * up[2] - way[2] * up[1], way[0] * up[1] - way[1] * up[0]];
    if (x || z) this.yaw = Math.atan2(z, -x);
    this.tangent = Math.tan(fov * Math.PI / 360);
    this.wide = this.widthOfBox();
  },
  // How wide a picture must be to have the volume's box in it, per unit of distance: half of that, and no more than the maker's camera has.
  widthOfBox() {
    const { front, right } = this.axes(), eye = this.eye(), most = this.tangent * scene.camera.aspect;
    let wide = 0;
    for (let corner = 0; corner < 8; corner++) {
      const way = add(sides.map((side, axis) => corner >> axis & 1 ? side : 0), eye, -1);
      const far = dot(way, front);
      wide = Math.max(wide, far > 0 ? Math.abs(dot(way, right)) / far * 1.04 : most);
    }
    return Math.min(wide, most);
  },
  axes() {
    const [s, c, sp, cp] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    return { front: [cp * s, sp, cp * c], right: [-c, 0, s], up: [-sp * s, cp, -sp * c] };
  },
  eye() { return add(this.look, this.axes().front, -this.distance); },
  isInside() { return this.eye().every((value, axis) => value >= 0 && value < sides[axis]); },
  // A picture that is too narrow is taken with a wider angle, from outside also from further off.
  view(width, height) {
    const { front, right, up } = this.axes();
    const narrow = Math.max(1, this.wide / this.tangent * height / width);
    const wider = Math.min(narrow, this.isInside() ? 1.7 : 1.3);
    const further = this.isInside() ? 0 : this.distance * (narrow / wider - 1);
    const [x, y] = [this.tangent * wider * width / height, this.tangent * wider];
    return { eye: add(this.eye(), front, -further), front, right: right.map(v => v * x), up: up.map(v => v * y) };
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
    const { front, right, up } = this.axes(), far = Math.max(this.distance, size / 8);
    this.look = add(add(add(this.look, right, x * far), up, y * far), front, z * far);
  },
  // Comes so many times as near; what is looked at recedes from an eye that would meet it.
  approach(times) {
    const least = size / 50, eye = this.eye();
    const next = this.distance / times;
    if (times > 1 && next < least) this.look = add(eye, this.axes().front, this.distance + least / 2);
    else this.distance = Math.min(next, size * 20);
  },
  aim(eye, look) {
    const way = add(look, eye, -1);
    this.distance = Math.hypot(...way);
    this.look = [...look];
    this.yaw = Math.atan2(way[0], way[2]);
    this.pitch = Math.asin(way[1] / this.distance);
  },
};
camera.reset();
