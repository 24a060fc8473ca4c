// Multiplying the axes of a sweep.
#include "sweep/Cells.h"

#include "tracing/TraceSession.h"
#include "voxc/IR/Query.h"
#include "voxc/Measure/Digest.h"
#include "voxc/Measure/Subject.h"
#include "voxc/Passes/Pass.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

namespace voxc::tool::bench {
namespace {

/// Rendered diagnostics are several lines, of which the first says what is wrong, after the place.
std::string firstMessage(const std::string &text) {
  constexpr std::string_view kMark = "error: ";
  const std::string line = text.substr(0, text.find('\n'));
  const std::size_t mark = line.find(kMark);
  return mark == std::string::npos ? line : line.substr(mark + kMark.size());
}

SweepFormat makeFormat(const FormatLine &line, const std::vector<std::string> &passes) {
  SweepFormat result{line, passes, "", {}};
  Expected<Format> format = parseFormat(line.text);
  if (!format) {
    result.problem = firstMessage(format.error().message);
    return result;
  }
  if (Expected<void> passed = runPasses(*format, passes); !passed)
    result.problem = firstMessage(passed.error().message);
  result.format = std::move(*format);
  return result;
}

/// What a format is known by; one that could not be read by its text.
FormatPart partOf(const SweepFormat &format, const Format &kernelFormat) {
  const FormatLine &line = format.line;
  return format.problem.empty()
             ? measure::formatPart(line.label, line.text, format.passes, kernelFormat)
             : FormatPart{line.label, line.text, format.passes, Digest().add(line.text).hex()};
}

Cell makeCell(const SweepModel &model, const SweepFormat &format, const RaySet &rays,
              const std::string &precision, const SweepDevice &device) {
  Cell cell{{}, &model, &format, &device, &rays, format.format, {}, true, false};
  if (format.problem.empty()) {
    askForPrecision(cell.kernelFormat, precision);
    cell.record.resolution = measure::longestAxis(format.format);
  }
  cell.record.model = partOf(model.model);
  cell.record.format = partOf(format, cell.kernelFormat);
  cell.record.precision = precision;
  cell.record.device = device.part;
  cell.record.rays = rays.part;
  cell.record.cell = cellDigest(cell.record);
  return cell;
}

} // namespace

ModelPart partOf(const Model &model) {
  return {model.name, std::filesystem::path(model.input).filename().string(), model.digest, {}, {}, {}};
}

Expected<void> checkFormats(const std::vector<FormatLine> &lines) {
  std::string problems;
  for (const FormatLine &line : lines)
    if (const Expected<Format> format = parseFormat(line.text); !format)
      problems += (problems.empty() ? "'" : "\n  '") + line.text +
                  "' is no format: " + firstMessage(format.error().message);
  if (!problems.empty())
    return Error::input(problems);
  return {};
}

Expected<std::vector<SweepFormat>> makeFormats(const std::vector<FormatLine> &lines,
                                               const std::vector<std::vector<std::string>> &passLists) {
  for (const auto &passes : passLists)
    for (const std::string &name : passes)
      if (!findPass(name)) {
        Format any;
        return Error::usage(runPasses(any, std::span(&name, 1)).error().message);
      }
  std::vector<SweepFormat> formats;
  for (const FormatLine &line : lines)
    for (const auto &passes : passLists)
      formats.push_back(makeFormat(line, passes));
  return formats;
}

Expected<std::vector<SweepDevice>> findDevices(const std::vector<std::string> &names, unsigned threads) {
  limitDeviceThreads(threads);
  measure::Devices devices;
  std::vector<SweepDevice> found;
  found.reserve(names.size());
  for (const std::string &name : names) {
    const auto device = VOXC_TRY(devices.open(name));
    found.push_back({name, measure::devicePart(device, threads)});
  }
  return found;
}

std::vector<SweepDevice> namedDevices(const std::vector<std::string> &names, unsigned threads) {
  std::vector<SweepDevice> devices;
  devices.reserve(names.size());
  for (const std::string &name : names)
    devices.push_back({name, {name, "", "", threads > 0 ? Count(threads) : std::nullopt, ""}});
  return devices;
}

bool isMeant(const SweepDevice &asked, const DevicePart &device) {
  const Count &threads = asked.part.threads;
  if (threads && device.threads && *threads != *device.threads)
    return false;
  const auto equal = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return asked.asked.empty() || !std::ranges::search(device.name, asked.asked, equal).empty();
}

std::vector<Cell> makeCells(const SweepAxes &axes, const MadeByPart &madeBy) {
  std::vector<Cell> cells;
  std::set<std::string> known;
  for (const SweepModel &model : axes.models)
    for (const SweepFormat &format : axes.formats)
      for (const RaySet &rays : model.rays)
        for (const std::string &precision : axes.precisions)
          for (const SweepDevice &device : axes.devices) {
            Cell cell = makeCell(model, format, rays, precision, device);
            cell.record.madeBy = madeBy;
            if (known.insert(cell.record.cell).second)
              cells.push_back(std::move(cell));
          }
  return cells;
}

} // namespace voxc::tool::bench
