// What opening an input and building a volume tell: warnings, and figures for --stats.
#pragma once

#include "common/Command.h"
#include "common/Json.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Input/Input.h"

#include <set>
#include <string>

namespace voxc::tool {

/// Sentences about an input that were told already: a command may open it twice.
using ToldSentences = std::set<std::string>;

/// Tells the warnings and notes about an input that are not among those told, and adds them, unless asked to
/// be quiet.
void tellWarnings(const Input &input, const CommonOptions &common, ToldSentences &told);

/// Adds the figures of opening an input.
void addInputFigures(Json &figures, const Input &input);

/// Adds the figures of a build.
void addBuildFigures(Json &figures, const BuildReport &report);

/// Adds the size of a file that was written.
void addFileFigure(Json &figures, const std::string &path);

} // namespace voxc::tool
