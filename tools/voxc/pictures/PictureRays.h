// The rays of pictures of one volume, and what they come to over all of them.
#pragma once

#include "common/PictureOptions.h"
#include "common/RayTally.h"
#include "tracing/TraceSession.h"
#include "voxc/Trace/Clip.h"

#include <optional>

namespace voxc::tool {

class PictureRays {
public:
  /// Traces with `tracing`, which is prepared, what `clip` keeps, by a kernel with bounds if that cuts
  /// anything; keeps so many of the rays of every trace from the eye.
  PictureRays(TraceSession &tracing, std::size_t sample, Clip clip)
      : tracing_(tracing), clip_(std::move(clip)), eye_(sample) {}

  /// Where the options take a picture from. Errors as `placeCamera`.
  Expected<PlacedCamera> findCamera(const PictureOptions &options, const Volume &volume);
  /// Takes a picture. Errors: those of tracing.
  Expected<TakenPicture> take(const Volume &volume, const PlacedCamera &placed, RenderOptions options);

  /// What paging has done so far, if that is how rays are traced.
  std::optional<PagingReport> paging() const { return tracing_.paging(); }
  unsigned threads() const { return tracing_.threads(); }
  /// Those from the eye.
  const RayTally &eye() const { return eye_; }
  /// Adds the figures of tracing, and of rays to the light where there were any.
  void addFigures(Json &figures) const;

private:
  /// Sends rays through, and counts them.
  auto through(RayTally &tally);

  TraceSession &tracing_;
  Clip clip_;
  RayTally eye_, light_;
};

} // namespace voxc::tool
