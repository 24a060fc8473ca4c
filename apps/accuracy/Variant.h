// Variants: one kernel on one device each, whose speeds and errors are compared on the same rays.
#pragma once

#include "common/Json.h"
#include "common/OrderOption.h"
#include "common/Repeats.h"
#include "tracing/TraceSession.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Support/Progress.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc::tool {

/// What to compare: every precision with every traversal on every device.
struct VariantChoice {
  std::vector<std::string> precisions;
  std::vector<std::string> traversals; ///< Of trees; formats without trees have but one traversal.
  std::vector<std::string> devices;
  unsigned threads = 0; ///< 0: each device's own choice.
};

/// The traversals that trees can have.
std::vector<std::string> traversalsOfTrees();

/// One kernel on one device.
struct Variant {
  std::string precision;
  std::string traversal; ///< "" where the format has no trees.
  std::string device;
  double lod = 0; ///< Pixels.
  Format format;  ///< As the kernel traverses it.

  /// "exact restart cpu": what sets it apart from others; the device only where there are `severalDevices`.
  std::string label(bool severalDevices) const;
};

/// The variants of a choice for a volume's format, traversals inside precisions inside devices.
std::vector<Variant> makeVariants(const Format &format, const VariantChoice &choice);

/// The same kernel, stopping at what looks smaller than so many pixels.
Variant withLod(const Variant &variant, double pixels);

/// A variant that is ready to trace a volume, and what was found about it.
struct VariantCandidate {
  Variant variant;
  TraceSession tracing;
  float spread = 0; ///< Of the cone, for a variant with lod.
  Json setup;       ///< The figures of preparing it.
  std::vector<Hit> hits;
  Repeats cpuSeconds, seconds, deviceSeconds;
  double firstDispatchSeconds = 0;
  std::string order; ///< In which the rays were taken: given or binned.
  ErrorFigures error;
};

/// Opens the variant's device and makes its kernel. The volume must outlive the candidate.
/// Rays will be taken as `order` says, which is what --order may be.
Expected<std::unique_ptr<VariantCandidate>> prepare(const Variant &variant, const Volume &volume,
                                                    unsigned threads, const std::string &order = kAutoOrder);

/// Traces the rays once. The times are kept if they are `counted`; those of a first run are not. Errors: the
/// device's; `Interrupted` if it is told to stop meanwhile.
Expected<void> traceOnce(VariantCandidate &candidate, std::span<const Ray> rays, bool counted,
                         const Progress &progress = {});

/// Traces the rays by each in turn, `rounds` times over (A B C A B C ...), after a round that is not counted
/// and leaves the hits; earlier findings are replaced.
Expected<void> traceInTurn(std::span<const std::unique_ptr<VariantCandidate>> candidates,
                           std::span<const Ray> rays, unsigned rounds, const Progress &progress);

/// Compares each one's hits on `sample` rays, evenly spread over all, with the oracle's.
void check(std::span<const std::unique_ptr<VariantCandidate>> candidates, const Oracle &oracle,
           std::span<const Ray> rays, std::size_t sample);

/// Million rays a CPU second, by the median.
double mraysPerCpuSecond(const VariantCandidate &candidate);

/// Rays missed, ghost or wrong, per million checked.
double errorsPerMillion(const ErrorFigures &error);

} // namespace voxc::tool
