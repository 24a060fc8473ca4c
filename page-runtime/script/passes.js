// What all devices know of passes. A device is what makeWebGpu or makeWebGl gives; both draw the same passes by shaders of their own language.

let canvas = document.querySelector("canvas");
const sleep = milliseconds => new Promise(done => setTimeout(done, milliseconds));
const nextFrame = () => new Promise(requestAnimationFrame);

// By the names that shaders have for them: the textures that a pass takes; whether it traces rays, or makes what a screen shows.
const PASSES = {
  picture: { textures: ["before_sun", "before_sky"], traces: true },
  sketch: { textures: ["before_sun", "before_sky"], traces: true },
  answer: { textures: ["rays"], traces: true },
  develop: { textures: ["sun_light", "sky_light", "told"], shows: true },
  arithmetic: { textures: ["pairs"] },
  collect: { textures: ["told"] },
};

// The members of the struct Given: how a uniform of each is set, and at which word of a buffer it lies (the layout std140).
const KINDS = { float: ["1f", 1], int: ["1i", 1], vec2: ["2f", 2], ivec2: ["2i", 2], uvec2: ["2ui", 2], vec3: ["3f", 3] };
const givenMembers = {};
let givenWords = 0;
for (const [, kind, name] of shaders.given.split("}")[0].matchAll(/(\w+) (\w+);/g)) {
  const [setter, size] = KINDS[kind], step = size === 3 ? 4 : size, place = Math.ceil(givenWords / step) * step;
  givenMembers[name] = { setter, place };
  givenWords = place + size;
}

// A program that `draw` draws: what it is given and takes stays until it is given other things.
const programFor = draw => ({
  given: {}, taken: {}, draw,
  give(values) { Object.assign(this.given, values); return this; },
  take(textures) { Object.assign(this.taken, textures); return this; },
});
