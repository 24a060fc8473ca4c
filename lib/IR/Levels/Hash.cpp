// H: a hash grid. A table of the cells that are not empty, for levels that are vast and nearly empty.
#include "Kinds.h"

namespace voxc {
namespace {

constexpr std::array<ParameterKind, 3> kParameters = {kWidth, kHeight, kDepth};
constexpr std::array<const AttributeKind *, 1> kAttributes = {&kShareAttribute};

Stratum lower(const Level &level) { return gridStratum(level, "hashed"); }

} // namespace

extern const LevelKind kHash = {
    'H',         "hash",
    "Hash",      "a table of the cells that are not empty: empty ones cost nothing, a lookup a few probes",
    kParameters, kAttributes,
    lower};

} // namespace voxc
