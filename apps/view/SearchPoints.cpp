// Records to points.
#include "view/SearchPoints.h"

#include "view/FormatText.h"
#include "voxc/Measure/RecordFile.h"

#include <algorithm>
#include <map>
#include <utility>

namespace voxc::view {
namespace {

using measure::Record;

/// The times of one format.
struct Times {
  double bytes = 0;
  std::map<std::string, double> secondsPerMray; ///< By the set of rays.
};

bool isMeasured(const Record &record) {
  return record.isMeasured() && record.volume.bytes && measure::speedOf(record) &&
         measure::speedOf(record)->median > 0;
}

bool areComparable(const Record &a, const Record &b) {
  return a.model.digest == b.model.digest && a.device.name == b.device.name && a.precision == b.precision;
}

double meanSeconds(const Times &times) {
  double sum = 0;
  for (const auto &[set, seconds] : times.secondsPerMray)
    sum += seconds;
  return sum / double(times.secondsPerMray.size());
}

/// Those lead that no other beats in both size and speed; equal ones all do. The points go from small to
/// large.
void markLeading(std::vector<SearchPoint> &points) {
  std::ranges::stable_sort(points, [](const SearchPoint &a, const SearchPoint &b) {
    return std::pair(a.bytes, -a.mraysPerS) < std::pair(b.bytes, -b.mraysPerS);
  });
  const SearchPoint *best = nullptr;
  for (SearchPoint &point : points) {
    const bool isEqual = best && point.bytes == best->bytes && point.mraysPerS == best->mraysPerS;
    point.isLeading = !best || isEqual || point.mraysPerS > best->mraysPerS;
    if (point.isLeading)
      best = &point;
  }
}

} // namespace

std::optional<std::size_t> SearchPoints::find(const std::string &text) const {
  const auto found = std::ranges::find(points, text, &SearchPoint::text);
  return found == points.end() ? std::nullopt : std::optional(std::size_t(found - points.begin()));
}

std::optional<std::size_t> SearchPoints::nextLeading(std::optional<std::size_t> from, int step) const {
  const auto count = std::ptrdiff_t(points.size());
  const std::ptrdiff_t before = step > 0 ? -1 : count;
  for (std::ptrdiff_t i = (from ? std::ptrdiff_t(*from) : before) + step; i >= 0 && i < count; i += step)
    if (points[std::size_t(i)].isLeading)
      return std::size_t(i);
  return std::nullopt;
}

SearchPoints makeSearchPoints(std::span<const Record> records) {
  SearchPoints result;
  const auto first = std::ranges::find_if(records, isMeasured);
  if (first == records.end())
    return result;
  result.device = first->device.name;
  result.model = first->model.name;
  std::map<std::string, Times> formats;
  std::size_t sets = 0;
  for (const Record &record : records) {
    if (!isMeasured(record) || !areComparable(record, *first))
      continue;
    Times &times = formats[spelledText(formatText(record.format.name, record.format.passes))];
    times.bytes = double(*record.volume.bytes);
    times.secondsPerMray[record.rays.digest] = 1 / measure::speedOf(record)->median;
    sets = std::max(sets, times.secondsPerMray.size());
  }
  for (const auto &[text, times] : formats)
    if (times.secondsPerMray.size() == sets)
      result.points.push_back({text, times.bytes, 1 / meanSeconds(times)});
  markLeading(result.points);
  return result;
}

Expected<SearchPoints> readSearchPoints(const std::string &folder) {
  const auto records = VOXC_TRY(measure::readRecords(folder));
  SearchPoints points = makeSearchPoints(records);
  if (points.points.empty())
    return Error::input(folder +
                        " has no record of a format that was measured; give a folder that voxc search wrote");
  return points;
}

} // namespace voxc::view
