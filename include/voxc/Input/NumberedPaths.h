// Inputs of several files that are numbered.
#pragma once

#include "voxc/Support/Error.h"

#include <cstddef>
#include <string>
#include <vector>

namespace voxc {

/// The paths of a pattern such as slice%04d.png, from the lowest number that is there to the highest; of
/// another path that itself. Errors: `Input`, none is there, or one between others is not, or the lowest is
/// 2, as of a set of which not all is written, or there are more than `most`.
Expected<std::vector<std::string>> numberedPaths(const std::string &path, std::size_t most);

/// A sentence about files beside those of a pattern that seem to belong to them: of other digits, such as
/// s8.png beside s07.png, or of other letters. None where there are none, and of a path that is no pattern.
std::vector<std::string> saysBesides(const std::string &path);

/// Whether a path is a pattern of which there are files.
bool namesFiles(const std::string &path);

} // namespace voxc
