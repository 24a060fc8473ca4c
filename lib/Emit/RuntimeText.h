// Looking into runtime files: what headers include, and what they speak of.
#pragma once

#include "voxc/Support/EmbeddedFile.h"

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// The text of a runtime file as it is, which must exist.
std::string_view runtimeFile(std::span<const EmbeddedFile> files, std::string_view path);

/// The files of these paths and all that they include, each once, in the order of `files`.
std::vector<EmbeddedFile> includedBy(const std::set<std::string_view> &paths,
                                     std::span<const EmbeddedFile> files);

/// The names in capitals that stand behind a prefix: "SLOT_WORDS" of "Level::SLOT_WORDS".
std::set<std::string, std::less<>> namesBehind(std::string_view prefix, std::string_view text);

} // namespace voxc
