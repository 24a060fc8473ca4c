// Cells: what the report takes from the records of `voxc bench`. docs/bench.md describes the records.
#pragma once

#include "voxc/Support/Error.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace voxc::report {

/// A figure that a record may lack; finite and not negative.
using Figure = std::optional<double>;

struct ModelRecord {
  std::string name, input;
  std::array<Figure, 3> size; ///< Voxels along x, y and z.
  Figure voxels;
  std::string picture; ///< Path of a picture that lies in the records' folder, or "".
};

struct FormatRecord {
  std::string label, name;
  std::vector<std::string> passes;
};

struct DeviceRecord {
  std::string name, kind, driver;
  Figure threads;
  bool hasClock = false; ///< Its speed counts in its own timestamps; otherwise in CPU seconds of the process.
};

struct RaysRecord {
  std::string name, kind;
  Figure count;
  std::array<Figure, 2> size; ///< Pixels.
};

struct FailureRecord {
  std::string stage, reason;
  Figure words; ///< How far it came.
};

struct VolumeRecord {
  Figure bytes, bytesPerVoxel, fileBytes;
};

/// Seconds, and bytes of the peak.
struct BuildRecord {
  Figure load, compile, build, buildCpu, write, peakBytes;
};

struct KernelRecord {
  Figure compile, upload, firstDispatch;
};

/// Million rays a second of the clock that the device counts in.
struct SpeedRecord {
  Figure rounds, min, median, max, spread;
  bool steady = true;
};

/// Rays checked against the exact oracle, and those of them that differ.
struct ErrorRecord {
  double rays = 0, missed = 0, ghost = 0, wrong = 0;
  Figure boundary, maxDt;

  double sum() const { return missed + ghost + wrong; }
};

struct MakerRecord {
  std::string voxc, llvm, processor, command;
  Figure cores;
};

/// One cell: a format of a model, traced by a device.
struct Cell {
  std::string id;
  ModelRecord model;
  FormatRecord format;
  double resolution = 0; ///< Voxels along the longest axis of the format.
  std::string precision;
  DeviceRecord device;
  RaysRecord rays;
  bool measured = false;
  FailureRecord failure; ///< Only if it was not measured.
  VolumeRecord volume;
  BuildRecord build;
  KernelRecord kernel;
  SpeedRecord speed;
  Figure lookupsPerRay, wordsPerRay;
  std::optional<ErrorRecord> error;
  MakerRecord maker;
};

struct Records {
  std::vector<Cell> cells;        ///< In the order in which they were first written.
  std::vector<std::string> notes; ///< What was left out, and why.
};

/// The cells of all DIR/*.jsonl, read in the order of their names; of two lines with the same `cell` the later
/// one counts. A line that is no record of a known schema is left out with a note. Errors: `Input` if a folder
/// or file cannot be read, or there is no cell at all.
Expected<Records> readCells(const std::vector<std::string> &folders);

} // namespace voxc::report
