// The cells of a sweep: every model in every format at every precision on every device with its rays.
#pragma once

#include "sweep/Model.h"
#include "sweep/RaySet.h"

#include "common/FormatList.h"
#include "voxc/IR/Format.h"
#include "voxc/Measure/Record.h"
#include "voxc/Support/Error.h"

#include <optional>
#include <string>
#include <vector>

namespace voxc::tool::bench {

using namespace measure;

/// A format of a list with passes run on it.
struct SweepFormat {
  FormatLine line;
  std::vector<std::string> passes;
  std::string problem; ///< Why there is no format; "" if there is one.
  Format format;
};

/// A device as asked for, and what it is.
struct SweepDevice {
  std::string asked;
  DevicePart part;
};

struct SweepModel {
  Model model;
  std::vector<RaySet> rays;
};

/// Everything that is multiplied.
struct SweepAxes {
  std::vector<SweepModel> models;
  std::vector<SweepFormat> formats;
  std::vector<std::string> precisions;
  std::vector<SweepDevice> devices;
};

struct Cell {
  Record record;           ///< What identifies it; findings are added.
  const SweepModel *model; ///< Into the axes, as the others.
  const SweepFormat *format;
  const SweepDevice *device;
  const RaySet *rays;
  Format kernelFormat;          ///< With the precision.
  std::optional<Record> before; ///< What an earlier run found.
  bool pending = true;          ///< To be measured in this run.
  bool isKept = false;          ///< Was finished by an earlier run.
};

/// Whether every line of a list is a format, so that a slip of the pen is told before anything is built.
/// Error: `Input` with a line for each that is none.
Expected<void> checkFormats(const std::vector<FormatLine> &lines);

/// Every format with every list of passes. A format that is wrong, or a pass that goes wrong on it, is kept
/// with its problem. Error: `Usage` for a pass that there is not.
Expected<std::vector<SweepFormat>> makeFormats(const std::vector<FormatLine> &lines,
                                               const std::vector<std::vector<std::string>> &passLists);

/// Opens each device once to see that it is there and what it is. `threads`: of devices that are this
/// processor; 0: all. Error: `Environment`.
Expected<std::vector<SweepDevice>> findDevices(const std::vector<std::string> &names, unsigned threads);

/// Devices as they are asked for, for a machine that need not have them. `threads`: as above, but 0 leaves
/// open how many.
std::vector<SweepDevice> namedDevices(const std::vector<std::string> &names, unsigned threads);

/// True if a device of a record is one that `asked` of `namedDevices` stands for.
bool isMeant(const SweepDevice &asked, const DevicePart &device);

/// How records name a model.
ModelPart partOf(const Model &model);

/// The cells in the order of models, formats, rays, precisions, devices; of equal ones the first alone. The
/// axes must outlive them.
std::vector<Cell> makeCells(const SweepAxes &axes, const MadeByPart &madeBy);

} // namespace voxc::tool::bench
