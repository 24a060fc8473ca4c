// Which payload keeps the colours of a scene in the fewest bytes, without loss.
#pragma once

#include "voxc/Facts/Facts.h"

#include <string>
#include <vector>

namespace voxc {

/// A payload that holds all colours of the voxels.
struct PayloadChoice {
  std::string payload; ///< As IR writes it: "constant", "palette(4)", "rgba8".
  bool apart = false;  ///< Its values stand apart.
  std::string why;     ///< A clause on the colours: "12 colours, 4 bits each".
};

/// The payloads that are worth trying, the smallest first: the first that a format allows is the one to take.
/// The last, rgba8 in place, suits every format. The rules are measured (docs/notes/2026-11-23-sizes.md).
std::vector<PayloadChoice> choosePayload(const Facts &facts);

} // namespace voxc
