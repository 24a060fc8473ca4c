// The facts of a source as JSON and as text.
#pragma once

#include "common/Json.h"
#include "voxc/Facts/Facts.h"

#include <string>

namespace voxc::tool {

/// All facts and what follows from them, by the keys of docs/facts.md.
Json factsFigures(const Facts &facts);

/// The same for people: lines and tables, as `voxc facts` prints them.
std::string factsReport(const Facts &facts);

} // namespace voxc::tool
