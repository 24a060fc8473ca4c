// The table of passes; a new one is a file beside this and a row here.
#include "voxc/Passes/Pass.h"

#include <algorithm>
#include <array>

namespace voxc {
namespace {

constexpr PassNumber kPaletteNumber = {1, 16, 8, paletteOf};
constexpr PassNumber kMaterialNumber = {1, 16, 8, materialOf};
constexpr PassNumber kPointersNumber = {8, 24, 20, shortPointersOf};

constexpr std::array<Pass, 24> kPasses = {{
    {"whole-level-dedup", AttributeEffect::Storage,
     "share equal nodes among all sub-volumes of an SVDAG level",
     "Without it, each sub-volume of a G level has a node map of its own. With it the level has one, "
     "across all parents, so that equal nodes, roots included, are stored once. Unchanged where no level "
     "but the first is a G.",
     wholeLevelDedup},
    {"share-grids", AttributeEffect::Storage, "store equal sub-volumes of an R or D level once",
     "Without it, each sub-volume of a grid level is written where it comes. With it, one whose words the "
     "level has written already is pointed to instead. Unchanged where no level but the first is an R or "
     "a D.",
     shareGrids},
    {"visible-voxels", AttributeEffect::Storage, "state that no voxel has an alpha of 0",
     "A fact about the voxels that other passes may use, and that a build proves: it fails at a voxel "
     "with an alpha of 0, and names it.",
     visibleVoxels},
    {"occupancy", AttributeEffect::Storage, "keep of a voxel that it is there, and no colour",
     "Without it, a voxel is a colour of four bytes. With it, all voxels are equal: G and M as the last "
     "level "
     "have a bit for each voxel and no word, so that equal shapes share storage whatever their colours are, "
     "and kernels load no colour. Hits are white. Other kinds of levels keep a word for each voxel as the "
     "last level.",
     occupancy},
    {"constant-colour", AttributeEffect::Storage, "state that all voxels have one colour, and keep it once",
     "A fact about the voxels, which a build proves: it fails at a voxel of a second colour, and names it. "
     "The "
     "volume is that of occupancy, and hits have the colour.",
     constantColour},
    {"palette", AttributeEffect::Storage, "state that there are at most 2^N colours, and keep each once",
     "A fact about the voxels, which a build proves: it fails at a voxel of a colour too much, and names it. "
     "The colours stand in a table, and the blocks of values-apart hold indices into it in their place, of "
     "as "
     "few bits as the block at hand asks for: N, which is 1 to 16 and 8 if it is not written, bounds the "
     "table "
     "and changes no size. A block of one colour is a reference to it. Sets values-apart too.",
     palette, &kPaletteNumber},
    {"rgb565", AttributeEffect::Storage, "keep colours in 5, 6 and 5 bits: lossy",
     "Without it, colours are kept as they are. With it, each channel is the nearest of those that its bits "
     "tell, "
     "and alpha is 255; a build tells the largest and the mean error of each channel, and so does voxc "
     "verify "
     "--against. Blocks of values-apart then take fewer bits. Sets values-apart too.",
     rgb565},
    {"material", AttributeEffect::Storage, "keep a label of N bits in place of a colour",
     "For inputs whose voxels are labels (--colour-map labels): numbers of materials, or of the parts of a "
     "segmentation. A hit answers the label, and pictures show it in a colour of its own. A build fails at a "
     "label "
     "of more than N bits, and names its voxel; N is 1 to 16, and 8 if it is not written. With values-apart, "
     "labels "
     "stand in blocks as the colours of a palette do.",
     material, &kMaterialNumber},
    {"values-apart", AttributeEffect::Storage,
     "keep the colours of voxels apart from their shape, compressed",
     "Without it, a voxel's colour stands where its shape does, and two equal shapes of other colours share "
     "nothing. With it, levels hold the shape alone, with counts by which the walk's end finds the rank of "
     "a voxel, how many come before it; its colour is the one of that rank, in blocks of 128, each stored by "
     "what takes the fewest bits of runs, palettes and differences. A hit decodes one colour, of at most 64 "
     "bytes. The last level must be a G or an M, those above R, D, M or G.",
     valuesApart},
    {"short-pointers", AttributeEffect::Storage, "lead to the last level's sub-volumes by numbers of N bits",
     "Without it, a pointer to a grid of 4 x 4 x 4 voxels is a word, half as long as the grid itself. With "
     "it, "
     "these grids stand in an array, and their parents have their numbers there: N bits each, 8 to 24, and "
     "20 "
     "if it is not written. A build that finds more different ones than there are numbers fails; with "
     "short-pointers=auto, voxc build and voxc run measure the input, and take the fewest bits that do. "
     "Unchanged where the last level is no M(2^3) below another M whose voxels are masks alone (occupancy, "
     "or "
     "values-apart before it).",
     shortPointers, &kPointersNumber},
    {"octant-counts", AttributeEffect::Storage,
     "count voxels for octants of the last level's sub-volumes alone",
     "Without it, each number of short-pointers is followed by a count of the voxels before its sub-volume, "
     "which takes about as many bits as the number. With it, only the first of each octant of eight has one, "
     "and the voxels of those between are counted in their masks, at most seven, when a hit's colour is "
     "asked for. Unchanged where short-pointers leads from no M(2^3), or colours do not stand apart.",
     octantCounts},
    {"octant-masks", AttributeEffect::Storage,
     "keep of the last level's small grids the octants that are not empty",
     "Without it, each M(2^3) that numbers of short-pointers lead to is two words. With it, a byte tells "
     "which of its eight octants have voxels, and each of these has a byte of its own: about a quarter less. "
     "Sixteen grids have a word in common that tells where their bytes begin, so that a kernel reads three "
     "words or more where it read two. Unchanged without short-pointers.",
     octantMasks},
    {"granules", AttributeEffect::Storage,
     "let references count granules of two words, so that they reach 32GiB",
     "Without it, a reference is the number of a word, and a volume has at most 2^32 of them, 16 GiB. With "
     "it, "
     "references count granules of two words, and all that they lead to begins at one: nodes of an odd "
     "number "
     "of words are followed by a 0. Each further time it doubles the granule, up to 256 words. It is an "
     "error "
     "where an S level would have granules of more than two words, its nodes, and with short pointers. A "
     "build "
     "that needs it says so; else it only costs.",
     granules},
    {"inline-leaves", AttributeEffect::Storage, "keep the values of a G level's leaves in the slots of nodes",
     "Without it, a leaf is a word that slots point to, and equal leaves are one word. With it, the slot is "
     "the leaf's value: a word less for each that differs, and a load less on the way to it. Unchanged where "
     "no level is a G.",
     inlineLeaves},
    {"octant-distances", AttributeEffect::Storage,
     "let D levels tell empty cubes by octant in place of an L1 distance",
     "Without it, an empty cell of a D level tells how far the nearest full cell is, and a ray looks up "
     "the cells that it may pass one by one. With it, the cell tells, for each octant of directions, the "
     "side of the largest empty cube that begins there and goes that way: a ray leaves that cube in one "
     "step. M is 15 at most, and 7 in the words of voxels. Unchanged where no level is a D.",
     octantDistances},
    {"df-packing", AttributeEffect::Storage,
     "keep the distances of D levels in the words of their empty cells",
     "Without it, a cell of a D level has two words, of which one is always without use: a value or a "
     "distance. With it, an empty cell's word holds its distance. References then have 31 bits, and a bit "
     "tells them from distances; voxels are told by their alpha, so that a D as the last level needs "
     "visible-voxels first. Unchanged where no level is a D.",
     dfPacking},
    {"merge-grids", AttributeEffect::Storage, "make one R level of neighbouring ones",
     "R(2^3) R(3^3) is R(5^3) in meaning: one lookup in place of two, and a word for each cell. Left out "
     "where the merged grid would not fit a volume. Unchanged where no two R levels are neighbours.",
     mergeGrids},
    {"split-grids", AttributeEffect::Storage, "make two R levels of each",
     "R(5^3) is R(3^3) R(2^3) in meaning: empty parts of the grid then take no words. Unchanged where no "
     "R level has four cells on each axis.",
     splitGrids},
    {"restart-sv", AttributeEffect::Walk,
     "walk octrees and DAGs from the root at each lookup, without a stack",
     "The stack walk keeps the nodes above the current cell. Restarting keeps nothing and descends from the "
     "sub-volume's root at each lookup, which is faster on shallow trees. Unchanged where no level is a "
     "tree.",
     restartSv},
    {"unroll-sv", AttributeEffect::Walk, "walk octrees and DAGs by a loop for each height, without a stack",
     "The stack walk is one loop, which goes up and down. Unrolling writes out its levels: a function for "
     "each height of the tree, which goes over the children of a node and calls the one below. Excludes "
     "restart-sv. Unchanged where no level is a tree.",
     unrollSv},
    {"flat-walk", AttributeEffect::Walk, "walk through all levels by one loop",
     "Without it, each level has a loop, which calls that of the next. One loop through the nodes of all "
     "levels makes a smaller kernel, which is faster where rays of a group are on different levels, and "
     "slower where they are together. Formats of 8 levels and more have it without being asked. Excludes "
     "restart-sv and unroll-sv, and gives way to detail=cone.",
     flatWalk},
    {"direct-walk", AttributeEffect::Walk, "walk by one loop that goes down from the root in each turn",
     "Without it, each level has a loop, which calls that of the next. With it there is one loop, and "
     "each turn goes down through all levels, straight and without a loop, to a voxel or to what is known "
     "to be empty around: where a format has few layers of nodes, rays of a group then never wait for "
     "each other. Excludes flat-walk, restart-sv and unroll-sv, and gives way to detail=cone.",
     directWalk},
    {"shared-stack", AttributeEffect::Walk,
     "keep the nodes above a cell in memory that a group of rays shares",
     "Stack walks and flat ones keep references to the nodes above the current cell, an array for each ray, "
     "which a device puts into registers or into memory behind its caches. With it, the arrays of a group of "
     "rays stand in the memory that the group shares, beside each other, 256 bytes for each layer of a tree. "
     "Kernels for the cpu have no such memory, nor have functions for the shaders of others: theirs stays "
     "private. Unchanged where walks keep no nodes: give it after the pass that chooses the walk.",
     sharedStack},
    {"strip-walk", AttributeEffect::Walk, "remove the attributes that concern the kernel alone",
     "Gives the format as volumes store it.", stripWalk},
}};

} // namespace

std::span<const Pass> passes() { return kPasses; }

const Pass *findPass(std::string_view name) {
  const auto found = std::ranges::find(kPasses, name.substr(0, name.find('=')), &Pass::name);
  return found == kPasses.end() ? nullptr : &*found;
}

} // namespace voxc
