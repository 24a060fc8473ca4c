// Checking the hits of another machine.
#include "sweep/SampleCheck.h"

#include "sweep/Group.h"
#include "sweep/Pack.h"
#include "sweep/RaySet.h"

#include "voxc/Measure/Digest.h"
#include "voxc/Measure/Subject.h"

namespace voxc::tool::bench {
namespace {

constexpr std::size_t kSampleRays = 20000;

Int3 extentOf(const Record &record) {
  const auto size = record.model.size.value_or(std::array<std::uint64_t, 3>{});
  return {static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2])};
}

/// Of a model and its size: what has an oracle of its own.
std::string voxelsOf(const Record &record) {
  const Int3 extent = extentOf(record);
  return record.model.digest + " " + std::to_string(extent.x) + " " + std::to_string(extent.y) + " " +
         std::to_string(extent.z);
}

} // namespace

std::string sampleName(const Record &record) {
  return "sample-" + Digest().add(voxelsOf(record)).add(record.rays.digest).hex() + ".bin";
}

Expected<std::vector<Ray>> packedSample(const Record &record, const std::string &folder) {
  auto rays = VOXC_TRY(keptRays(record.rays, folder + "/cache", extentOf(record)));
  return sampleRays(std::move(rays), kSampleRays).sample;
}

Expected<const Oracle *> SampleCheck::oracleOf(const Record &record) {
  const std::string voxels = voxelsOf(record);
  auto known = oracles_.find(voxels);
  if (known == oracles_.end()) {
    const auto format = VOXC_TRY(formatOf(record));
    const auto volume =
        VOXC_TRY(Volume::load(cachePath(folder_, record.model.digest, format) + ".hvx", {.trusted = true}));
    auto oracle = VOXC_TRY(Oracle::of(volume));
    known = oracles_.emplace(voxels, std::move(oracle)).first;
  }
  return &known->second;
}

Expected<void> SampleCheck::add(Record &record, std::span<const Hit> hits) {
  const auto oracle = VOXC_TRY(oracleOf(record));
  Known &known = samples_[sampleName(record)];
  if (known.rays.empty()) {
    auto rays = VOXC_TRY(packedSample(record, folder_));
    auto exact = VOXC_TRY(oracle->trace(rays));
    known = {std::move(rays), std::move(exact)};
  }
  if (hits.size() != known.rays.size())
    return Error::input("there are " + std::to_string(hits.size()) + " hits of cell " + record.cell +
                        ", but " + std::to_string(known.rays.size()) + " rays in its sample");
  record.error = errorPart(compare(*oracle, known.rays, known.exact, hits));
  record.work.rays = hits.size();
  record.work.stepsPerRay = meanSteps(hits);
  return {};
}

} // namespace voxc::tool::bench
