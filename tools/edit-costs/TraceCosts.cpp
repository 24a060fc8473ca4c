// Rounds in turn.
#include "TraceCosts.h"

#include "common/RayFile.h"
#include "voxc/Kernel/OpenTracer.h"
#include "voxc/Support/File.h"
#include "voxc/Support/UserCache.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace voxc::edits {
namespace {

constexpr int kRounds = 7;

/// A tracer, its hits, and the seconds of each round.
struct Side {
  std::unique_ptr<Tracer> tracer;
  std::vector<Hit> hits;
  std::vector<double> seconds;

  Expected<void> round(RaySpan rays) {
    hits.resize(rays.size());
    const auto report = tracer->trace(rays, hits, {.order = RayOrder::Given});
    if (report)
      seconds.push_back(report->repeats[0].cpu);
    return report ? Expected<void>() : report.error();
  }
  double median() {
    std::ranges::sort(seconds);
    return seconds[seconds.size() / 2];
  }
};

} // namespace

Expected<void> compareTraces(EditableVolume &edited, const std::string &path, const std::string &device) {
  const auto mapped = MappedFile::open(path);
  const auto file =
      VOXC_TRY(mapped ? tool::parseRayFile(mapped->bytes(), path) : Expected<tool::RayFile>(mapped.error()));
  const auto built = VOXC_TRY(edited.compact());
  const auto volume = edited.volume();
  Side sides[2];
  for (Side &side : sides) {
    const Volume &traced = &side == sides ? *volume : built.volume;
    side.tracer = VOXC_TRY(openTracer(traced, {.device = device,
                                               .threads = 1,
                                               .cache = compileCache(),
                                               .optimise = true,
                                               .start = CpuStart::Whole}));
  }
  for (int round = 0; round < kRounds; ++round)
    for (Side &side : sides)
      VOXC_TRY(side.round(file.rays()));
  std::size_t different = 0;
  for (std::size_t i = 0; i < sides[0].hits.size(); ++i)
    different += std::memcmp(&sides[0].hits[i], &sides[1].hits[i], offsetof(Hit, steps)) != 0 ? 1 : 0;
  std::printf("traced on %s: edited %.3f s of CPU, built %.3f, %.3f times; words %.3f times; %zu of %zu hits "
              "differ\n",
              device.c_str(), sides[0].median(), sides[1].median(), sides[0].median() / sides[1].median(),
              double(edited.words()) / double(built.volume.words().size()), different, sides[0].hits.size());
  return different == 0 ? Expected<void>()
                        : Error::input("hits through an edited volume are not those of a build");
}

} // namespace voxc::edits
