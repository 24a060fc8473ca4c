// What shaders find in WebGPU.
@group(0) @binding(0) var<uniform> given: Given;
@group(0) @binding(1) var<storage, read> words: array<u32>;

fn voxc_scene_word(volume: u32, index: u32) -> u32 { return words[index]; }

fn texelFetch(texels: texture_2d<u32>, at: vec2<i32>, level: i32) -> vec4<u32> { return textureLoad(texels, at, level); }

// One triangle around the whole picture.
@vertex fn vertex(@builtin(vertex_index) i: u32) -> @builtin(position) vec4<f32> {
  return vec4<f32>(select(-1.0, 3.0, i == 1u), select(-1.0, 3.0, i == 2u), 0.0, 1.0);
}
