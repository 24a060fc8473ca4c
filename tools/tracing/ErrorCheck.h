// A speed beside its error: some of the rays that were traced, checked against the exact oracle.
#pragma once

#include "common/CommandLine.h"
#include "common/Json.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Trace/BoundedRay.h"
#include "voxc/Volume/Volume.h"

#include <cstddef>
#include <span>

namespace voxc::tool {

/// The error figures as the JSON object `error`.
Json errorJson(const ErrorFigures &error);

class ErrorCheck {
public:
  /// Checks so many rays if nobody says how many.
  explicit ErrorCheck(std::size_t sample) : sample_(sample) {}

  /// Adds --check to a command.
  void declare(const CommandLine &command);

  /// How many rays are checked.
  std::size_t rays() const { return sample_; }

  /// Checks the sample, evenly spread over the rays, for what was asked, and adds `error`; with --check 0
  /// nothing. Errors: as `Oracle::of`.
  Expected<void> run(const Volume &volume, const RaySpan &rays, std::span<const Hit> hits,
                     const Question &question, const Progress &progress, Json &figures) const;

private:
  std::size_t sample_;
};

} // namespace voxc::tool
