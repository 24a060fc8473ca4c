// Looking at every number of a scene once.
#include "Mesh/NumberCheck.h"

#include "Support/Problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace voxc {

namespace {

constexpr std::uint64_t kNumbersBetweenLooks = 1024;

/// Tells views apart by the rows that they show.
using ViewKey = std::tuple<const std::byte *, std::uint64_t, std::uint32_t, AttributeView::Type>;

ViewKey keyOf(const AttributeView &view) { return {view.data, view.count, view.stride, view.type}; }

class NumberChecker {
public:
  NumberChecker(const TriangleScene &scene, const MeshInput &input) : scene_(scene), input_(input) {}

  Expected<void> check() {
    VOXC_TRY(checkCounts());
    for (std::size_t i = 0; i < scene_.parts.size() && !problem_; ++i) {
      checkPositions(scene_.parts[i], i);
      if (scene_.parts[i].indices)
        checkIndices(scene_.parts[i], i);
    }
    return problem_ ? Expected<void>(problem_.error()) : Expected<void>();
  }

private:
  Expected<void> checkCounts() const {
    std::uint64_t triangles = 0;
    for (const MeshInstance &instance : scene_.instances) {
      triangles += scene_.parts[instance.part].triangles();
      if (triangles > std::numeric_limits<std::uint32_t>::max())
        return Error::input("it has 2^32 triangles or more, its instances counted one by one");
    }
    if (triangles == 0)
      return Error::input("it has no triangle");
    return {};
  }

  /// Calls `look(row)` for all rows; false if the work shall stop.
  template <typename Look> bool forRows(const AttributeView &view, const Look &look) {
    for (std::uint64_t begin = 0; begin < view.count; begin += kNumbersBetweenLooks) {
      if (!input_.at(begin, view.count)) {
        problem_.set(Error::interrupted());
        return false;
      }
      const std::uint64_t end = std::min(view.count, begin + kNumbersBetweenLooks);
      for (std::uint64_t row = begin; row < end; ++row)
        look(row);
    }
    return true;
  }

  /// Row with a number that is not finite, or the number of rows.
  std::uint64_t findNotFinite(const AttributeView &view) {
    std::uint64_t found = view.count;
    forRows(view, [&](std::uint64_t row) {
      const auto [x, y, z] = readRow<3>(view, row);
      // A sum of finite numbers that are this small is finite; of others it never is.
      if (!std::isfinite(x * 0 + y * 0 + z * 0))
        found = std::min(found, row);
    });
    return found;
  }

  void checkPositions(const MeshPart &part, std::size_t index) {
    const auto [entry, isNew] = notFinite_.try_emplace(keyOf(part.positions), 0);
    if (isNew)
      entry->second = findNotFinite(part.positions);
    if (entry->second < part.positions.count)
      problem_.set("vertex " + std::to_string(entry->second) + nameOf(index) +
                   " has a coordinate that is not a finite number");
  }

  std::uint32_t findHighest(const AttributeView &view) {
    std::uint32_t highest = 0;
    forRows(view, [&](std::uint64_t row) { highest = std::max(highest, readIndex(view, row)); });
    return highest;
  }

  void checkIndices(const MeshPart &part, std::size_t index) {
    const auto [entry, isNew] = highest_.try_emplace(keyOf(part.indices), 0);
    if (isNew)
      entry->second = findHighest(part.indices);
    if (entry->second >= part.positions.count)
      problem_.set("an index" + nameOf(index) + " names vertex " + std::to_string(entry->second) +
                   ", but there are " + std::to_string(part.positions.count));
  }

  std::string nameOf(std::size_t part) const {
    return scene_.parts.size() == 1 ? std::string() : " of mesh part " + std::to_string(part);
  }

  const TriangleScene &scene_;
  const MeshInput &input_;
  Problem problem_;
  std::map<ViewKey, std::uint64_t> notFinite_; ///< The first such row of a view.
  std::map<ViewKey, std::uint32_t> highest_;   ///< Index of a view.
};

} // namespace

Expected<void> checkNumbers(const TriangleScene &scene, const MeshInput &input) {
  return NumberChecker(scene, input).check();
}

} // namespace voxc
