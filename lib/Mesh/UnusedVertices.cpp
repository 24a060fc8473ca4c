// Marking the vertices that indices name.
#include "Mesh/UnusedVertices.h"

#include <algorithm>
#include <bit>
#include <tuple>
#include <vector>

namespace voxc {

namespace {

constexpr std::uint64_t kIndicesBetweenLooks = 1 << 14;

/// Parts that share their vertices stand together in this order; of them those that share indices, too.
auto keyOf(const MeshPart &part) {
  const AttributeView &at = part.positions, &by = part.indices;
  return std::tuple(at.data, at.count, at.stride, at.type, by.data, by.count, by.stride, by.type);
}

bool haveSameVertices(const MeshPart &a, const MeshPart &b) {
  return a.positions.data == b.positions.data && a.positions.count == b.positions.count &&
         a.positions.stride == b.positions.stride && a.positions.type == b.positions.type;
}

/// A bit for each vertex.
class VertexMarks {
public:
  explicit VertexMarks(const MeshInput &input) : input_(input), words_(input.memory) {}

  Expected<void> begin(std::uint64_t vertices) {
    vertices_ = vertices;
    VOXC_TRY(words_.resize(0));
    return words_.resize(vertices / 64 + 1);
  }

  Expected<void> add(const AttributeView &indices) {
    for (std::uint64_t i = 0; i < indices.count; ++i) {
      if (i % kIndicesBetweenLooks == 0 && !input_.at(i, indices.count))
        return Error::interrupted();
      const std::uint32_t vertex = readIndex(indices, i);
      words_[vertex / 64] |= std::uint64_t{1} << vertex % 64;
    }
    return {};
  }

  std::uint64_t unmarked() const {
    std::uint64_t count = vertices_;
    for (const std::uint64_t word : words_.span())
      count -= static_cast<std::uint64_t>(std::popcount(word));
    return count;
  }

private:
  const MeshInput &input_;
  ScratchArray<std::uint64_t> words_;
  std::uint64_t vertices_ = 0;
};

} // namespace

std::string saysUnused(std::uint64_t vertices) {
  return vertices == 1
             ? "1 vertex is left out, which no face, line or point has"
             : std::to_string(vertices) + " vertices are left out, which no face, line or point has";
}

Expected<void> warnOfUnused(TriangleScene &scene, const MeshInput &input) {
  std::vector<const MeshPart *> parts;
  parts.reserve(scene.parts.size());
  for (const MeshPart &part : scene.parts)
    parts.push_back(&part);
  std::ranges::sort(parts, {}, [](const MeshPart *part) { return keyOf(*part); });
  VertexMarks marks(input);
  std::uint64_t unused = 0;
  for (auto first = parts.begin(), end = first; first != parts.end(); first = end) {
    end = std::find_if(first, parts.end(),
                       [&](const MeshPart *part) { return !haveSameVertices(*part, **first); });
    if (std::any_of(first, end, [](const MeshPart *part) { return !part->indices; }))
      continue;
    VOXC_TRY(marks.begin((*first)->positions.count));
    for (auto part = first; part != end; ++part)
      if (part == first || keyOf(**part) != keyOf(**(part - 1)))
        VOXC_TRY(marks.add((*part)->indices));
    unused += marks.unmarked();
  }
  if (unused != 0)
    scene.warnings.push_back(saysUnused(unused));
  return {};
}

} // namespace voxc
