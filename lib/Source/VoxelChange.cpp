// Kinds of changes: boxes, spheres, lists, volumes, functions.
#include "voxc/Source/VoxelChange.h"

#include "voxc/Source/Sources.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace voxc {
namespace {

/// Where a cube lies of a region.
enum class Meeting { Outside, Inside, Across };

/// Voxels [low, end).
struct EditedBox {
  Int3 low;
  std::array<std::int64_t, 3> end;

  EditedBox(Int3 low, Int3 size) : low(low) {
    for (int axis = 0; axis < 3; ++axis)
      end[static_cast<std::size_t>(axis)] = std::int64_t{low[axis]} + size[axis];
  }

  bool holds(Int3 at) const { return meets({at, 0}) == Meeting::Inside; }

  Meeting meets(const Cube &cube) const {
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t first = cube.low[axis], behind = first + cube.side(), last = end[std::size_t(axis)];
      if (behind <= low[axis] || first >= last)
        return Meeting::Outside;
      isInside &= first >= low[axis] && behind <= last;
    }
    return isInside ? Meeting::Inside : Meeting::Across;
  }
};

class BoxChange final : public VoxelChange {
public:
  BoxChange(EditedBox box, std::uint32_t word) : box_(box), word_(word) {}

  CubeChange of(const Cube &cube) override {
    const Meeting meeting = box_.meets(cube);
    return meeting == Meeting::Outside  ? CubeChange{}
           : meeting == Meeting::Inside ? CubeChange{CubeChange::Set, word_}
                                        : CubeChange{CubeChange::Some};
  }
  std::uint32_t voxel(Int3 at, std::uint32_t old) override { return box_.holds(at) ? word_ : old; }

private:
  EditedBox box_;
  std::uint32_t word_;
};

class SphereChange final : public VoxelChange {
public:
  SphereChange(Int3 centre, int radius, std::uint32_t word)
      : centre_(centre), squared_(radius < 0 ? -1 : std::int64_t{radius} * radius), word_(word) {}

  CubeChange of(const Cube &cube) override {
    std::int64_t nearest = 0, farthest = 0; // Sums of three squares below 2^60, by the two limits.
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t low = std::int64_t{cube.low[axis]} - centre_[axis], high = low + cube.side() - 1;
      const std::int64_t near = low > 0 ? low : high < 0 ? -high : 0, far = std::max(-low, high);
      if (near > kMostSphereRadius)
        return {};
      nearest += near * near;
      farthest += far * far;
    }
    return nearest > squared_     ? CubeChange{}
           : farthest <= squared_ ? CubeChange{CubeChange::Set, word_}
                                  : CubeChange{CubeChange::Some};
  }
  std::uint32_t voxel(Int3 at, std::uint32_t old) override {
    return of({at, 0}).kind == CubeChange::Set ? word_ : old;
  }

private:
  Int3 centre_;
  std::int64_t squared_; ///< Below 0: no voxel is near enough.
  std::uint32_t word_;
};

/// Voxels in Morton order, each once: the last that was given.
class ListChange final : public VoxelChange {
public:
  explicit ListChange(std::span<const VoxelWord> voxels) {
    entries_.reserve(voxels.size());
    for (const VoxelWord &voxel : voxels)
      entries_.push_back({mortonCode(voxel.at), voxel.word});
    std::ranges::stable_sort(entries_, {}, &Entry::code);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < entries_.size(); ++i)
      if (i + 1 == entries_.size() || entries_[i].code != entries_[i + 1].code)
        entries_[kept++] = entries_[i];
    entries_.resize(kept);
  }

  CubeChange of(const Cube &cube) override {
    const std::uint64_t first = mortonCode(cube.low);
    const auto found = from(first);
    return found != entries_.end() && (found->code - first) >> 3 * cube.log2Side == 0
               ? CubeChange{CubeChange::Some}
               : CubeChange{};
  }
  std::uint32_t voxel(Int3 at, std::uint32_t old) override {
    const std::uint64_t code = mortonCode(at);
    const auto found = from(code);
    return found != entries_.end() && found->code == code ? found->word : old;
  }

private:
  struct Entry {
    std::uint64_t code;
    std::uint32_t word;
  };
  std::vector<Entry>::const_iterator from(std::uint64_t code) const {
    return std::ranges::lower_bound(entries_, code, {}, &Entry::code);
  }

  std::vector<Entry> entries_;
};

/// Reads the pasted volume by its own bricks, of which some are kept: a cube of the edited volume may lie
/// across eight of them.
class PasteChange final : public VoxelChange {
public:
  PasteChange(std::shared_ptr<const Volume> pasted, Int3 low)
      : box_(low, pasted->info().extent), source_(makeVolumeSource(std::move(pasted))),
        bricks_(std::size_t{1} << 3 * kLog2Kept) {}

  CubeChange of(const Cube &cube) override {
    return {box_.meets(cube) == Meeting::Outside || isEmpty(cube) ? CubeChange::Keep : CubeChange::Some};
  }
  std::uint32_t voxel(Int3 at, std::uint32_t old) override {
    if (!box_.holds(at))
      return old;
    const Int3 inside = at - box_.low;
    const std::uint32_t word =
        brickAt({inside.x >> kLog2Side, inside.y >> kLog2Side, inside.z >> kLog2Side})
            .words[mortonCode({inside.x & kInside, inside.y & kInside, inside.z & kInside})];
    return word != 0 ? word : old;
  }

private:
  static constexpr int kLog2Side = 3, kInside = (1 << kLog2Side) - 1;
  static constexpr int kLog2Kept = 2, kKept = (1 << kLog2Kept) - 1;

  struct Brick {
    std::optional<Int3> place; ///< In bricks; none: there is none here yet.
    std::array<std::uint32_t, std::size_t{1} << 3 * kLog2Side> words;
  };

  const Brick &brickAt(Int3 place) {
    Brick &brick = bricks_[mortonCode({place.x & kKept, place.y & kKept, place.z & kKept})];
    if (!brick.place || !(*brick.place == place)) {
      brick.place = place;
      if (!source_->read({place * (1 << kLog2Side), kLog2Side}, brick.words.data()))
        brick.words.fill(0); // A volume in memory does not fail.
    }
    return brick;
  }

  /// True if the aligned cubes of the pasted volume that the cube touches are empty.
  bool isEmpty(const Cube &cube) {
    const Int3 first = cube.low - box_.low, last = first + Int3{1, 1, 1} * static_cast<int>(cube.side() - 1);
    const auto alignedLow = [&](int coordinate) { return coordinate >> cube.log2Side << cube.log2Side; };
    for (int z = alignedLow(first.z); z <= last.z; z += 1 << cube.log2Side)
      for (int y = alignedLow(first.y); y <= last.y; y += 1 << cube.log2Side)
        for (int x = alignedLow(first.x); x <= last.x; x += 1 << cube.log2Side)
          if ((x | y | z) >= 0 && !source_->empty({{x, y, z}, cube.log2Side}))
            return false;
    return true;
  }

  EditedBox box_;
  std::unique_ptr<VoxelSource> source_;
  std::vector<Brick> bricks_;
};

class FunctionChange final : public VoxelChange {
public:
  FunctionChange(EditedBox box, std::function<std::uint32_t(Int3, std::uint32_t)> function)
      : box_(box), function_(std::move(function)) {}

  CubeChange of(const Cube &cube) override {
    return {box_.meets(cube) == Meeting::Outside ? CubeChange::Keep : CubeChange::Some};
  }
  std::uint32_t voxel(Int3 at, std::uint32_t old) override {
    return box_.holds(at) ? function_(at, old) : old;
  }

private:
  EditedBox box_;
  std::function<std::uint32_t(Int3, std::uint32_t)> function_;
};

} // namespace

std::unique_ptr<VoxelChange> makeBoxChange(Int3 low, Int3 size, std::uint32_t word) {
  return std::make_unique<BoxChange>(EditedBox(low, size), word);
}

std::unique_ptr<VoxelChange> makeSphereChange(Int3 centre, int radius, std::uint32_t word) {
  return std::make_unique<SphereChange>(centre, radius, word);
}

std::unique_ptr<VoxelChange> makeListChange(std::span<const VoxelWord> voxels) {
  return std::make_unique<ListChange>(voxels);
}

std::unique_ptr<VoxelChange> makePasteChange(std::shared_ptr<const Volume> pasted, Int3 low) {
  return std::make_unique<PasteChange>(std::move(pasted), low);
}

std::unique_ptr<VoxelChange> makeFunctionChange(Int3 low, Int3 size,
                                                std::function<std::uint32_t(Int3, std::uint32_t)> function) {
  return std::make_unique<FunctionChange>(EditedBox(low, size), std::move(function));
}

std::unique_ptr<VoxelChange> makeChange(const VoxelEdit &edit) {
  return edit.pasted ? makePasteChange(edit.pasted, edit.low) : makeBoxChange(edit.low, edit.size, edit.word);
}

} // namespace voxc
