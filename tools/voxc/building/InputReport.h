// What an input that is no volume yet says of itself, as text and as figures.
#pragma once

#include "options/Figures.h"

#include <string>

namespace voxc::tool {

/// Whether `path` ends as a volume does, or as nothing that is known as another input.
bool isVolumePath(const std::string &path);

/// Reads an input, prints what is known of it to standard output unless the figures go there, and adds it to
/// the figures. Errors: as `openInput`.
Expected<void> reportInput(const std::string &input, const CommonOptions &common, Json &figures);

} // namespace voxc::tool
