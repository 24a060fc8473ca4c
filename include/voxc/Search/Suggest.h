// Which format a scene asks for, without building any: candidates priced to the word, and rated by simulated
// rays.
#pragma once

#include "voxc/Search/FormatPredictor.h"
#include "voxc/Search/Frontier.h"
#include "voxc/Support/EnumText.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

/// What is wanted of a format.
struct Wish {
  enum class Objective {
    Balanced, ///< Size and speed: twice the speed is worth four times the bytes.
    Fastest,
    Smallest,
  };
  Objective objective = Objective::Balanced;
  std::uint64_t maxBytes = ~std::uint64_t{0};
};

template <>
inline constexpr std::array<std::string_view, 3> kEnumNames<Wish::Objective> = {"balanced", "fastest",
                                                                                "smallest"};

/// Prices the candidates and simulates the rays on them. Those that are larger than the wish allows, or than
/// their references reach, are left out. Error: interrupted.
Expected<std::vector<PredictedFormat>>
predictFormats(const ModelledScene &scene, std::vector<Candidate> candidates, const std::vector<RaySet> &rays,
               const SpeedModel &model, const Wish &wish, const Progress &progress = {});

/// True for each that no other is as small and as fast as, or better.
std::vector<bool> frontierOf(std::span<const PredictedFormat> rated);

/// The one that the wish asks for; none of none.
std::optional<std::size_t> choose(std::span<const PredictedFormat> rated, const Wish &wish);
/// The same of sizes and times, as of formats that were measured.
std::optional<std::size_t> choose(std::span<const SizeTime> points, Wish::Objective objective);

} // namespace voxc
