// engine FOLDER NAME [WIDTH HEIGHT]: a picture of chunks of voxels beside a triangle mesh, by a ray-tracing
// pipeline whose intersection shaders are voxc's. FOLDER has the chunks, as chunks.py makes them; none is
// loaded before a ray meets its box. Writes NAME.png, and the rays and hits in NAME.rays and NAME.hits.
#include "Pipeline.h"
#include "Scene.h"
#include "voxc_dag.h"
#include "voxc_grid.h"

#include <voxc/Trace/Ray.h>
#include <voxc/Volume/Volume.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <png.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

/// As in shared.glsl.
struct Answer {
  std::int32_t voxel[3];
  std::uint32_t colour;
  glm::vec3 normal;
  float t;
};

/// The first records of hits; those behind them are of chunks.
enum Record : std::uint32_t { kMeshRecord, kMissingRecord, kChunkRecords };

struct Chunk {
  Place place;
  std::string path;
  bool isLoaded = false;
};

/// Chunks are told by their names: chunk-X-Y-Z.hvx.
std::vector<Chunk> chunksIn(const char *folder) {
  std::vector<Chunk> found;
  std::error_code problem;
  for (const auto &entry : std::filesystem::directory_iterator(folder, problem)) {
    Chunk chunk{.path = entry.path().string()};
    auto &[x, y, z] = chunk.place;
    if (std::sscanf(entry.path().filename().c_str(), "chunk-%d-%d-%d.hvx", &x, &y, &z) == 3)
      found.push_back(chunk);
  }
  if (found.empty())
    fail("the folder has no chunks; python3 chunks.py FOLDER makes some");
  std::ranges::sort(found, {}, &Chunk::path);
  return found;
}

/// A volume's words on the device, and the shaders that read them.
void load(Device &device, Pipeline &pipeline, const Chunk &chunk, std::uint32_t record) {
  const auto volume = voxc::Volume::load(chunk.path);
  if (!volume)
    fail(volume.error().message.c_str());
  const std::uint64_t digest = volume->storageDigest();
  if (digest != VOXC_DAG_STORAGE_DIGEST && digest != VOXC_GRID_STORAGE_DIGEST)
    fail((chunk.path + " is of a format that the pipeline has no shaders for").c_str());
  const auto words = volume->words();
  const Buffer buffer = device.makeBuffer(words.size_bytes());
  std::memcpy(buffer.mapped, words.data(), words.size_bytes());
  pipeline.setRecord(record, digest == VOXC_DAG_STORAGE_DIGEST ? Group::Dag : Group::Grid, buffer.address);
}

/// A ray for each pixel. Origins are multiples of 1/4, so that moving one to a chunk rounds nothing, and hits
/// are those of the undivided volume, bit for bit.
std::vector<voxc::Ray> makeRays(std::uint32_t width, std::uint32_t height) {
  const glm::vec3 eye(170.25f, 130.5f, 190.75f), target(60, 30, 56), up(0, 1, 0);
  const glm::vec3 forward = glm::normalize(target - eye), right = glm::normalize(glm::cross(forward, up));
  const glm::vec3 above = glm::cross(right, forward);
  std::vector<voxc::Ray> rays;
  for (std::uint32_t i = 0; i < width * height; ++i) {
    const float x = (float(2 * (i % width)) + 1 - float(width)) / float(height);
    const float y = 1 - (float(2 * (i / width)) + 1) / float(height);
    const glm::vec3 direction = forward + 0.5f * (x * right + y * above);
    rays.push_back({{eye.x, eye.y, eye.z}, {direction.x, direction.y, direction.z}});
  }
  return rays;
}

std::uint32_t pixel(const Answer &answer) {
  if (answer.t == 0)
    return 0xfff0d0b0;
  const float light = 0.4f + 0.6f * std::max(0.0f, glm::dot(answer.normal, glm::vec3(0.45f, 0.8f, 0.4f)));
  std::uint32_t word = 0xff000000;
  for (int shift = 0; shift < 24; shift += 8)
    word |= static_cast<std::uint32_t>(std::min(255.0f, light * float(answer.colour >> shift & 0xff)))
            << shift;
  return word;
}

/// Hits as `voxc trace` writes them, with 2 in place of the steps where the mesh was met, and 1 of a voxel.
void writeHits(const std::string &path, std::span<const Answer> answers) {
  std::ofstream file(path, std::ios::binary);
  for (const Answer &answer : answers) {
    const std::uint32_t kind = answer.voxel[0] >= 0 ? 1 : answer.t > 0 ? 2 : 0;
    file.write(reinterpret_cast<const char *>(&answer.voxel), 16);
    file.write(reinterpret_cast<const char *>(&answer.t), 4).write(reinterpret_cast<const char *>(&kind), 4);
  }
  if (!file.flush())
    fail((path + " cannot be written").c_str());
}

void writePng(const std::string &path, std::span<const Answer> answers, std::uint32_t width,
              std::uint32_t height) {
  std::vector<std::uint32_t> pixels;
  for (const Answer &answer : answers)
    pixels.push_back(pixel(answer));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = PNG_FORMAT_RGBA;
  if (png_image_write_to_file(&image, path.c_str(), 0, pixels.data(), 0, nullptr) == 0)
    fail((path + " cannot be written").c_str());
}

/// Traces all rays, again and again, until none asks for a chunk that is not there.
void drawFrames(Device &device, Pipeline &pipeline, Scene &scene, std::span<Chunk> chunks,
                const Buffer &wanted, std::uint32_t rays) {
  std::size_t loaded = 0, before = 0;
  int frame = 0;
  do {
    before = loaded;
    std::memset(wanted.mapped, 0, chunks.size() * sizeof(std::uint32_t));
    const auto begin = std::chrono::steady_clock::now();
    device.run([&](VkCommandBuffer commands) {
      scene.build(commands);
      pipeline.trace(commands, rays);
    });
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
    for (std::uint32_t i = 0; i < chunks.size(); ++i) {
      if (static_cast<const std::uint32_t *>(wanted.mapped)[i] == 0 || chunks[i].isLoaded)
        continue;
      load(device, pipeline, chunks[i], kChunkRecords + i);
      scene.setRecord(i, kChunkRecords + i);
      chunks[i].isLoaded = true;
      ++loaded;
    }
    std::printf("frame %d: %.2f ms, rays asked for %zu chunks\n", ++frame, passed.count(), loaded - before);
  } while (loaded > before);
  std::printf("%zu of %zu chunks loaded\n", loaded, chunks.size());
}

} // namespace

int main(int count, char **arguments) {
  const bool isHelp = count == 2 && std::strcmp(arguments[1], "--help") == 0;
  if (count != 3 && count != 5) {
    std::fprintf(isHelp ? stdout : stderr, "usage: engine FOLDER NAME [WIDTH HEIGHT]\n");
    return isHelp ? 0 : 2;
  }
  const auto number = [&](int i, std::uint32_t usual) {
    return count == 5 ? std::clamp<std::uint32_t>(std::strtoul(arguments[i], nullptr, 10), 1, 8192) : usual;
  };
  const std::uint32_t width = number(3, 640), height = number(4, 360);
  const std::string name = arguments[2];
  std::vector<Chunk> chunks = chunksIn(arguments[1]);
  std::vector<Place> places;
  for (const Chunk &chunk : chunks)
    places.push_back(chunk.place);

  Device device;
  Scene scene(device, places);
  Pipeline pipeline(device, kChunkRecords + static_cast<std::uint32_t>(chunks.size()));
  pipeline.setRecord(kMeshRecord, Group::Mesh);
  pipeline.setRecord(kMissingRecord, Group::Missing);
  const std::vector<voxc::Ray> rays = makeRays(width, height);
  const Buffer asked = device.makeBuffer(rays.size() * sizeof(voxc::Ray));
  const Buffer answered = device.makeBuffer(rays.size() * sizeof(Answer), 0, Device::Reader::Host);
  const Buffer wanted = device.makeBuffer(chunks.size() * sizeof(std::uint32_t), 0, Device::Reader::Host);
  std::memcpy(asked.mapped, rays.data(), rays.size() * sizeof(voxc::Ray));
  pipeline.bind(scene.structure(), asked, answered, wanted);
  drawFrames(device, pipeline, scene, chunks, wanted, static_cast<std::uint32_t>(rays.size()));

  const std::span<const Answer> answers(static_cast<const Answer *>(answered.mapped), rays.size());
  std::ofstream(name + ".rays", std::ios::binary)
      .write(reinterpret_cast<const char *>(rays.data()),
             static_cast<std::streamsize>(rays.size() * sizeof(voxc::Ray)));
  writeHits(name + ".hits", answers);
  writePng(name + ".png", answers, width, height);
}
