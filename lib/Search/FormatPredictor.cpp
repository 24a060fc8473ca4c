// Pricing and simulating.
#include "voxc/Search/FormatPredictor.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <numeric>

namespace voxc {

double PredictedFormat::time() const {
  return std::accumulate(nanoseconds.begin(), nanoseconds.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(nanoseconds.size(), 1));
}

void predictAgain(PredictedFormat &format, const SpeedModel &model) {
  for (std::size_t i = 0; i < format.costs.size(); ++i)
    format.nanoseconds[i] = model.predict(speedTerms(format.costs[i], format.bytes())) * format.factor;
}

FormatPredictor::FormatPredictor(const ModelledScene &scene) : scene_(scene), shapes_(scene.shape) {
  if (scene.colours)
    colours_.emplace(*scene.colours);
}

std::optional<PredictedFormat> FormatPredictor::predict(Candidate candidate, std::span<const RaySet> rays,
                                                        const SpeedModel &model, std::uint64_t maxBytes) {
  const Int3 held = candidate.format.extent();
  if (held.x < scene_.extent.x || held.y < scene_.extent.y || held.z < scene_.extent.z)
    return std::nullopt;
  const Layout layout = layoutOf(candidate.format);
  const PayloadKind &payload = kindOf(layout.payload);
  const bool inPlace = payload.varies && !layout.ranksVoxels();
  if (inPlace && !colours_)
    return std::nullopt;
  auto price = inPlace ? colours_->price(layout) : shapes_.price(layout, scene_.valueWords);
  if (!price || price->words() > std::min(layout.maxWords(), maxBytes / sizeof(std::uint32_t)))
    return std::nullopt;
  // Values apart are counted as colours, of four bytes or of a palette.
  if (payload.labels || payload.code)
    price->exact &= !layout.ranksVoxels();
  PredictedFormat format{std::move(candidate), std::move(*price), {}, {}};
  format.factor = lookUpFactor(layout.strata);
  simulateAgain(format, rays, model);
  return format.costs.size() == rays.size() ? std::optional(std::move(format)) : std::nullopt;
}

void FormatPredictor::simulateAgain(PredictedFormat &format, std::span<const RaySet> rays,
                                    const SpeedModel &model) const {
  format.costs.clear();
  const auto plan = makePlan(format.candidate.format, kCpuPlan);
  if (!plan)
    return;
  for (const RaySet &set : rays)
    format.costs.emplace_back(modelRayCost(scene_.shape, set.rays, *plan)).binned = set.isBinned ? 1 : 0;
  format.nanoseconds.resize(format.costs.size());
  predictAgain(format, model);
}

} // namespace voxc
