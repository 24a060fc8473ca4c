// Naming and cutting the cells of a search.
#include "search/SearchCells.h"

#include "voxc/Measure/Digest.h"
#include "voxc/Measure/Machine.h"

#include <map>
#include <utility>

namespace voxc::tool {
namespace {

/// Which of `count` shares has the candidate at a place of so many.
std::uint64_t shareAt(std::uint64_t place, std::uint64_t places, std::uint64_t count) {
  return place * count / places;
}

} // namespace

std::vector<measure::Record> recordsOf(const Candidate &format, bench::SweepAxes &axes,
                                       const measure::MadeByPart &madeBy) {
  auto made = bench::makeFormats({{"", format.text}}, {format.passes});
  axes.formats = made ? std::move(*made) : std::vector<bench::SweepFormat>();
  std::vector<measure::Record> records;
  for (bench::Cell &cell : bench::makeCells(axes, madeBy))
    records.push_back(std::move(cell.record));
  return records;
}

void keepShare(std::vector<Candidate> &candidates, const bench::Share &share) {
  std::vector<Candidate> kept;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (shareAt(i, candidates.size(), share.count) == share.index)
      kept.push_back(std::move(candidates[i]));
  candidates = std::move(kept);
}

std::string searchDigest(const std::vector<Candidate> &candidates, const bench::SweepAxes &axes) {
  measure::Digest digest;
  digest.add(bench::sweepDigest({axes.models, {}, axes.precisions, axes.devices}));
  for (const Candidate &candidate : candidates) {
    digest.add(candidate.text);
    for (const std::string &pass : candidate.passes)
      digest.add(pass);
  }
  return digest.hex();
}

bench::SharedCells sharedCells(const std::vector<PredictedFormat> &formats,
                               const std::vector<Candidate> &candidates, std::uint64_t count,
                               bench::SweepAxes &axes) {
  bench::SharedCells shared{.count = count, .named = {}, .digest = searchDigest(candidates, axes)};
  std::map<std::pair<std::string, std::vector<std::string>>, std::size_t> places;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    places.emplace(std::pair(candidates[i].text, candidates[i].passes), i);
  for (const PredictedFormat &format : formats) {
    const std::size_t place = places.at({format.candidate.text, format.candidate.passes});
    for (const measure::Record &record : recordsOf(format.candidate, axes, {})) {
      shared.cells.push_back(record.cell);
      shared.shares.push_back(shareAt(place, candidates.size(), count));
    }
  }
  return shared;
}

} // namespace voxc::tool
