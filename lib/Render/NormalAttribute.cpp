// Normals by the numbers of voxels.
#include "voxc/Render/NormalAttribute.h"

#include "voxc/Render/SurfaceNormals.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/packing.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <cstring>

namespace voxc {
namespace {

constexpr std::uint32_t kNoNormal = 0x80008000u;

/// Voxels whose normals are found at once, on all threads.
constexpr std::size_t kBatch = std::size_t{1} << 18;

/// Turns the corners of the square in, or out again: the lower half of the octahedron.
glm::vec2 folded(const glm::vec2 &place) {
  return {(1 - std::abs(place.y)) * (place.x < 0 ? -1.0f : 1.0f),
          (1 - std::abs(place.x)) * (place.y < 0 ? -1.0f : 1.0f)};
}

glm::vec3 outwards(const SurfaceNormal &normal) {
  return normal.roomAgainst > normal.roomAlong ? -normal.direction : normal.direction;
}

/// Finds those of a batch of voxels and puts them behind the others.
class NormalWriter {
public:
  NormalWriter(const Volume &volume, unsigned threads, const Progress &progress,
               std::vector<std::byte> elements)
      : normals_(volume, threads), progress_(progress), elements_(std::move(elements)) {}

  void add(Int3 voxel, std::uint64_t number) {
    Hit hit{};
    hit.voxel[0] = voxel.x;
    hit.voxel[1] = voxel.y;
    hit.voxel[2] = voxel.z;
    hit.t = 0;
    hits_.push_back(hit);
    numbers_.push_back(number);
    if (hits_.size() == kBatch)
      write();
  }

  std::vector<std::byte> finish() {
    write();
    return std::move(elements_);
  }

private:
  void write() {
    if (!normals_.learn(hits_, progress_))
      return; // Stopped; so is the visit of the voxels.
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      const std::uint32_t packed = packNormal(outwards(normals_.at(hits_[i])));
      std::memcpy(&elements_[numbers_[i] * sizeof packed], &packed, sizeof packed);
    }
    hits_.clear();
    numbers_.clear();
  }

  SurfaceNormals normals_;
  const Progress &progress_;
  std::vector<Hit> hits_;
  std::vector<std::uint64_t> numbers_; ///< Of their voxels.
  std::vector<std::byte> elements_;
};

} // namespace

std::uint32_t packNormal(const glm::vec3 &direction) {
  const float sum = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
  if (!(sum > 0))
    return kNoNormal;
  const glm::vec2 place = glm::vec2(direction.x, direction.y) / sum;
  return glm::packSnorm2x16(direction.z < 0 ? folded(place) : place);
}

glm::vec3 unpackNormal(std::uint32_t packed) {
  if (packed == kNoNormal)
    return {};
  const glm::vec2 place = glm::unpackSnorm2x16(packed);
  const float z = 1 - std::abs(place.x) - std::abs(place.y);
  const glm::vec2 level = z < 0 ? folded(place) : place;
  return glm::normalize(glm::vec3(level, z));
}

Expected<Attribute> normalAttribute(const Volume &volume, unsigned threads, const Progress &progress,
                                    std::uint64_t mostBytes) {
  auto elements = VOXC_TRY(zeroElements(volume, sizeof(std::uint32_t), mostBytes));
  NormalWriter writer(volume, threads, progress, std::move(elements));
  const auto visited = visitVoxels(
      volume,
      [&](Int3 voxel, std::uint64_t number) {
        writer.add(voxel, number);
        return !progress.stopped();
      },
      progress);
  if (!visited)
    return visited.error();
  Attribute attribute{"normal", sizeof(std::uint32_t), writer.finish()};
  if (progress.stopped())
    return Error::interrupted();
  return attribute;
}

} // namespace voxc
