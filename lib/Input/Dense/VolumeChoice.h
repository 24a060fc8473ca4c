// Which of several volumes of a file is taken.
#pragma once

#include "voxc/Input/Input.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxc {

/// The volume that is asked for, from 0 on: that of the options, else the first, with a warning about the
/// others in `warnings`. Error: `Usage`, there are not so many.
Expected<std::uint64_t> chooseVolume(std::uint64_t volumes, const InputOptions &options,
                                     std::vector<std::string> &warnings);

} // namespace voxc
