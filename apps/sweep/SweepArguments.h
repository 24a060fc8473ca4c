// The options that say what a sweep measures, and how.
#pragma once

#include "sweep/Sweep.h"

#include "options/BuildArguments.h"
#include "options/InputArguments.h"

#include <string>
#include <vector>

namespace voxc::tool::bench {

class SweepArguments {
public:
  /// Adds INPUT with its options, the axes, and how cells are measured to a command.
  void declare(const CommandLine &command);

  /// Was anything named that could be measured?
  bool isGiven() const { return !inputs_.empty() && !formats_.empty(); }
  unsigned threads() const { return building_.threads; }

  /// Reads formats, models and rays. Devices are opened to see what they are or, if `namesAlone`, known by
  /// their names. Errors: `Usage` and `Input` of what was written, `Environment` of devices.
  Expected<SweepAxes> readAxes(bool namesAlone) const;

  /// How it is measured, in a folder.
  SweepOptions options(const std::string &folder) const;

private:
  void declareAxes(const CommandLine &command);
  void declareMeasuring(const CommandLine &command);

  Expected<std::vector<SweepModel>> readModels() const;
  Expected<std::vector<FormatLine>> readFormats() const;
  std::vector<std::vector<std::string>> passLists() const;
  Expected<std::vector<SweepDevice>> readDevices(bool namesAlone) const;

  std::vector<std::string> inputs_, formats_, passes_, devices_;
  std::vector<std::string> precisions_{"exact"};
  InputArguments inputArguments_;
  RayArguments rays_;
  BuildArguments building_;
  MeasureOptions measure_;
  double steadyPercent_ = 10;
  bool retry_ = false, again_ = false;
};

} // namespace voxc::tool::bench
