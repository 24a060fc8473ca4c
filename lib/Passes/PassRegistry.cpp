// The table of passes; a new one is a file beside this and a row here.
#include "voxc/Passes/Pass.h"

#include <algorithm>
#include <array>

namespace voxc {
namespace {

constexpr std::array<Pass, 5> kPasses = {{
    {"whole-level-dedup", AttributeEffect::Storage,
     "share equal nodes among all sub-volumes of an SVDAG level",
     "Without it, each sub-volume of a G level has a node map of its own. With it the level has one, across "
     "all "
     "parents, so that equal nodes, roots included, are stored once. Unchanged where no level but the first "
     "is a G.",
     wholeLevelDedup},
    {"share-grids", AttributeEffect::Storage, "store equal sub-volumes of an R or D level once",
     "Without it, each sub-volume of a grid level is written where it comes. With it, one whose words the "
     "level "
     "has written already is pointed to instead. Unchanged where no level but the first is an R or a D.",
     shareGrids},
    {"restart-sv", AttributeEffect::Walk,
     "walk octrees and DAGs from the root at each lookup, without a stack",
     "The stack walk keeps the nodes above the current cell. Restarting keeps nothing and descends from the "
     "sub-volume's root at each lookup, which is faster on shallow trees. Unchanged where no level is a "
     "tree.",
     restartSv},
    {"unroll-sv", AttributeEffect::Walk, "walk octrees and DAGs by a loop for each height, without a stack",
     "The stack walk is one loop, which goes up and down. Unrolling writes out its levels: a function for "
     "each "
     "height of the tree, which goes over the children of a node and calls the one below. Excludes "
     "restart-sv. Unchanged where no level is a tree.",
     unrollSv},
    {"strip-walk", AttributeEffect::Walk, "remove the attributes that concern the kernel alone",
     "Gives the format as volumes store it.", stripWalk},
}};

} // namespace

std::span<const Pass> passes() { return kPasses; }

const Pass *findPass(std::string_view name) {
  const auto found = std::ranges::find(kPasses, name, &Pass::name);
  return found == kPasses.end() ? nullptr : &*found;
}

} // namespace voxc
