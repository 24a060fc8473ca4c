// The command that builds the volume of a cell, from what its record says.
#pragma once

#include "report/Cells.h"

#include <string>

namespace voxc::report {

/// "voxc build 'R(4^3) G(7)' sponza.obj --whole-level-dedup -o sponza.hvx". The input and its options are
/// taken from the command that made the record, as far as that names them; words that a shell would not take
/// as they are stand in quotes.
std::string buildCommand(const Cell &cell);

} // namespace voxc::report
