// Serving generated construction code.
#include "BuildHost.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <new>

namespace voxc {
namespace {

constexpr std::uint64_t kMaxWords = std::uint64_t{1} << 32;
constexpr unsigned kBricksBetweenReports = 4096;

Int3 cellOf(construct::Voxel voxel) { return {voxel.x, voxel.y, voxel.z}; }

} // namespace

void BuildHost::Release::operator()(std::uint32_t *words) const { std::free(words); }

BuildHost::BuildHost(VoxelSource &source, const Format &format, const Progress &progress)
    : source_(source), progress_(progress), nodes_(format.levels.size() + 1) {
  const Int3 extent = source.extent();
  const auto longest = static_cast<std::uint32_t>(std::max({extent.x, extent.y, extent.z, 1}));
  totalCodes_ = std::uint64_t{1} << (3 * std::bit_width(longest - 1));
}

construct::Host BuildHost::interface() {
  construct::Host table;
  table.self = this;
  table.is_empty = [](void *self, construct::Voxel low, int log2Side) {
    return static_cast<BuildHost *>(self)->isEmpty({cellOf(low), log2Side});
  };
  table.read_brick = [](void *self, construct::Voxel low, std::uint32_t *voxels) {
    static_cast<BuildHost *>(self)->readBrick(cellOf(low), voxels);
  };
  table.append = [](void *self, const std::uint32_t *words, construct::uint64_t count) {
    return static_cast<BuildHost *>(self)->append({words, count});
  };
  table.intern = [](void *self, unsigned level, const std::uint32_t *words, construct::uint64_t count) {
    return static_cast<BuildHost *>(self)->intern(level, {words, count});
  };
  table.forget = [](void *self, unsigned level) { static_cast<BuildHost *>(self)->nodes_[level].clear(); };
  table.allocate = [](void *self, construct::uint64_t count) {
    return static_cast<BuildHost *>(self)->allocate(count);
  };
  table.release = [](void *self, std::uint32_t *words) { static_cast<BuildHost *>(self)->release(words); };
  return table;
}

std::vector<std::uint32_t> BuildHost::takeWords(std::uint32_t root) {
  words_[0] = root;
  return std::move(words_);
}

void BuildHost::fail(Error error) {
  if (!failure_)
    failure_ = std::move(error);
}

bool BuildHost::isEmpty(const Cube &cube) { return failure_ || source_.empty(cube); }

void BuildHost::readBrick(Int3 low, std::uint32_t *voxels) {
  source_.read({low, 3}, voxels);
  voxels_ += static_cast<std::uint64_t>(512 - std::count(voxels, voxels + 512, 0u));
  if (auto error = source_.failure())
    fail(*error);
  if (untilReport_-- == 0)
    reportProgress(low);
}

void BuildHost::reportProgress(Int3 low) {
  untilReport_ = kBricksBetweenReports;
  progress_.at("build", static_cast<double>(mortonCode(low)) / static_cast<double>(totalCodes_));
  if (progress_.stopped())
    fail(Error::interrupted());
}

std::uint32_t BuildHost::append(std::span<const std::uint32_t> words) {
  const std::uint64_t offset = words_.size();
  if (failure_)
    return 1;
  if (offset + words.size() > kMaxWords) {
    fail(Error::input(
        "the volume needs more than 2^32 words (16 GiB), the most that offsets can reach; after " +
        std::to_string(voxels_) + " voxels it had " + std::to_string(offset) + " words"));
    return 1;
  }
  try {
    words_.insert(words_.end(), words.begin(), words.end());
  } catch (const std::bad_alloc &) {
    fail(Error::environment("out of memory for the volume's words after " + std::to_string(offset) +
                            " of them"));
    return 1;
  }
  return static_cast<std::uint32_t>(offset);
}

std::uint32_t BuildHost::intern(unsigned level, std::span<const std::uint32_t> words) {
  if (const auto known = nodes_[level].find(words, words_)) {
    ++sharedNodes_;
    return *known;
  }
  const std::uint32_t offset = append(words);
  if (!failure_) {
    nodes_[level].insert(words, offset);
    ++uniqueNodes_;
  }
  return offset;
}

std::uint32_t *BuildHost::allocate(std::uint64_t count) {
  if (failure_)
    return nullptr;
  // calloc takes large zeroed memory from the system untouched, so that a sparse grid costs what is written
  // to it.
  auto *words = static_cast<std::uint32_t *>(std::calloc(count, sizeof(std::uint32_t)));
  if (!words) {
    fail(Error::environment("out of memory for a grid of " + std::to_string(count) + " words"));
    return nullptr;
  }
  grids_.emplace_back(words);
  return words;
}

void BuildHost::release(const std::uint32_t *words) {
  std::erase_if(grids_, [&](const auto &grid) { return grid.get() == words; });
}

} // namespace voxc
