// Runtime files as templates: a file that speaks of level N is instantiated for each level that uses it.
#pragma once

#include "voxc/Plan/Plan.h"
#include "voxc/Support/EmbeddedFile.h"

#include <span>
#include <string>
#include <string_view>

namespace voxc {

/// The text of a runtime file, which must exist.
std::string_view runtimeFile(std::span<const EmbeddedFile> files, std::string_view path);

/// `text` for one level. Identifiers (or parts of them between underscores) are replaced: N by the level's
/// number, NEXT by "level_<number + 1>" or, in the last level, "voxel", KIND by the kind's name.
std::string instantiate(std::string_view text, const Plan &plan, const LevelPlan &level);

/// The same for the nodes of 2^`height` cells a side of a tree, from 1 to its depth: H is replaced too, NODE
/// by "level_<number>" at the root and "level_<number>_height_<height>" below it, CHILD by what NODE is one
/// lower.
std::string instantiate(std::string_view text, const Plan &plan, const LevelPlan &level, int height);

/// `text` without its lines between "#ifdef `name`", "#else" and "#endif" that do not apply, and without
/// these. They stand alone on their lines; one within another is not understood.
std::string resolveConditions(std::string_view text, std::string_view name, bool defined);

/// "// Level 2: svdag, 256 x 256 x 256 cells of 1 voxel a side." and an empty line before it.
std::string levelComment(const LevelPlan &level);

} // namespace voxc
