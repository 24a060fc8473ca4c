// What the passes that choose a walk have in common.
#pragma once

#include "voxc/Passes/Pass.h"

namespace voxc {

/// Sets walk=`walk` on every tree that has more than one cell. An error, and no change, where another pass
/// has chosen a walk: a tree is walked in one way.
PassResult chooseWalk(Format &format, std::string_view walk, Diagnostics &diagnostics);

/// Sets levels=`levels` on the format. An error, and no change, where a tree has a walk of its own: one loop
/// for all levels goes down trees in its own way.
PassResult chooseLevels(Format &format, std::string_view levels, Diagnostics &diagnostics);

} // namespace voxc
