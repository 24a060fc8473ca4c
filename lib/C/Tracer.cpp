// Tracers in C whose kernels are compiled, and pictures.
#include "C/FormatHandle.h"
#include "voxc/IR/Query.h"
#include "voxc/Kernel/OpenTracer.h"
#include "voxc/Render/View.h"

using namespace voxc;
using namespace voxc::c;

namespace {

/// Sets what is stored of a hit to the names in a list.
Expected<void> setOutputs(Format &format, std::string_view list) {
  std::vector<std::string> names = namesIn(list);
  for (const AttributeKind *kind :
       {&kVoxelAttribute, &kTAttribute, &kFaceAttribute, &kColourAttribute, &kIndexAttribute})
    format.setAttribute(*kind, std::erase(names, std::string(kind->name)) > 0 ? "yes" : "no");
  if (!names.empty())
    return Error::usage("'" + names.front() + "' is no output; those are voxel, t, face, colour and index");
  return {};
}

/// Error: a pass changes what a volume stores.
Expected<void> checkTraversal(const std::vector<std::string> &names) {
  for (const std::string &name : names) {
    const Pass *const pass = findPass(name);
    if (pass && pass->effect != AttributeEffect::Traversal)
      return Error::usage("pass '" + name +
                          "' changes what a volume stores; build the volume with it instead");
  }
  return {};
}

/// What a kernel shall do, as a format.
Expected<Format> kernelFormat(const Volume &volume, const voxc_tracer_options &options) {
  Format format = volume.format();
  const struct {
    const AttributeKind &kind;
    const char *value;
  } choices[] = {{kQueryAttribute, options.query}, {kPrecisionAttribute, options.precision}};
  for (const auto &[kind, value] : choices) {
    if (!value)
      continue;
    if (std::ranges::find(kind.values, std::string_view(value)) == kind.values.end())
      return Error::usage(std::string(kind.name) + " cannot be '" + value + "'");
    format.setAttribute(kind, value);
  }
  if (options.outputs && format.attributes.get(kQueryAttribute) != Query::Closest)
    return Error::usage("outputs are of the query closest; another one leaves no choice");
  if (options.outputs)
    VOXC_TRY(setOutputs(format, options.outputs));
  if (options.bounds)
    askForBounds(format);
  if (const std::string_view problem = problemOfQuestion(format); !problem.empty())
    return Error::usage("the format " + std::string(problem));
  const std::vector<std::string> passes = namesIn(textOr(options.passes, ""));
  VOXC_TRY(checkTraversal(passes));
  VOXC_TRY(runPasses(format, passes));
  return format;
}

} // namespace

voxc_error *voxc_tracer_create(const voxc_volume *volume, const voxc_tracer_options *options,
                               voxc_tracer **tracer) {
  return guarded([&]() -> Expected<void> {
    const auto given = VOXC_TRY(optionsOf(options));
    const DeviceInfo processor = cpuDeviceInfo();
    auto made = std::make_unique<voxc_tracer>();
    made->volume = volume->volume;
    made->threads = given.threads;
    made->format = VOXC_TRY(kernelFormat(*volume->volume, given));
    made->device = VOXC_TRY(openDevice(given, processor.name));
    made->deviceName = made->device ? made->device->info().name : processor.name;
    auto opened = VOXC_TRY(openTracerOn(
        *made->volume, {.openDevice = made->device.get(), .threads = made->threads, .format = made->format}));
    made->tracer = std::move(opened.tracer);
    *tracer = made.release();
    return {};
  });
}
