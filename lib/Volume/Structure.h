// Proving words by a layout that is there already.
#pragma once

#include "voxc/Layout/Layout.h"
#include "voxc/Volume/Volume.h"

#include <span>

namespace voxc {

/// `checkStructure` of a format with this layout.
Expected<std::uint64_t> checkStructure(const Layout &layout, std::span<const std::uint32_t> words,
                                       const KeepOn &keepOn = {});

} // namespace voxc
