// speeds.json: for each device and processor the weights of its model.
#include "voxc/Measure/SavedWeights.h"

#include "Measure/Json.h"
#include "voxc/Measure/Machine.h"
#include "voxc/Support/File.h"
#include "voxc/Support/UserCache.h"
#include "voxc/Trace/CpuKernel.h"
#include "voxc/Trace/Tracer.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>

namespace voxc::measure {

namespace {

namespace fs = std::filesystem;

/// Weights of another list of terms are of no use.
constexpr int kVersion = 3;

/// Empty without a home.
fs::path keptPath() {
  const fs::path cache = userCache();
  return cache.empty() ? cache : cache / "speeds.json";
}

Json readKept() {
  const Expected<std::string> text = readTextFile(keptPath().string());
  Json kept = text ? Json::parse(*text, nullptr, false) : Json();
  const bool isUsable = kept.is_object() && kept.value("version", Json()) == kVersion &&
                        kept.contains("devices") && kept["devices"].is_array();
  return isUsable ? kept : Json{{"version", kVersion}, {"devices", Json::array()}};
}

std::string lowered(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower;
}

std::optional<SpeedModel> modelOf(const Json &entry) {
  const Json weights = entry.value("nanoseconds", Json());
  SpeedModel model;
  if (!weights.is_array() || weights.size() != model.nanoseconds.size())
    return std::nullopt;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!weights[i].is_number() || !(weights[i].get<double>() >= 0))
      return std::nullopt;
    model.nanoseconds[i] = weights[i].get<double>();
  }
  return model;
}

bool isText(const Json &entry, const char *key) {
  return entry.is_object() && entry.contains(key) && entry[key].is_string();
}

} // namespace

KnownSpeeds knownSpeedsOf(std::string_view name) {
  const std::string processor = madeBy("").processor, wanted = lowered(name);
  const Json kept = readKept();
  for (const Json &entry : kept["devices"])
    if (isText(entry, "device") && isText(entry, "processor") && entry["processor"] == processor &&
        lowered(entry["device"].get<std::string>()).find(wanted) != std::string::npos)
      if (const auto model = modelOf(entry))
        return {*model, true};
  return {defaultSpeedModel(name), false};
}

Expected<void> checkSpeedsKnown(const std::string &name) {
  if (name == cpuDeviceInfo().name || name == "llvmpipe" || knownSpeedsOf(name).isMeasured)
    return {};
  const Expected<Device> device = Device::open(name);
  return device ? Expected<void>()
                : Error{device.error().kind, device.error().message + "; and cpu, this processor"};
}

Expected<void> keepSpeedModel(const std::string &device, const SpeedModel &model) {
  const fs::path path = keptPath();
  if (path.empty())
    return {};
  std::error_code failure;
  fs::create_directories(path.parent_path(), failure);
  if (failure)
    return Error::environment("cannot make the folder '" + path.parent_path().string() +
                              "': " + failure.message());
  const std::string processor = madeBy("").processor;
  Json kept = readKept();
  Json devices =
      Json::array({{{"device", device}, {"processor", processor}, {"nanoseconds", model.nanoseconds}}});
  for (const Json &entry : kept["devices"])
    if (isText(entry, "device") && isText(entry, "processor") &&
        (entry["device"] != device || entry["processor"] != processor))
      devices.push_back(entry);
  kept["devices"] = std::move(devices);
  return writeFile(path.string(), kept.dump(1) + "\n");
}

} // namespace voxc::measure
