// Joining the parts of a cube to one: the step of a merge that leaves a fragment.
#pragma once

#include "Construct/Parts/PartBuilder.h"
#include "FragmentSet.h"

#include <memory>

namespace voxc {

/// Makes larger parts of those of a stream, in memory of its own: each is what building its cube apart would
/// have given, so that words that several parts share are kept once.
class JoinedParts {
public:
  /// `stream` outlives this. Error: no memory.
  static Expected<JoinedParts> create(FragmentSet &stream, const ConstructCode &code,
                                      const std::shared_ptr<WorkingMemory> &memory);

  /// The cube as one part; the next part of the stream lies in it. Errors: the stream's, no memory, too many
  /// words, or the work was stopped.
  Expected<Fragment> join(const Cube &cube, const Progress &progress);

private:
  JoinedParts(FragmentSet &stream, const ConstructCode &code, std::unique_ptr<Layout> layout,
              std::unique_ptr<NodeStore> store)
      : stream_(stream), code_(code), layout_(std::move(layout)), store_(std::move(store)) {}

  FragmentSet &stream_;
  ConstructCode code_;
  std::unique_ptr<Layout> layout_;
  std::unique_ptr<NodeStore> store_;
};

} // namespace voxc
