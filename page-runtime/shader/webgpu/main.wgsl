struct Targets {
  @location(0) first: vec4<u32>,
  @location(1) second: vec4<u32>,
}

@fragment fn fragment(@builtin(position) at: vec4<f32>) -> Targets {
  let texels = texels_at(vec2<i32>(at.xy));
  return Targets(texels.first, texels.second);
}
