// Tracing what is measured.
#include "voxc/Measure/Subject.h"

#include <utility>

namespace voxc::measure {

Expected<Device *> Devices::open(const std::string &name) {
  if (name == cpuDeviceInfo().name)
    return nullptr;
  const auto known = devices_.find(name);
  if (known != devices_.end())
    return known->second.get();
  Expected<Device> opened = Device::open(name);
  if (!opened && name.empty())
    return nullptr;
  if (!opened)
    return Error{opened.error().kind, opened.error().message + "; and cpu, this processor"};
  return devices_.emplace(name, std::make_unique<Device>(std::move(*opened))).first->second.get();
}

TracerChoice Subject::tracerChoice(bool countsWords) const {
  return {.openDevice = choice_.device,
          .threads = choice_.threads,
          .format = format_,
          .countWords = countsWords,
          .start = CpuStart::Whole};
}

Expected<Subject> Subject::open(const Volume &volume, const Format &format, const SubjectChoice &choice) {
  Subject subject(volume, format, choice);
  subject.opened_ = VOXC_TRY(openTracerOn(volume, subject.tracerChoice(false)));
  return subject;
}

DeviceInfo Subject::deviceInfo() const { return choice_.device ? choice_.device->info() : cpuDeviceInfo(); }

Expected<void> Subject::trace(std::span<const Ray> rays, Times *times, const Progress &progress) {
  hits_.resize(rays.size());
  const auto traced = VOXC_TRY(opened_.tracer->trace(
      rays, hits_, {.spread = choice_.spread, .order = choice_.order, .progress = progress.silent()}));
  if (!times) {
    firstDispatchSeconds_ = traced.firstDispatch;
    return {};
  }
  const TraceTime &time = traced.repeats.front();
  times->cpuSeconds.push_back(time.cpu);
  times->seconds.push_back(time.wall);
  if (time.device > 0)
    times->deviceSeconds.push_back(time.device);
  times->isBinned = traced.binned;
  return {};
}

Expected<double> Subject::stepsPerRay(std::span<const Ray> rays) {
  std::vector<Hit> hits(rays.size());
  const auto traced = opened_.tracer->trace(
      rays, hits, {.countSteps = true, .spread = choice_.spread, .order = choice_.order});
  return traced ? Expected<double>(meanSteps(hits)) : traced.error();
}

Expected<double> Subject::wordsPerRay(std::span<const Ray> rays) {
  std::vector<Hit> hits(rays.size());
  OpenedTracer<Tracer> counting;
  if (!choice_.device)
    counting = VOXC_TRY(openTracerOn(*volume_, tracerChoice(true)));
  Tracer &tracer = choice_.device ? *opened_.tracer : *counting.tracer;
  const auto traced =
      tracer.trace(rays, hits, {.countWords = true, .spread = choice_.spread, .order = choice_.order});
  return traced ? Expected<double>(meanSteps(hits)) : traced.error();
}

double meanSteps(std::span<const Hit> hits) {
  double steps = 0;
  for (const Hit &hit : hits)
    steps += hit.steps;
  return hits.empty() ? 0 : steps / static_cast<double>(hits.size());
}

} // namespace voxc::measure
