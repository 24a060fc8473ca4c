// On a screen rows go down.
@fragment fn fragment(@builtin(position) at: vec4<f32>) -> @location(0) vec4<f32> {
  return vec4<f32>(colour_at(vec2<f32>(at.x, given.canvas.y - at.y)), 1.0);
}
