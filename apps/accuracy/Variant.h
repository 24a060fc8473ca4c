// Variants: one kernel on one device each, whose speeds and errors are compared on the same rays.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Measure/Subject.h"
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
  measure::Subject subject;
  measure::Times times;
  ErrorFigures error;
};

/// Makes the variant's kernel. Volume and devices must outlive the candidate. `spread` is that of the cone,
/// for a variant with lod.
Expected<std::unique_ptr<VariantCandidate>> prepare(const Variant &variant, const Volume &volume,
                                                    measure::Devices &devices, unsigned threads,
                                                    float spread = 0);

/// Traces the rays by each in turn, `rounds` times over (A B C A B C ...), after a round that is not counted;
/// earlier findings are replaced. Errors: a device's; `Interrupted`.
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
