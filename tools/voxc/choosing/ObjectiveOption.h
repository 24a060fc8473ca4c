// --objective, which suggest and search have in common.
#pragma once

#include "common/CommandLine.h"
#include "voxc/Search/Suggest.h"

#include <string>

namespace voxc::tool {

/// Adds --objective to a command; `what` begins its help. Until it is given it is `balanced`.
void addObjectiveArgument(const CommandLine &command, std::string &objective, const std::string &what);

/// The objective of that name. Trusts that a validator of the option took it.
Wish::Objective objectiveOf(const std::string &name);

} // namespace voxc::tool
