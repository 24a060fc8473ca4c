// Drawing by WebGPU: the same as by WebGL, but that the words of the volume lie in a buffer.

async function makeWebGpu() {
  const adapter = await navigator.gpu?.requestAdapter({ powerPreference: "high-performance" });
  if (!adapter) throw new Error("this browser has no WebGPU");
  const { maxBufferSize, maxStorageBufferBindingSize, maxTextureDimension2D } = adapter.limits, most = Math.min(maxBufferSize, maxStorageBufferBindingSize);
  if (words.byteLength > most) throw new Error(`the volume has ${words.length} words, and this device holds ${most / 4}`);
  const gpu = await adapter.requestDevice({ requiredLimits: { maxBufferSize, maxStorageBufferBindingSize, maxTextureDimension2D } });
  const { queue } = gpu, language = "wgsl", texts = shaders[language], context = canvas.getContext("webgpu");
  if (!context) throw new Error("this browser has no WebGPU");
  context.configure({ device: gpu, format: "rgba8unorm", alphaMode: "opaque" });
  gpu.lost.then(lossOf(canvas));
  let wordBuffer = null;

  // Waits until the device has done all that it was told, and tells how long that took in milliseconds.
  async function finished() {
    const begin = performance.now();
    await queue.onSubmittedWorkDone();
    return performance.now() - begin;
  }

  function constants() {
    const planes = scene.cuts.map(plane => `vec4f(${plane.map(number => number.toExponential())})`);
    return `const IS_LABEL = ${scene.labels};\nconst SPACING = vec3f(${scene.spacing});\n` +
      (planes.length ? `const PLANE_COUNT = ${planes.length};\nconst PLANES = array(${planes});\n` : "");
  }

  // The program of a pass; `functions` are those of the kernel. The page goes on while it is compiled.
  async function programOf(name, functions) {
    const { textures, traces, shows } = PASSES[name], visibility = GPUShaderStage.FRAGMENT;
    const code = texts.begin + textures.map((name, i) => `@group(0) @binding(${i + 2}) var ${name}: texture_2d<u32>;\n`).join("") +
      (traces ? constants() + functions : "") + texts[name];
    const module = gpu.createShaderModule({ code });
    const layout = gpu.createBindGroupLayout({ entries: [
      { binding: 0, visibility, buffer: { type: "uniform" } }, { binding: 1, visibility, buffer: { type: "read-only-storage" } },
      ...textures.map((_, i) => ({ binding: i + 2, visibility, texture: { sampleType: "uint" } }))] });
    const made = await gpu.createRenderPipelineAsync({
      layout: gpu.createPipelineLayout({ bindGroupLayouts: [layout] }), vertex: { module, entryPoint: "vertex" },
      fragment: { module, entryPoint: "fragment", targets: shows ? [{ format: "rgba8unorm" }] : [{ format: "rgba32uint" }, { format: "rgba32uint" }] },
    }).catch(async problem => {
      const [found] = (await module.getCompilationInfo()).messages.filter(({ type }) => type === "error");
      throw new Error("a shader was refused: " + (found ?? problem).message);
    });
    const values = new ArrayBuffer(16 * Math.ceil(givenWords / 4)), floats = new Float32Array(values), integers = new Int32Array(values);
    const given = gpu.createBuffer({ size: values.byteLength, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST });
    // Draws some rows of a target.
    return programFor(function (target, first = 0, rows = target.height) {
      for (const name in this.given) {
        const { setter, place } = givenMembers[name];
        (setter.endsWith("f") ? floats : integers).set([].concat(this.given[name]), place);
      }
      queue.writeBuffer(given, 0, values);
      const entries = [{ buffer: given }, { buffer: wordBuffer }, ...textures.map(name => this.taken[name].createView())]
        .map((resource, binding) => ({ binding, resource }));
      const encoder = gpu.createCommandEncoder();
      const pass = encoder.beginRenderPass({ colorAttachments: target.views().map(view => ({ view, loadOp: "load", storeOp: "store" })) });
      pass.setPipeline(made);
      pass.setBindGroup(0, gpu.createBindGroup({ layout, entries }));
      pass.setScissorRect(0, first, target.width, rows);
      pass.draw(3);
      pass.end();
      queue.submit([encoder.finish()]);
    });
  }

  const textureOf = (format, width, height) => gpu.createTexture({ format, size: [width, height],
    usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC | GPUTextureUsage.COPY_DST });

  // A texture of unsigned integers, four a place; `words` fills all of it.
  function integers(width, height, channels, words) {
    const texture = textureOf("rgba32uint", width, height);
    if (words) queue.writeTexture({ texture }, words, { bytesPerRow: 16 * width }, [width, height]);
    return texture;
  }

  function targetOf(...textures) {
    const [{ width, height }] = textures;
    return { textures, width, height, views: () => textures.map(texture => texture.createView()) };
  }

  // What stands in a texture of a target, once the device has drawn it: words, four a place, or bytes.
  async function contentsOf({ textures, width, height }, attachment = 0) {
    const texture = textures[attachment], isBytes = texture.format === "rgba8unorm", row = width * (isBytes ? 4 : 16);
    const bytesPerRow = Math.ceil(row / 256) * 256, contents = new Uint8Array(row * height);
    const buffer = gpu.createBuffer({ size: bytesPerRow * height, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
    const encoder = gpu.createCommandEncoder();
    encoder.copyTextureToBuffer({ texture }, { buffer, bytesPerRow }, [width, height]);
    queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const rows = new Uint8Array(buffer.getMappedRange());
    for (let i = 0; i < height; i++) contents.set(rows.subarray(bytesPerRow * i, bytesPerRow * i + row), row * i);
    buffer.destroy();
    return isBytes ? contents : new Uint32Array(contents.buffer);
  }

  // Has the device hold the words of the volume.
  function hold(words) {
    wordBuffer = gpu.createBuffer({ size: Math.max(words.byteLength, 4), usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST });
    queue.writeBuffer(wordBuffer, 0, words);
    return { bind() {}, showRoot: root => queue.writeBuffer(wordBuffer, 0, new Uint32Array([root])) };
  }

  return {
    name: "WebGPU", language, finished, programOf, integers, targetOf, contentsOf, hold,
    pictureOf: target => contentsOf(target),
    bytes: (width, height) => textureOf("rgba8unorm", width, height),
    screen: { get width() { return canvas.width; }, get height() { return canvas.height; }, views: () => [context.getCurrentTexture().createView()] },
    free: (...things) => things.forEach(thing => thing?.destroy?.()),
  };
}
