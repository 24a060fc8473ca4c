// R: a raw grid. Cell (x, y, z) is the word at x + W * (y + H * z).
#include "Kinds.h"

namespace voxc {
namespace {

constexpr std::array<ParameterKind, 3> kParameters = {kWidth, kHeight, kDepth};
constexpr std::array<const AttributeKind *, 1> kAttributes = {&kShareAttribute};

Stratum lower(const Level &level) { return gridStratum(level, "dense"); }

} // namespace

extern const LevelKind kRaw = {
    'R',         "raw",       "Raw", "a grid of cells: no compression, the fastest lookup",
    kParameters, kAttributes, lower};

} // namespace voxc
