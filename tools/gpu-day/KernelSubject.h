// A volume of a format and its kernels on a device.
#pragma once

#include "Subject.h"

#include "voxc/Trace/Kernel.h"
#include "voxc/Volume/Volume.h"

namespace voxc::gpu {

struct MeasureOptions {
  double seconds = 0.1;              ///< That each figure is measured for.
  std::vector<std::uint32_t> groups; ///< Workgroups of other sizes than the kernel's, measured too.
  bool atOnce = false;               ///< Trace in one dispatch, which resolves, too.
};

/// A volume on a device.
class KernelSubject {
public:
  /// Brings the words there. Error: `Environment`, as where they do not fit.
  static Expected<KernelSubject> make(const Gpu &gpu, const Volume &volume, const MeasureOptions &options);

  /// Traces all sets by a kernel of the volume, none of them empty; a row of JSON for each set and way of
  /// tracing. Errors: the kernel is none of the volume's (`Input`); those of the device.
  Expected<tool::Json> measure(const Kernel &kernel, std::span<const RaysThere> sets) const;

  /// A kernel that is ready, with workgroups of a size.
  struct Way {
    std::uint32_t group;
    Program defers, resolves;
    GpuBuffer list; ///< Of the rays that the first defers to the second.

    /// The dispatches over so many rays: one that resolves, or two.
    std::vector<GpuStep> stepsOf(std::uint64_t rays, std::uint32_t mostGroups, bool atOnce) const;
  };

  /// Makes a kernel ready for at most so many rays; `anywhere`: they may begin far away.
  Expected<Way> makeWay(const Kernel &kernel, std::uint32_t group, std::uint64_t mostRays,
                        bool anywhere) const;
  /// Binds it to rays and room for their hits.
  void bind(const Way &way, const GpuBuffer &rays, const GpuBuffer &hits) const;

private:
  KernelSubject(const Gpu &gpu, const Volume &volume, const MeasureOptions &options, GpuBuffer words)
      : gpu_(&gpu), volume_(&volume), options_(options), words_(std::move(words)) {}
  Expected<tool::Json> trace(const Way &way, const RaysThere &set, bool atOnce) const;
  Expected<void> keepRows(const Way &way, const RaysThere &set, tool::Json &rows) const;

  const Gpu *gpu_;
  const Volume *volume_;
  MeasureOptions options_;
  GpuBuffer words_;
  mutable std::vector<Hit> hits_;
};

} // namespace voxc::gpu
