// Decoding through meshoptimizer, whose decoders take any bytes, but trust the numbers beside them.
#include "Mesh/Gltf/GltfMeshopt.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace voxc {

namespace {

/// No mode makes more of a byte: 16 equal bytes in a row take two bits.
constexpr std::uint64_t kMostAByte = 256;
constexpr std::uint64_t kFewBytes = 1 << 12;

struct BufferShape {
  std::uint64_t count = 0;
  std::uint64_t stride = 0;

  std::uint64_t bytes() const { return count * stride; }
};

struct Mode {
  std::string_view name;
  bool (*fits)(const BufferShape &shape);
  int (*decode)(void *target, const BufferShape &shape, std::span<const std::byte> bytes);
};

const unsigned char *dataOf(std::span<const std::byte> bytes) {
  return reinterpret_cast<const unsigned char *>(bytes.data());
}

bool fitsVertices(const BufferShape &shape) {
  return shape.stride % 4 == 0 && shape.stride >= 4 && shape.stride <= 256;
}
bool fitsIndices(const BufferShape &shape) { return shape.stride == 2 || shape.stride == 4; }
bool fitsTriangles(const BufferShape &shape) { return fitsIndices(shape) && shape.count % 3 == 0; }

constexpr std::array<Mode, 3> kModes{
    {{"ATTRIBUTES", fitsVertices,
      [](void *target, const BufferShape &shape, std::span<const std::byte> bytes) {
        return meshopt_decodeVertexBuffer(target, shape.count, shape.stride, dataOf(bytes), bytes.size());
      }},
     {"TRIANGLES", fitsTriangles,
      [](void *target, const BufferShape &shape, std::span<const std::byte> bytes) {
        return meshopt_decodeIndexBuffer(target, shape.count, shape.stride, dataOf(bytes), bytes.size());
      }},
     {"INDICES", fitsIndices, [](void *target, const BufferShape &shape, std::span<const std::byte> bytes) {
        return meshopt_decodeIndexSequence(target, shape.count, shape.stride, dataOf(bytes), bytes.size());
      }}}};

struct Filter {
  std::string_view name;
  bool (*fits)(std::uint64_t stride);
  void (*apply)(void *target, std::size_t count, std::size_t stride);
};

constexpr std::array<Filter, 4> kFilters{
    {{"NONE", [](std::uint64_t) { return true; }, [](void *, std::size_t, std::size_t) {}},
     {"OCTAHEDRAL", [](std::uint64_t stride) { return stride == 4 || stride == 8; }, meshopt_decodeFilterOct},
     {"QUATERNION", [](std::uint64_t stride) { return stride == 8; }, meshopt_decodeFilterQuat},
     {"EXPONENTIAL", [](std::uint64_t stride) { return stride % 4 == 0; }, meshopt_decodeFilterExp}}};

BufferShape shapeOfBuffer(const GltfObject &meshopt) {
  constexpr std::uint64_t kMost = 0xffffffff;
  return {std::min(meshopt.count("count").value_or(0), kMost),
          std::min(meshopt.count("byteStride").value_or(0), std::uint64_t{256})};
}

} // namespace

GltfObject meshoptOf(const GltfObject &view) {
  GltfObject known = view.extension("EXT_meshopt_compression");
  return known ? known : view.extension("KHR_meshopt_compression");
}

std::uint64_t meshoptBytes(const GltfObject &meshopt, std::uint64_t compressed) {
  const std::uint64_t bytes = shapeOfBuffer(meshopt).bytes();
  if (bytes <= kFewBytes + kMostAByte * compressed)
    return bytes;
  meshopt.problem("claims " + std::to_string(bytes) + " bytes, more than its " + std::to_string(compressed) +
                  " compressed ones can hold");
  return 0;
}

std::shared_ptr<const ScratchArray<std::byte>> decodeMeshopt(const GltfObject &meshopt,
                                                             std::span<const std::byte> compressed,
                                                             const std::shared_ptr<WorkingMemory> &memory,
                                                             Problem &problem) {
  const BufferShape shape = shapeOfBuffer(meshopt);
  const std::string_view filterName = meshopt.has("filter") ? meshopt.text("filter") : "NONE";
  const auto *mode = std::ranges::find(kModes, meshopt.text("mode"), &Mode::name);
  const auto *filter = std::ranges::find(kFilters, filterName, &Filter::name);
  if (mode == kModes.end() || filter == kFilters.end() || !mode->fits(shape) || !filter->fits(shape.stride)) {
    meshopt.problem("has a mode, a filter or a byteStride that is not known, or that do not go together");
    return nullptr;
  }
  const std::uint64_t bytes = meshoptBytes(meshopt, compressed.size());
  ScratchArray<std::byte> target(memory);
  if (auto resized = target.resize(bytes); !resized) {
    problem.set(resized.error());
    return nullptr;
  }
  if (bytes != 0 && mode->decode(target.data(), shape, compressed) != 0) {
    meshopt.problem("has compressed bytes that are broken");
    return nullptr;
  }
  if (bytes != 0)
    filter->apply(target.data(), shape.count, shape.stride);
  return std::make_shared<const ScratchArray<std::byte>>(std::move(target));
}

} // namespace voxc
