// Making the nodes of a volume known, so that new ones which are equal to one are not written.
#pragma once

#include "Construct/Nodes/NodeStore.h"
#include "OldNodes.h"

#include <vector>

namespace voxc {

/// Goes through all sub-volumes once.
class Adoption {
public:
  /// The nodes and the store outlive this; the store has their words.
  Adoption(const OldNodes &nodes, NodeStore &store, std::uint64_t words);

  /// All that can be shared below the sub-volume to which `ref` leads; nothing if it is 0.
  void subVolume(unsigned level, Ref ref);

private:
  bool isFirstTime(Ref ref);
  void node(unsigned level, int layers, const construct::Node &node);
  void cell(unsigned level, std::uint32_t value);
  void leafWords(unsigned level, const construct::Node &node);

  const OldNodes &nodes_;
  NodeStore &store_;
  std::vector<bool> visited_; ///< By reference.
};

} // namespace voxc
