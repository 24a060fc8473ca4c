// What construct.cpp and edit.cpp have in common: levels as structs of constants, of which headers of
// construct-runtime make code.
#pragma once

#include "voxc/Layout/SlotKind.h"
#include "voxc/Plan/Plan.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace voxc {

/// A name that a level gives to a class: `using Slots = NAME<Level3>;`.
struct LevelAlias {
  std::string_view name;
  RuntimeClass of; ///< Without a name: the level has none.
};

/// What one of the two programs makes of a level.
struct LevelForm {
  std::string_view voxels;                        ///< What cells of the last level hold.
  std::string_view (*subVolume)(const Stratum &); ///< The class of what cells of others hold, in `headers`.
  std::vector<LevelAlias> (*aliases)(const Stratum &);
  std::string_view (*header)(const Stratum &); ///< Of `subVolume`.
};

/// The levels of a plan as structs, the last first, behind the headers that they need.
std::string constructLevels(const Plan &plan, const LevelForm &form);

/// "Level3".
std::string levelStruct(std::size_t index);

/// "Tree<Level3>".
std::string subVolumeOf(const Plan &plan, const LevelForm &form, std::size_t index);

} // namespace voxc
