// What the passes that choose a walk have in common.
#pragma once

#include "voxc/Passes/Pass.h"

namespace voxc {

/// Sets walk=`walk` on every tree that has more than one cell. An error, and no change, where another pass
/// has chosen a walk: a tree is walked in one way.
PassResult chooseWalk(Format &format, std::string_view walk, Diagnostics &diagnostics);

} // namespace voxc
