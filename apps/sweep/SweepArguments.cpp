// Reading what a sweep is told.
#include "sweep/SweepArguments.h"

#include "voxc/IR/Query.h"
#include "voxc/Measure/Machine.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace voxc::tool::bench {
namespace {

std::vector<std::string> split(const std::string &text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    if (end > begin)
      parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// Numbers and UUIDs of devices, which are those of one machine. Some names, such as "ada", have the digits
/// of a UUID, but not as many.
bool isOfOneMachine(const std::string &device) {
  constexpr std::ptrdiff_t kUuidDigits = 32;
  const auto isDigit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto isOfUuid = [](unsigned char c) { return std::isxdigit(c) != 0 || c == '-'; };
  const bool isNumber = !device.empty() && std::ranges::all_of(device, isDigit);
  const bool isUuid = std::ranges::all_of(device, isOfUuid) &&
                      std::ssize(device) - std::ranges::count(device, '-') == kUuidDigits;
  return isNumber || isUuid;
}

} // namespace

void SweepArguments::declareAxes(const CommandLine &command) {
  command
      .add("INPUT", inputs_,
           "Models: an INPUT of voxc build, with NAME= before it and options of inputs behind it if you "
           "like, all in one argument")
      .takes("");
  command
      .add("--formats", formats_,
           "Formats: \"F;F;F\", or a file with one a line, a label and a tab before it if you like; "
           "may be given several times")
      .repeated()
      .takes("LIST");
  command
      .add("--passes", passes_,
           "Passes to run on every format, in any order, or none; given several times, formats are measured "
           "with each")
      .repeated()
      .takes("A,B");
  command.add("--precisions", precisions_, "Precisions, separated by commas")
      .repeated()
      .list()
      .takes("A,B")
      .oneOf(std::vector<std::string>(precisionNames().begin(), precisionNames().end()))
      .showsDefault("exact");
  command
      .add("--devices", devices_,
           "Devices whose names contain these, or cpu, separated by commas; default: the best")
      .repeated()
      .list()
      .takes("A,B");
  command
      .add("--cameras", rays_.cameraFile,
           "A camera file: its camera of a model's name, or all if there is none; default: one that sees the "
           "whole volume")
      .takes("FILE");
  command
      .add("--size", rays_.size, "Pixels of the cameras' pictures; default: the camera file's, or 1280x720")
      .takes("WxH");
  command.add("--rays", rays_.rayFiles, "A file of rays; may be given several times")
      .repeated()
      .takes("R.bin");
  addOrderArgument(command, rays_.order);
}

void SweepArguments::declareMeasuring(const CommandLine &command) {
  command.add("--repeat", measure_.rounds, "Rounds in which formats are timed in turn")
      .takes("N")
      .between(1u, 1000u)
      .showsDefault();
  command
      .add("--check", measure_.check,
           "Rays, evenly spread, on which errors, steps and words read are found; 0: none")
      .takes("N")
      .showsDefault();
  command.add("--steady", steadyPercent_, "Spread of the rounds in percent up to which a speed is steady")
      .takes("PERCENT")
      .between(0.0, 1000.0)
      .showsDefault();
  addMaxBytesArgument(command, building_);
  command.option("--max-bytes").text("Give up a volume whose words take more; default: half of the memory");
  addMemoryArguments(command, building_);
  command
      .add("--threads", building_.threads,
           "Threads that build, and of devices that are this processor; default: all")
      .takes("N")
      .between(1u, 1024u);
  command.addFlag("--retry", retry_, "Try cells again that failed in an earlier run");
  command.addFlag("--again", again_, "Measure cells again that an earlier run measured");
}

void SweepArguments::declare(const CommandLine &command) {
  declareAxes(command);
  declareMeasuring(command);
  addInputArguments(command, inputArguments_);
}

Expected<std::vector<FormatLine>> SweepArguments::readFormats() const {
  std::vector<FormatLine> lines;
  for (const std::string &argument : formats_) {
    const auto list = VOXC_TRY(readFormatList(argument));
    lines.insert(lines.end(), list.begin(), list.end());
  }
  VOXC_TRY(checkFormats(lines));
  return lines;
}

std::vector<std::vector<std::string>> SweepArguments::passLists() const {
  constexpr const char *kNone = "none";
  std::vector<std::vector<std::string>> lists;
  lists.reserve(passes_.size());
  for (const std::string &text : passes_)
    lists.push_back(text == kNone ? std::vector<std::string>() : split(text, ','));
  if (lists.empty())
    lists.emplace_back();
  return lists;
}

Expected<std::vector<SweepModel>> SweepArguments::readModels() const {
  std::vector<SweepModel> models;
  std::set<std::string> names;
  for (const std::string &input : inputs_) {
    auto model = VOXC_TRY(readModel(input, inputArguments_));
    if (!names.insert(model.name).second)
      return Error::usage("two inputs have the name '" + model.name + "'; write NAME=INPUT for one of them");
    auto rays = VOXC_TRY(readRaySets(rays_, model.name));
    models.push_back({std::move(model), std::move(rays)});
  }
  return models;
}

Expected<std::vector<SweepDevice>> SweepArguments::readDevices(bool namesAlone) const {
  const std::vector<std::string> names = devices_.empty() ? std::vector<std::string>{""} : devices_;
  if (!namesAlone)
    return findDevices(names, building_.threads);
  if (const auto bad = std::ranges::find_if(names, isOfOneMachine); bad != names.end())
    return Error::usage(
        "--devices " + *bad +
        " is a number or UUID of one machine's device; name the device, for other processes look for it");
  return namedDevices(names, building_.threads);
}

Expected<SweepAxes> SweepArguments::readAxes(bool namesAlone) const {
  const auto lines = VOXC_TRY(readFormats());
  auto formats = VOXC_TRY(makeFormats(lines, passLists()));
  auto models = VOXC_TRY(readModels());
  auto devices = VOXC_TRY(readDevices(namesAlone));
  return SweepAxes{std::move(models), std::move(formats), precisions_, std::move(devices)};
}

SweepOptions SweepArguments::options(const std::string &folder) const {
  const std::uint64_t half = machineMemory() / 2;
  SweepOptions options{.folder = folder,
                       .build = {},
                       .measure = measure_,
                       .groupBytes = half,
                       .retry = retry_,
                       .again = again_};
  options.measure.threads = building_.threads;
  options.measure.steady = steadyPercent_ / 100;
  options.build.maxBytes = building_.maxBytes.empty() ? half : tool::bytesOf(building_.maxBytes);
  const auto pass = [&](const char *option, const std::string &value) {
    if (!value.empty())
      options.build.options.push_back(std::string(option) + "=" + value);
  };
  pass("--memory", building_.memory);
  pass("--scratch", building_.scratch);
  pass("--threads", building_.threads > 0 ? std::to_string(building_.threads) : "");
  return options;
}

} // namespace voxc::tool::bench
