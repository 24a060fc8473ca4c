// A format with its passes in one line, as people copy it from a command: "R(4^3) G(5) --whole-level-dedup".
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Support/Error.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::view {

struct FormatText {
  std::string format;
  std::vector<std::string> passes; ///< In their order: "palette=4".
};

/// Parts the passes from the format. Quotes around the format are taken off.
FormatText parseFormatText(std::string_view text);
std::string formatText(const std::string &format, std::span<const std::string> passes);
/// The same in the spelling of voxc, so that what means the same is the same text; as it is, if it is no
/// format.
std::string spelledText(std::string_view text);

/// A text that gives this very format: a format string, with the passes that it takes; its IR in one line
/// where no passes give it.
std::string formatText(const Format &format);

/// The format with its passes applied. Errors: those of formats and passes, in one line.
Expected<Format> readFormatText(const FormatText &text);

} // namespace voxc::view
