// The host of generated construction code: it asks the source, keeps the words, and ends a build that fails.
#pragma once

#include "NodeMap.h"

#include "voxc/Construct/Constructor.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

// The same header that the generated code includes: one definition of the interface between the two.
#include "voxc_construct.h"

namespace voxc {

/// Serves one build. After a failure every cube is "empty", so that the generated code ends by itself.
class BuildHost {
public:
  BuildHost(VoxelSource &source, const Format &format, const Progress &progress);

  /// The table of functions that the generated code calls.
  construct::Host interface();

  const std::optional<Error> &failure() const { return failure_; }
  std::uint64_t voxels() const { return voxels_; }
  std::uint64_t uniqueNodes() const { return uniqueNodes_; }
  std::uint64_t sharedNodes() const { return sharedNodes_; }
  /// The words, with the root's offset put into the first.
  std::vector<std::uint32_t> takeWords(std::uint32_t root);

private:
  bool isEmpty(const Cube &cube);
  void readBrick(Int3 low, std::uint32_t *voxels);
  std::uint32_t append(std::span<const std::uint32_t> words);
  std::uint32_t intern(unsigned level, std::span<const std::uint32_t> words);
  std::uint32_t *allocate(std::uint64_t count);
  void release(const std::uint32_t *words);
  void fail(Error error);
  void reportProgress(Int3 low);

  struct Release {
    void operator()(std::uint32_t *words) const;
  };

  VoxelSource &source_;
  const Progress &progress_;
  std::uint64_t totalCodes_; ///< Of the Morton order of the source's bounding cube.
  std::vector<std::uint32_t> words_{0};
  std::vector<NodeMap> nodes_; ///< One a level.
  std::vector<std::unique_ptr<std::uint32_t, Release>> grids_;
  std::optional<Error> failure_;
  std::uint64_t voxels_ = 0;
  std::uint64_t uniqueNodes_ = 0;
  std::uint64_t sharedNodes_ = 0;
  unsigned untilReport_ = 0;
};

} // namespace voxc
