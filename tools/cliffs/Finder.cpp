// From a number to findings.
#include "Finder.h"

#include "voxc/Trace/SampleIndex.h"

#include <algorithm>

namespace voxc::cliffs {
namespace {

/// Above this a time is measured again, three times, before it is told.
constexpr double kSuspect = 1.8;
constexpr std::size_t kSimulatedRays = 4096;
constexpr std::size_t kComparedRays = 2000;
/// Rays of a call whose allocations are counted where nothing is timed.
constexpr unsigned kCountedCalls = 2;

/// A reference situation, by which a machine's speed is known.
Place referencePlace() { return {0, "terrain", {128, 128, 128}, *parseFormat("R(3^3) G(4)")}; }

std::uint64_t wrongOf(const Stage &stage, const Situation &situation, const StagedRays &rays,
                      std::span<const Hit> hits, std::uint64_t &compared) {
  const Question question = questionOf(askedFormat(stage.place, situation));
  const RaySpan span = rays.span();
  std::uint64_t wrong = 0;
  const std::size_t count = std::min(span.size(), kComparedRays);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = sampleIndex(i, count, span.size());
    const Hit exact = stage.oracle.answer(span[at], question, span.bounds(at));
    const Hit &hit = hits[at];
    wrong += !std::equal(hit.voxel, hit.voxel + 3, exact.voxel) || hit.rgba != exact.rgba || hit.t != exact.t;
  }
  compared = count;
  return wrong;
}

} // namespace

Finder::Finder(std::vector<Machine> machines, const FinderOptions &options, std::optional<Peer> peer)
    : machines_(std::move(machines)), options_(options), peer_(std::move(peer)) {
  for (Machine &machine : machines_)
    shelves_.emplace_back(machine);
  calibrations_.resize(machines_.size());
}

Expected<Finder> Finder::create(std::vector<Machine> machines, const FinderOptions &options,
                                std::optional<Peer> peer) {
  Finder finder(std::move(machines), options, std::move(peer));
  if (!options.countsAlone)
    VOXC_TRY(finder.calibrate());
  return finder;
}

Expected<void> Finder::calibrate() {
  VOXC_TRY(enter(referencePlace()));
  Situation one{.rays = "missing", .count = 1}, reference{.rays = "near", .count = 65536};
  for (std::size_t machine = 0; machine < machines_.size(); ++machine) {
    Calibration &calibration = calibrations_[machine];
    const auto call = VOXC_TRY(findOn(machine, one, raysOf(*stage_, one), {.scale = 0, .perCall = 1}));
    calibration.perCall = call->cost.nanoseconds;
    const auto rays = VOXC_TRY(findOn(machine, reference, raysOf(*stage_, reference), calibration));
    calibration.scale = rays->ratio();
  }
  place_.reset();
  return {};
}

/// Builds the place, unless the finder is there.
Expected<void> Finder::enter(const Place &place) {
  if (place_ == place.number)
    return {};
  place_ = place.number;
  stage_.reset();
  for (KernelShelf &shelf : shelves_)
    shelf.clear();
  auto stage = VOXC_TRY(Stage::build(place));
  if (stage)
    stage_.emplace(std::move(*stage));
  return {};
}

Expected<std::vector<Finding>> Finder::find(std::uint64_t number) {
  const Place place = drawPlace(options_.seed, number / kSituationsOfPlace, options_.limits);
  if (auto entered = enter(place); !entered)
    return Error{entered.error().kind, describe(place) + ": " + entered.error().message};
  std::vector<Finding> findings;
  if (!stage_)
    return findings;
  const Situation situation = drawSituation(options_.seed, number, options_.limits);
  const StagedRays rays = raysOf(*stage_, situation);
  for (std::size_t machine = 0; machine < machines_.size(); ++machine) {
    auto finding = findOn(machine, situation, rays, calibrations_[machine]);
    if (!finding)
      return Error{finding.error().kind,
                   describe(place) + ", " + describe(situation) + ": " + finding.error().message};
    if (*finding)
      findings.push_back(std::move(**finding));
  }
  if (peer_ && !findings.empty() && situation.instances == 0) {
    const auto peer = peer_->nanoseconds(*stage_, rays.plain);
    for (Finding &finding : findings)
      finding.peer = peer;
  }
  return findings;
}

Expected<std::optional<Finding>> Finder::findOn(std::size_t machine, const Situation &situation,
                                                const StagedRays &rays, const Calibration &calibration) {
  KernelShelf &shelf = shelves_[machine];
  auto subject = VOXC_TRY(Subject::of(shelf, *stage_, situation, rays));
  if (!subject)
    return std::optional<Finding>();
  Finding finding{.place = stage_->place, .situation = situation, .machine = machines_[machine].name};
  for (unsigned call = 0; options_.countsAlone && call < kCountedCalls; ++call)
    finding.cost.allocations = VOXC_TRY(countCall(*subject));
  if (!options_.countsAlone)
    finding.cost = VOXC_TRY(measure(*subject));
  const StagedRays some = someOf(rays, kSimulatedRays);
  finding.expected =
      VOXC_TRY(expect(machines_[machine], calibration, *stage_, situation, *subject, rays, some));
  for (int again = 0; again < 3 && !options_.countsAlone && finding.ratio() > kSuspect; ++again)
    VOXC_TRY(measureAgain(*subject, finding.cost));
  if (!options_.countsAlone && finding.ratio() > kSuspect) {
    const auto moved = VOXC_TRY(costMovedOff(shelf, situation, rays));
    finding.movedOff = moved.nanoseconds / static_cast<double>(situation.count);
  }
  if (situation.instances > 0)
    return std::optional(std::move(finding));
  finding.wrong = wrongOf(*stage_, situation, rays, subject->hits(), finding.compared);
  VOXC_TRY(count(shelf, situation, some, *subject, finding));
  return std::optional(std::move(finding));
}

/// What the rays cost once they are moved off a little.
Expected<Cost> Finder::costMovedOff(KernelShelf &shelf, const Situation &situation,
                                    const StagedRays &rays) const {
  const StagedRays moved = movedOff(rays);
  auto subject = VOXC_TRY(Subject::of(shelf, *stage_, situation, moved));
  return measure(*subject);
}

/// Look-ups, and what was left to exact arithmetic.
Expected<void> Finder::count(KernelShelf &shelf, const Situation &situation, const StagedRays &some,
                             Subject &subject, Finding &finding) const {
  finding.lookups = VOXC_TRY(subject.lookupsOf(some.span()));
  const Format format = askedFormat(stage_->place, situation);
  finding.exactSteps = VOXC_TRY(shelf.exactStepsOf(stage_->volume, format, some.span()));
  return {};
}

} // namespace voxc::cliffs
