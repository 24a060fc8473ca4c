// Proving words by a layout that is there already.
#pragma once

#include "voxc/Layout/Layout.h"
#include "voxc/Volume/Frames.h"

#include <span>

namespace voxc {

/// `checkStructure` of a format with this layout.
Expected<std::uint64_t> checkStructure(const Layout &layout, std::span<const std::uint32_t> words,
                                       const KeepOn &keepOn = {});

/// The same of a volume of frames; what they share is gone through once. The numbers of voxels that the
/// frames state are proved as well.
Expected<void> checkStructure(const Layout &layout, std::span<const std::uint32_t> words,
                              std::span<const Frame> frames, const KeepOn &keepOn = {});

} // namespace voxc
