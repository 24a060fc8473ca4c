// A record: what was found about one cell of a sweep, one JSON object a line; docs/bench.md has the schema.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Support/Error.h"
#include "voxc/Trace/Tracer.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::measure {

/// The version of the schema that is written, and the only one that is read.
inline constexpr std::uint64_t kSchema = 1;

/// Figures that were not taken are absent, here and in the JSON.
using Figure = std::optional<double>;
using Count = std::optional<std::uint64_t>;

/// The scene.
struct ModelPart {
  std::string name;
  std::string input;                                ///< The INPUT argument's last part, without its folders.
  std::string digest;                               ///< Of its content and of how it was voxelized.
  std::optional<std::array<std::uint64_t, 3>> size; ///< Voxels along x, y, z.
  Count voxels;                                     ///< Those that are not empty.
  std::optional<std::string> picture;               ///< A PNG file, relative to the folder of the record.
};

/// The format with its passes.
struct FormatPart {
  std::string label; ///< As the list of formats has it, or "".
  std::string name;  ///< In the grammar of formats.
  std::vector<std::string> passes;
  std::string digest; ///< Of its IR, the traversal included.
};

/// Where it was traced.
struct DevicePart {
  std::string name;
  std::string kind; ///< "vulkan" or "cpu".
  std::string driver;
  Count threads;     ///< Of a device that is a processor.
  std::string clock; ///< What the speed counts in: "cpu", seconds of the process, or "gpu", timestamps.
};

/// What was traced.
struct RaysPart {
  std::string name; ///< Of the camera or the file.
  std::string kind; ///< "camera" or "file".
  std::uint64_t count = 0;
  std::optional<std::array<std::uint64_t, 2>> size; ///< Of the camera's picture in pixels.
  std::string digest;
  std::optional<std::string> order; ///< "given" or "binned", if one was asked for.
};

/// Why a cell has no speed.
struct Failure {
  std::string stage; ///< "parse", "build", "compile" or "trace".
  std::string reason;
  Count words; ///< How many words the volume had when it failed.
};

/// The volume's size.
struct VolumePart {
  Count words, bytes, fileBytes;
  Figure bytesPerVoxel;
  std::optional<std::vector<std::uint64_t>> levelWords; ///< Of each level, the highest first.
};

/// What `voxc search` expected before it measured.
struct PredictedPart {
  Count words;
  Figure mraysPerS; ///< In what the device's clock counts, as the speed that counts.
  Figure turns;     ///< Steps of a ray over what is empty, and one for what it hits.
  Figure lines;     ///< Different cache lines that neighbouring rays read, a ray's share of them.
};

/// Making the volume, in a process of its own.
struct BuildPart {
  Figure loadSeconds, compileSeconds, buildSeconds, buildCpuSeconds, writeSeconds;
  Count peakRssBytes;
};

/// What comes before the first round.
struct KernelPart {
  Figure compileSeconds, uploadSeconds, firstDispatchSeconds;
};

/// A speed of several rounds, in million rays a second.
struct Speed {
  double min = 0, median = 0, max = 0;
  double spread = 0; ///< (max - min) / median.
};

struct SpeedPart {
  Count rounds;
  std::optional<Speed> mraysPerS, mraysPerCpuS, mraysPerDeviceS;
  std::optional<bool> steady;       ///< Whether the spread is within what the sweep allowed.
  std::optional<std::string> order; ///< In which the rays were taken: "given" or "binned".
};

/// What the kernel did for a ray, on the mean.
struct WorkPart {
  Count hits; ///< Of all rays.
  Count rays; ///< Those that steps and words were counted on.
  Figure stepsPerRay, wordsPerRay;
};

/// Against the oracle; see `ErrorFigures`.
struct ErrorPart {
  Count rays, missed, ghost, wrong, boundary, colour;
  Figure maxDt, rmsDt, maxUlpDt;
};

/// What made the record.
struct MadeByPart {
  std::string voxc, llvm, processor;
  Count cores;
  std::string command;
};

struct Record {
  std::string cell; ///< 16 hex digits: digest of what identifies the cell.
  ModelPart model;
  FormatPart format;
  Count resolution; ///< The longest axis of the format.
  std::string precision;
  DevicePart device;
  RaysPart rays;
  std::optional<Failure> failure; ///< None: the cell was measured.
  VolumePart volume;
  BuildPart build;
  KernelPart kernel;
  SpeedPart speed;
  WorkPart work;
  ErrorPart error;
  std::optional<PredictedPart> predicted;
  MadeByPart madeBy;

  bool isMeasured() const { return !failure; }
};

/// The spread up to which a speed is steady, unless another is asked for.
inline constexpr double kSteadySpread = 0.1;

/// The speed that counts on the record's device: per CPU second where its clock is "cpu", per second of the
/// device where it is "gpu". None if the cell was not measured.
const std::optional<Speed> &speedOf(const Record &record);

/// The speed of so many rays that took so many seconds in each round. None without rounds.
std::optional<Speed> speedOf(std::uint64_t rays, const std::vector<double> &seconds);

/// The rays' name, and the order that was asked for.
std::string titleOf(const RaysPart &rays);

/// The digest that identifies the record's cell, of model, format, precision, device and rays.
std::string cellDigest(const Record &record);

/// The part of a format that was read, of which `kernel` is what a kernel traverses, its precision included;
/// `text` is what was written.
FormatPart formatPart(const std::string &label, const std::string &text,
                      const std::vector<std::string> &passes, const Format &kernel);
/// The voxels along a format's longest axis.
std::uint64_t longestAxis(const Format &format);

/// The part of a device; null: this processor, which computes by so many threads, 0: all.
DevicePart devicePart(const Device *device, unsigned threads);

ErrorPart errorPart(const ErrorFigures &error);

/// True if two speeds are the same, as far as their rounds show: their medians differ by no more than the
/// wider of the two spreads.
bool areEqual(const Speed &a, const Speed &b);

/// A line of a file of records, without its end.
std::string toLine(const Record &record);

/// A record from a line. Errors (`Input`): no JSON object, another schema, a key that is missing or has a
/// value of another type, by its name.
Expected<Record> parseRecord(std::string_view line);

} // namespace voxc::measure
