// host-device FILE.png [WIDTH HEIGHT]: an engine's frame with two volumes of different formats in it. The
// engine owns the device, the buffers and the command buffer; voxc records its traces between the engine's
// own shaders.
#include "Engine.h"
#include "Models.h"
#include "rays_spirv.h"
#include "shade_spirv.h"

#include <voxc/Construct/Constructor.h>
#include <voxc/Kernel/Compile.h>
#include <voxc/Source/Sources.h>
#include <voxc/Trace/Recorder.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <png.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>

namespace {

constexpr int kVolumes = 2;

/// As in frame.glsl.
struct Frame {
  glm::mat4 toVolume[kVolumes];
  glm::vec4 eye, right, up, forward;
  std::uint32_t width, height, raysOfVolume, unused;
};

/// A volume and its kernel on the engine's device.
struct Model {
  voxc::DeviceVolume volume;
  voxc::TraceRecorder recorder;
};

template <typename Value> Value take(voxc::Expected<Value> value) {
  if (value)
    return std::move(*value);
  std::fprintf(stderr, "host-device: %s\n", value.error().message.c_str());
  std::exit(1);
}

/// Builds a volume, brings it to the device, and compiles its kernel, which tells of each hit the face too.
Model makeModel(voxc::Device &device, const char *text, voxc::VoxelSource &source) {
  const voxc::Format format = take(voxc::parseFormat(text));
  const voxc::Built built = take(take(voxc::Constructor::compile(format)).build(source));
  const auto addressing = device.addressingFor(built.volume.words().size());
  const voxc::Kernel kernel = take(voxc::compileKernel(
      format,
      {.addressing = addressing, .loops = device.info().loops, .arithmetic = device.info().arithmetic}));
  std::printf("%s: %llu voxels\n", voxc::toString(format).c_str(),
              static_cast<unsigned long long>(built.report.voxels));
  return {take(voxc::DeviceVolume::upload(device, built.volume, addressing)),
          take(voxc::TraceRecorder::create(device, kernel))};
}

/// Where the models stand: the sponge turned a little, with the ring around it.
Frame makeFrame(std::uint32_t width, std::uint32_t height) {
  const glm::mat4 sponge =
      glm::translate(glm::rotate(glm::mat4(1), 0.5f, glm::vec3(0, 1, 0)), glm::vec3(-40.5f));
  const glm::mat4 ring =
      glm::translate(glm::rotate(glm::scale(glm::mat4(1), glm::vec3(1.2f)), 1.3f, glm::vec3(1, 0.25f, 0)),
                     -0.5f * glm::vec3(kRingSize.x, kRingSize.y, kRingSize.z));
  const glm::vec3 eye(50, 90, 160);
  const glm::vec3 forward = glm::normalize(-eye);
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
  const float halfHeight = 0.5f;
  const float halfWidth = halfHeight * static_cast<float>(width) / static_cast<float>(height);
  // Rays of a volume begin at a multiple of 32, that is of 768 bytes: storage buffers may begin there
  // anywhere.
  return {.toVolume = {glm::inverse(sponge), glm::inverse(ring)},
          .eye = glm::vec4(eye, 0),
          .right = glm::vec4(right * halfWidth, 0),
          .up = glm::vec4(glm::cross(right, forward) * halfHeight, 0),
          .forward = glm::vec4(forward, 0),
          .width = width,
          .height = height,
          .raysOfVolume = (width * height + 31) / 32 * 32,
          .unused = 0};
}

/// The share of a buffer that belongs to a volume.
voxc::BufferRange part(const Engine::Buffer &buffer, int volume) {
  const VkDeviceSize bytes = buffer.bytes / kVolumes;
  return {buffer.buffer, volume * bytes, bytes};
}

bool writePng(const char *path, const Frame &frame, const void *pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = frame.width;
  image.height = frame.height;
  image.format = PNG_FORMAT_RGBA;
  return png_image_write_to_file(&image, path, 0, pixels, 0, nullptr) != 0;
}

} // namespace

int main(int count, char **arguments) {
  if (count != 2 && count != 4) {
    std::fprintf(stderr, "usage: host-device FILE.png [WIDTH HEIGHT]\n");
    return 2;
  }
  const auto number = [&](int i, std::uint32_t fallback) {
    return count == 4 ? std::clamp<std::uint32_t>(std::strtoul(arguments[i], nullptr, 10), 1, 8192)
                      : fallback;
  };
  const Frame frame = makeFrame(number(2, 640), number(3, 360));

  Engine engine;
  voxc::Device device = take(voxc::adoptDevice(engine.host()));
  const Model models[kVolumes] = {
      makeModel(device, "format face=yes { level 1: svdag(7) }",
                *voxc::makeFunctionSource(kSpongeSize, spongeVoxel)),
      makeModel(device, "format face=yes { level 1: distance(4, 4, 2, 6) level 2: masked(3, 3, 3) }",
                *voxc::makeFunctionSource(kRingSize, ringVoxel))};

  // The engine's buffers, each shared by both volumes, and what voxc makes of them once.
  const VkDeviceSize rays = frame.raysOfVolume;
  const VkDeviceSize scratch = (voxc::scratchBytes(rays) + 255) / 256 * 256;
  const std::array buffers{engine.makeBuffer(sizeof frame),
                           engine.makeBuffer(kVolumes * rays * sizeof(voxc::Ray)),
                           engine.makeBuffer(kVolumes * rays * sizeof(voxc::Hit)),
                           engine.makeBuffer(rays * sizeof(std::uint32_t))};
  const auto left = engine.makeBuffer(kVolumes * scratch,
                                      VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  engine.bind(buffers);
  const VkPipeline makeRays = engine.makePipeline(rays_spirv);
  const VkPipeline shade = engine.makePipeline(shade_spirv);
  std::array<std::optional<voxc::BoundTrace>, kVolumes> bound;
  std::array<voxc::RecordedTrace, kVolumes> traces;
  for (int i = 0; i < kVolumes; ++i) {
    bound[i].emplace(take(models[i].recorder.bind(
        models[i].volume,
        {.rays = part(buffers[1], i), .hits = part(buffers[2], i), .scratch = part(left, i)})));
    traces[i] = {.trace = &*bound[i], .rays = frame.width * frame.height};
  }

  // The frame: rays, both traces, and light, in one command buffer.
  *static_cast<Frame *>(buffers[0].mapped) = frame;
  engine.drawFrame([&](VkCommandBuffer commands) {
    const std::uint32_t x = (frame.width + 7) / 8, y = (frame.height + 7) / 8;
    engine.dispatch(commands, makeRays, x, y, kVolumes);
    Engine::barrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT);
    if (const auto recorded = voxc::recordTraces(commands, traces); !recorded) {
      std::fprintf(stderr, "host-device: %s\n", recorded.error().message.c_str());
      std::exit(1);
    }
    Engine::barrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT);
    engine.dispatch(commands, shade, x, y, 1);
    Engine::barrier(commands, VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
  });

  if (!writePng(arguments[1], frame, buffers[3].mapped)) {
    std::fprintf(stderr, "host-device: %s cannot be written\n", arguments[1]);
    return 1;
  }
  std::printf("%u x %u pixels in %s\n", frame.width, frame.height, arguments[1]);
}
