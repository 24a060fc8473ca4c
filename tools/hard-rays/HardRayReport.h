// What came of hard rays: figures by class and device, and rays that failed, as they go into a corpus.
#pragma once

#include "hard-rays/HardRayCorpus.h"

#include "common/Json.h"
#include "voxc/IR/Format.h"
#include "voxc/Oracle/Oracle.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace voxc::tool {

/// Rays of one scene with their exact hits, class by class.
struct RaySet {
  struct Part {
    std::string name; ///< Of the class.
    std::size_t begin;
    std::size_t count;
  };
  std::string scene;
  Int3 extent;
  std::vector<Ray> rays;
  std::vector<RayBounds> bounds; ///< Of each; empty: rays have none.
  std::vector<Hit> exact;
  std::vector<Part> parts;

  bool isBounded() const { return !bounds.empty(); }
  /// The rays with their bounds, or with [0, +inf].
  std::vector<BoundedRay> boundedRays() const;
};

/// A ray of a set, as it stands in a corpus.
CorpusRay corpusRay(const RaySet &set, std::size_t index);

class HardRayReport {
public:
  /// Which differences are failures.
  struct Rules {
    bool allowBoundary = false;   ///< Those that float rounding at a boundary explains are none.
    std::optional<double> maxUlp; ///< A t that is further off is one.
  };
  explicit HardRayReport(Rules rules) : rules_(rules) {}

  /// Compares the hits that a kernel of `format` found on `device` with those of the set.
  void add(const RaySet &set, const Oracle &oracle, std::span<const Hit> hits, const Format &format,
           const std::string &device);

  /// Rays compared so far, and those of them that fail.
  std::uint64_t rays() const { return total_.rays; }
  std::uint64_t failures() const { return failed_; }
  /// What the failures come to, in one sentence; nothing if there are none.
  std::optional<Error> verdict() const;

  /// Prints the table, and the first failures, to standard output.
  void print() const;
  /// Adds `error`, `classes`, `devices_error` and `failures`.
  void addTo(Json &figures) const;

private:
  using Figures = std::vector<std::pair<std::string, ErrorFigures>>; // In the order of their first rays.
  struct Failure {
    std::string format;
    std::string device;
    std::string className;
    CorpusRay ray;
    Hit kernel;
  };

  std::uint64_t failuresOf(const ErrorFigures &error) const;
  void keep(const RaySet &set, std::size_t index, const Hit &hit, const Failure &failure);

  Rules rules_;
  ErrorFigures total_;
  Figures classes_;
  Figures devices_;
  std::uint64_t failed_ = 0;
  std::vector<Failure> kept_;
};

} // namespace voxc::tool
