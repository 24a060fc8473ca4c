// What the seven numbers of a vertex mean: programs write x y z and a colour with alpha, and the format would
// have x y z, a weight and a colour.
#pragma once

#include <string_view>

namespace voxc {

/// Whether the fourth number of all vertices of seven in the text of an .obj is 1, as weights are.
bool haveWeights(std::string_view text);

} // namespace voxc
