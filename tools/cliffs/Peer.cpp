// Building and running the program of another tracer.
#include "Peer.h"

#include "Scenes.h"

#include "voxc/Support/EmbeddedFile.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace voxc {

/// The program around a tracer, in C++.
std::span<const EmbeddedFile> peerFiles();

} // namespace voxc

namespace voxc::cliffs {
namespace {

constexpr int kLeastEdge = 4, kMostEdge = 512;
constexpr std::size_t kFewestRays = 1000, kMostRays = 300000;

void collect(VoxelSource &source, const Cube &cube, std::vector<std::int32_t> &voxels) {
  if (source.empty(cube))
    return;
  if (cube.log2Side > 3) {
    const int half = 1 << (cube.log2Side - 1);
    for (int octant = 0; octant < 8; ++octant)
      collect(source, {cube.low + Int3{octant & 1, octant >> 1 & 1, octant >> 2} * half, cube.log2Side - 1},
              voxels);
    return;
  }
  std::array<std::uint32_t, 512> words{};
  if (!source.read(cube, words.data()))
    return;
  for (std::uint64_t code = 0; code < std::uint64_t{1} << (3 * cube.log2Side); ++code)
    if (words[code] != 0)
      for (int axis = 0; axis < 3; ++axis)
        voxels.push_back(cube.low[axis] + static_cast<int>(gatherBits(code >> axis)));
}

template <typename Item> void write(std::ofstream &file, std::span<const Item> items) {
  file.write(reinterpret_cast<const char *>(items.data()), static_cast<std::streamsize>(items.size_bytes()));
}

} // namespace

Expected<Peer> Peer::build(const std::string &folder) {
  std::string room = (std::filesystem::temp_directory_path() / "voxc-peer-XXXXXX").string();
  if (!::mkdtemp(room.data()))
    return Error::environment("no folder can be made for the other tracer");
  Peer peer(room);
  std::ofstream(room + "/tree64.cpp") << peerFiles().front().text;
  const std::string command = "c++ -O3 -march=native -std=c++20 '-DVOXC_PEER=\"" +
                              std::filesystem::absolute(folder).string() + "/t_own.cpp\"' '" + room +
                              "/tree64.cpp' -o '" + room + "/tree64' -pthread";
  if (std::system(command.c_str()) != 0)
    return Error::environment("the tracer of " + folder + " cannot be built");
  return peer;
}

Peer::Peer(Peer &&other) noexcept : room_(std::exchange(other.room_, {})) {}

Peer::~Peer() {
  std::error_code ignored;
  if (!room_.empty())
    std::filesystem::remove_all(room_, ignored);
}

std::optional<double> Peer::nanoseconds(const Stage &stage, const std::vector<Ray> &rays) const {
  const Int3 extent = stage.place.extent;
  int edge = kLeastEdge, log2Edge = 2;
  for (; edge < std::max({extent.x, extent.y, extent.z}); edge *= 2)
    ++log2Edge;
  if (edge > kMostEdge || rays.size() < kFewestRays)
    return std::nullopt;
  const auto source = openScene(stage.place.scene, extent);
  if (!source)
    return std::nullopt;
  std::vector<std::int32_t> voxels{edge, 0};
  collect(**source, {{}, log2Edge}, voxels);
  voxels[1] = static_cast<std::int32_t>((voxels.size() - 2) / 3);
  const std::string path = room_ + "/rays";
  {
    std::ofstream file(path, std::ios::binary);
    const std::uint64_t count = std::min(rays.size(), kMostRays);
    write<std::int32_t>(file, voxels);
    write<std::uint64_t>(file, std::array{count});
    write<Ray>(file, std::span(rays).first(count));
  }
  FILE *const output = ::popen(("'" + room_ + "/tree64' '" + path + "'").c_str(), "r");
  if (!output)
    return std::nullopt;
  double time = 0;
  const bool isRead = std::fscanf(output, "%lf", &time) == 1;
  return ::pclose(output) == 0 && isRead ? std::optional(time) : std::nullopt;
}

} // namespace voxc::cliffs
