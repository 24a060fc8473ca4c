// The table of passes: a choice of another attribute is a row here; a pass that does more is a file beside
// this as well.
#include "voxc/Passes/Pass.h"

#include <algorithm>
#include <array>

namespace voxc {
namespace {

// clang-format off: it would put words of one sentence on lines of their own.
const std::array<Pass, 26> kPasses = {{
    {.name = "whole-level-dedup",
     .effect = AttributeEffect::Storage,
     .summary = "share equal nodes among all sub-volumes of an SVDAG level",
     .details = "Without it, each sub-volume of a G level has a node map of its own. With it the level "
                 "has one, across all parents, so that equal nodes, roots included, are stored once. "
                 "Unchanged where no level but the first is a G.",
     .choice = {&kDedupAttribute, "level", ChoiceScope::LowerLevels, Unfit::LeftOut}},
    {.name = "share-grids",
     .effect = AttributeEffect::Storage,
     .summary = "store equal sub-volumes of a grid level once",
     .details = "Without it, each sub-volume of a grid level is written where it comes. With it, one "
                 "whose words the level has written already is pointed to instead. Unchanged where no "
                 "level but the first is an R, a D, an M or an H.",
     .choice = {&kShareAttribute, "level", ChoiceScope::LowerLevels, Unfit::LeftOut}},
    {.name = "visible-voxels",
     .effect = AttributeEffect::Storage,
     .summary = "state that no voxel has an alpha of 0",
     .details = "A fact about the voxels that other passes may use, and that a build proves: it fails at "
                 "a voxel with an alpha of 0, and names it.",
     .choice = {&kAlphaAttribute, "positive"}},
    {.name = "occupancy",
     .effect = AttributeEffect::Storage,
     .summary = "keep only whether there is a voxel, without its colour",
     .details = "Without it, a voxel is a colour of four bytes. With it, all voxels are equal: G and M "
                 "as the last level have a bit for each voxel and no word, so that equal shapes share "
                 "storage whatever their colours are, and kernels load no colour. Hits are white. Other "
                 "kinds of levels keep a word for each voxel as the last level.",
     .choice = {&kPayloadAttribute, "occupancy"}},
    {.name = "constant-colour",
     .effect = AttributeEffect::Storage,
     .summary = "state that all voxels have one colour, and keep it once",
     .details = "A fact about the voxels, which a build proves: it fails at a voxel of a second colour, "
                 "and names it. The volume is that of occupancy, and hits have the colour.",
     .choice = {&kPayloadAttribute, "constant"}},
    {.name = "palette",
     .effect = AttributeEffect::Storage,
     .summary = "state that there are at most 2^N colours, and keep each once",
     .details = "A fact about the voxels, which a build proves: it fails at a voxel of one colour too many, "
                 "and names it. Each colour is stored once, in a table, and the blocks of values-apart hold "
                 "indices into it, each block with as few bits as it needs. N is 1 to 16, by default 8; it "
                 "bounds the table and changes no size. A block of one colour is a reference to it. Sets "
                 "values-apart too.",
     .choice = {&kPayloadAttribute, "palette(#)", ChoiceScope::Format, Unfit::Error, &kValuesAttribute},
     .number = PassNumber{"bits", 1, 16, 8}},
    {.name = "rgb565",
     .effect = AttributeEffect::Storage,
     .summary = "keep colours in 5, 6 and 5 bits: lossy",
     .details = "Without it, colours are kept exactly. With it, each channel is rounded to the nearest "
                 "value that its bits can encode, and alpha is 255; a build reports the largest and the "
                 "mean error of each channel, and so does voxc verify --against. Blocks of values-apart "
                 "then take fewer bits. Sets values-apart too.",
     .choice = {&kPayloadAttribute, "rgb565", ChoiceScope::Format, Unfit::Error, &kValuesAttribute}},
    {.name = "material",
     .effect = AttributeEffect::Storage,
     .summary = "keep a label of N bits in place of a colour",
     .details = "For inputs whose voxels are labels (--colour-map labels): numbers of materials, or of the "
                 "parts of a segmentation. A hit returns the label, and pictures show it in a colour of its "
                 "own. A build fails at a label of more than N bits, and names its voxel; N is 1 to 16, by "
                 "default 8. With values-apart, labels are stored in blocks, as the colours of a palette "
                 "are.",
     .choice = {&kPayloadAttribute, "material(#)"},
     .number = PassNumber{"bits", 1, 16, 8}},
    {.name = "values-apart",
     .effect = AttributeEffect::Storage,
     .summary = "keep the colours of voxels apart from their shape, compressed",
     .details = "Without it, the colour of a voxel is stored with its shape, so that two equal shapes with "
                 "different colours share nothing. With it, levels store only the shape, and counts from "
                 "which a traversal computes the rank of a voxel at its end: how many voxels come before "
                 "it. Colours are stored in the order of ranks, in blocks of 128, each by the smallest of "
                 "runs, palettes and differences. A hit decodes one colour, of at most 64 bytes. The last "
                 "level must be a G or an M, those above R, D, M or G.",
     .choice = {&kValuesAttribute, "apart"}},
    {.name = "short-pointers",
     .effect = AttributeEffect::Storage,
     .summary = "refer to the last level's sub-volumes by numbers of N bits",
     .details = "Without it, a pointer to a grid of 4 x 4 x 4 voxels is a word, half as long as the grid "
                 "itself. With it, these grids are an array, and their parents store their numbers in it: N "
                 "bits each, 8 to 24, by default 20. A build with more different grids than numbers fails; "
                 "with short-pointers=auto, voxc build and voxc run measure the input and take the fewest "
                 "bits that are enough. Unchanged unless the last level is an M(2^3) below another M and "
                 "its voxels are masks alone (occupancy, or values-apart before it).",
     .choice = {&kPointersAttribute, "#", ChoiceScope::LastLevel, Unfit::LeftOut},
     .number = PassNumber{"bits", 8, 24, 20}},
    {.name = "octant-counts",
     .effect = AttributeEffect::Storage,
     .summary = "store counts of voxels only for octants of the last level's sub-volumes",
     .details = "Without it, each number of short-pointers is followed by a count of the voxels before its "
                 "sub-volume, which takes about as many bits as the number. With it, only the first number "
                 "of each octant of eight has a count; when the colour of a hit is asked for, the voxels of "
                 "the at most seven numbers between are counted in their masks. Unchanged unless "
                 "short-pointers is set for an M(2^3) and colours are apart.",
     .choice = {&kCountsAttribute, "octant", ChoiceScope::LastLevel, Unfit::LeftOut},
     .besidePointers = true},
    {.name = "octant-masks",
     .effect = AttributeEffect::Storage,
     .summary = "store only the non-empty octants of the last level's small grids",
     .details = "Without it, each M(2^3) that numbers of short-pointers refer to is two words. With it, a "
                 "byte says which of its eight octants have voxels, and each of these has one byte: about a "
                 "quarter less. Each sixteen grids share a word that says where their bytes begin, so that "
                 "a kernel reads three words or more where it read two. Unchanged without short-pointers.",
     .choice = {&kMasksAttribute, "octants", ChoiceScope::LastLevel, Unfit::LeftOut}},
    {.name = "granules",
     .effect = AttributeEffect::Storage,
     .summary = "count references in granules of two words, so that they reach 32GiB",
     .details = "Without it, a reference is the number of a word, and a volume has at most 2^32 words, 16 "
                 "GiB. With it, references count granules of two words, and everything that they refer to "
                 "begins at a granule: nodes with an odd number of words are followed by a 0. Each further "
                 "time doubles the granule, up to 256 words. It is an error with short pointers, and where "
                 "an S level would have granules of more than two words. Use it only where a build asks for "
                 "it; otherwise it is a cost.",
     .function = granules},
    {.name = "inline-leaves",
     .effect = AttributeEffect::Storage,
     .summary = "store the values of a G level's leaves in the slots of nodes",
     .details = "Without it, a leaf is a word that slots refer to, and equal leaves are one word. With it, "
                 "the slot holds the value of the leaf: one word less for each different leaf, and one load "
                 "less on the way to it. Unchanged where no level is a G.",
     .choice = {&kLeavesAttribute, "in-slot", ChoiceScope::Levels}},
    {.name = "mirror",
     .effect = AttributeEffect::Storage,
     .summary = "share nodes of the last level, a G, that are equal after a reflection",
     .details = "Without it, equal nodes are stored once. With it, so are nodes that become equal when they "
                 "are reflected across some of the axes: of the eight reflections of a node one is written, "
                 "and three bits of each reference say which reflection is meant (the symmetry-aware DAG, "
                 "SSVDAG). References then reach 2^29 words. Unchanged unless the last level is a G with "
                 "nodes of 2 x 2 x 2 whose voxels have no values: give occupancy or constant-colour too.",
     .choice = {&kMirrorAttribute, "yes", ChoiceScope::LastLevel, Unfit::LeftOut}},
    {.name = "octant-distances",
     .effect = AttributeEffect::Storage,
     .summary = "let D levels store empty cubes by octant in place of an L1 distance",
     .details = "Without it, an empty cell of a D level stores how far the nearest full cell is, and a ray "
                 "looks up the cells that it may pass one by one. With it, the cell stores for each octant "
                 "of directions the side of the largest empty cube that begins there and extends that way: "
                 "a ray crosses that cube in one step. M is at most 15, and 7 in the words of voxels. "
                 "Unchanged where no level is a D.",
     .choice = {&kMetricAttribute, "octant", ChoiceScope::Levels}},
    {.name = "df-packing",
     .effect = AttributeEffect::Storage,
     .summary = "store the distances of D levels in the words of their empty cells",
     .details = "Without it, a cell of a D level has two words, of which one is always unused: the value or "
                 "the distance. With it, the word of an empty cell holds its distance. References then have "
                 "31 bits, and one bit distinguishes them from distances; voxels are recognised by their "
                 "alpha, so that a D as the last level needs visible-voxels first. Unchanged where no level "
                 "is a D.",
     .choice = {&kDistancesAttribute, "in-slot", ChoiceScope::Levels}},
    {.name = "merge-grids",
     .effect = AttributeEffect::Storage,
     .summary = "make one R level of neighbouring ones",
     .details = "R(2^3) R(3^3) is R(5^3) in meaning: one lookup in place of two, and a word for each "
                 "cell. Left out where the merged grid would not fit a volume. Unchanged where no two R "
                 "levels are neighbours.",
     .function = mergeGrids,
     .rewrites = true},
    {.name = "split-grids",
     .effect = AttributeEffect::Storage,
     .summary = "make two R levels of each",
     .details = "R(5^3) is R(3^3) R(2^3) in meaning: empty parts of the grid then take no words. "
                 "Unchanged where no R level has four cells on each axis.",
     .function = splitGrids,
     .rewrites = true},
    {.name = "restart-sv",
     .effect = AttributeEffect::Traversal,
     .summary = "traverse octrees and DAGs from the root at each lookup, without a stack",
     .details = "The stack traversal keeps the nodes above the current cell. Restarting keeps nothing and "
                 "descends from the sub-volume's root at each lookup, which is faster on shallow trees. "
                 "Unchanged where no level is a tree.",
     .choice = {&kTraversalAttribute, "restart", ChoiceScope::Trees}},
    {.name = "unroll-sv",
     .effect = AttributeEffect::Traversal,
     .summary = "traverse octrees and DAGs by a loop for each height, without a stack",
     .details = "The stack traversal is one loop, which goes up and down. Unrolling makes a function for "
                 "each height of the tree, which visits the children of a node and calls the function of "
                 "the height below. Excludes restart-sv. Unchanged where no level is a tree.",
     .choice = {&kTraversalAttribute, "unrolled", ChoiceScope::Trees}},
    {.name = "nested-traversal",
     .effect = AttributeEffect::Traversal,
     .summary = "traverse by a loop for each level, which calls that of the next",
     .details = "The default for formats of few levels; formats of many levels have direct-traversal by "
                 "default. Excludes flat-traversal and direct-traversal.",
     .choice = {&kLevelsAttribute, "nested"}},
    {.name = "flat-traversal",
     .effect = AttributeEffect::Traversal,
     .summary = "traverse through all levels by one loop",
     .details = "Without it, each level has a loop, which calls that of the next. One loop through the "
                 "nodes of all levels makes a smaller kernel, which is faster where rays of a group are "
                 "on different levels, and slower where they are together. Excludes restart-sv and "
                 "unroll-sv, and gives way to detail=cone.",
     .choice = {&kLevelsAttribute, "flat"}},
    {.name = "direct-traversal",
     .effect = AttributeEffect::Traversal,
     .summary = "traverse by one loop that goes down from the root in each turn",
     .details = "Without it, each level has a loop, which calls that of the next. With it there is one "
                 "loop, and each turn goes down through all levels, without an inner loop, to a voxel or to "
                 "an empty region: where a format has few layers of nodes, the rays of a group then never "
                 "wait for each other. It is the default for formats of 8 levels and more. Excludes "
                 "flat-traversal, restart-sv and unroll-sv, and gives way to detail=cone.",
     .choice = {&kLevelsAttribute, "direct"}},
    {.name = "shared-stack",
     .effect = AttributeEffect::Traversal,
     .summary = "store the nodes above a cell in memory that a group of rays shares",
     .details = "Stack traversals and flat ones keep references to the nodes above the current cell, an "
                 "array for each ray, which a device puts into registers or into memory behind its caches. "
                 "With it, the arrays of a group of rays are in the memory that the group shares, side by "
                 "side, 256 bytes for each layer of a tree. Kernels for the cpu have no such memory, nor do "
                 "functions for other shaders know their group: theirs stays private. Unchanged where "
                 "traversals keep no nodes.",
     .function = sharedStack},
    {.name = "strip-traversal",
     .effect = AttributeEffect::Traversal,
     .summary = "remove the attributes that concern the kernel alone",
     .details = "The result is the format as volumes store it.",
     .function = stripTraversal,
     .rewrites = true},
}};
// clang-format on

} // namespace

std::span<const Pass> passes() { return kPasses; }

const Pass *findPass(std::string_view name) {
  const auto found = std::ranges::find(kPasses, name.substr(0, name.find_first_of("={")), &Pass::name);
  return found == kPasses.end() ? nullptr : &*found;
}

} // namespace voxc
