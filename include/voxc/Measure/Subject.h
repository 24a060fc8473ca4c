// What is measured: a volume that a kernel traces on a device, again and again.
#pragma once

#include "voxc/Kernel/OpenTracer.h"
#include "voxc/Measure/Repeats.h"
#include "voxc/Support/Progress.h"
#include "voxc/Trace/RayOrder.h"

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc::measure {

/// Devices by what they are asked for as, each opened once.
class Devices {
public:
  /// As `TracerChoice::device`; null is this processor. It stays as long as this object. Error:
  /// `Environment`.
  Expected<Device *> open(const std::string &name);

private:
  std::map<std::string, std::unique_ptr<Device>> devices_;
};

/// How rays are traced, beside the volume and its kernel.
struct SubjectChoice {
  Device *device = nullptr; ///< Which must outlive the subject; null: this processor.
  unsigned threads = 0;     ///< Of this processor; 0: all.
  RayOrder order = RayOrder::Auto;
  float spread = 0; ///< As `TraceOptions::spread`.
};

/// Times of the same rays, once for each round.
struct Times {
  Repeats cpuSeconds;    ///< Of the process.
  Repeats seconds;       ///< Of the wall.
  Repeats deviceSeconds; ///< By the device's own clock; empty where it has none.
  bool isBinned = false; ///< Rays were taken bin by bin, in the last round.
};

class Subject {
public:
  /// Compiles a kernel of `format`, which has the storage of `volume`, and makes a tracer with it. The volume
  /// must outlive the subject. Errors: as `openTracer`.
  static Expected<Subject> open(const Volume &volume, const Format &format, const SubjectChoice &choice);

  /// Traces the rays once and adds the times; null: a first time, which does not count. Errors: the device's;
  /// `Interrupted`.
  Expected<void> trace(std::span<const Ray> rays, Times *times, const Progress &progress = {});
  /// The hits of the last trace.
  std::span<const Hit> hits() const { return hits_; }

  /// Look-ups, and words read, that a ray takes on average; 0 of no rays. Words are counted by a kernel of
  /// their own on this processor. Errors: as `trace` and `open`.
  Expected<double> stepsPerRay(std::span<const Ray> rays);
  Expected<double> wordsPerRay(std::span<const Ray> rays);

  /// What it took to make the tracer; its `tracer` is the subject's.
  const OpenedTracer<Tracer> &opened() const { return opened_; }
  /// Wall seconds of the first dispatch, which may compile.
  double firstDispatchSeconds() const { return firstDispatchSeconds_; }
  DeviceInfo deviceInfo() const;

private:
  Subject(const Volume &volume, const Format &format, const SubjectChoice &choice)
      : volume_(&volume), format_(format), choice_(choice) {}
  TracerChoice tracerChoice(bool countsWords) const;

  const Volume *volume_;
  Format format_;
  SubjectChoice choice_;
  OpenedTracer<Tracer> opened_;
  std::vector<Hit> hits_;
  double firstDispatchSeconds_ = 0;
};

/// The mean of the hits' steps; 0 of no hits.
double meanSteps(std::span<const Hit> hits);

} // namespace voxc::measure
