// Devices in C, and tracers by kernels that lie in files.
#include "C/Handles.h"
#include "voxc/Trace/CpuKernel.h"
#include "voxc/Trace/Face.h"

#include <cstdio>
#include <vector>

using namespace voxc;
using namespace voxc::c;

static_assert(sizeof(voxc_ray) == sizeof(Ray) && sizeof(voxc_hit) == sizeof(Hit));
static_assert(sizeof(voxc_bounded_ray) == sizeof(BoundedRay));

namespace {

template <std::size_t N> void copyText(char (&to)[N], const std::string &from) {
  std::snprintf(to, N, "%s", from.c_str());
}

Expected<void> traceAll(voxc_tracer &tracer, const RaySpan &rays, voxc_hit *hits) {
  VOXC_TRY(checkIdle(tracer));
  VOXC_TRY(tracer.tracer->trace(rays, std::span(reinterpret_cast<Hit *>(hits), rays.size())));
  return {};
}

/// A format as people write it, and by its digest, since passes do not show.
std::string shown(const Volume &volume) {
  char digest[24];
  std::snprintf(digest, sizeof digest, "0x%016llx", static_cast<unsigned long long>(volume.storageDigest()));
  return toString(volume.format()) + " (digest " + digest + ")";
}

/// Words that edits change, compared with themselves, would seem to be as they were: all are copied then.
Expected<UpdateReport> updateTo(const voxc_tracer &tracer, const Volume &after) {
  if (!tracer.follows)
    return tracer.tracer->update(*tracer.volume, after);
  const WordRange all{0, after.words().size()};
  return tracer.tracer->follow(after, {&all, 1});
}

voxc_device_info infoOf(const DeviceInfo &device) {
  voxc_device_info info{};
  copyText(info.name, device.name);
  copyText(info.kind, device.kind);
  copyText(info.uuid, device.uuid);
  info.memory_bytes = device.memoryBytes;
  info.usable = device.usable;
  return info;
}

} // namespace

Expected<void> voxc::c::checkIdle(const voxc_tracer &tracer) {
  return tracer.renders
             ? Error::usage("a picture of this tracer is being made, whose progress must not use the tracer")
             : Expected<void>();
}

Expected<void> voxc::c::checkTakes(const voxc_tracer &tracer, const Volume &volume) {
  const Volume &own = *tracer.volume;
  if (own.storageDigest() == volume.storageDigest())
    return {};
  return Error::usage("the volume is of another format, " + shown(volume) + ", than that of the tracer, " +
                      shown(own) + "; it takes a tracer of its own");
}

size_t voxc_devices(voxc_device_info *devices, size_t capacity) {
  std::size_t count = 0;
  voxc_error *const failure = guarded([&]() -> Expected<void> {
    std::vector<DeviceInfo> all = listDevices();
    all.push_back(cpuDeviceInfo());
    for (std::size_t i = 0; i < std::min(capacity, all.size()); ++i)
      devices[i] = infoOf(all[i]);
    count = all.size();
    return {};
  });
  voxc_error_free(failure);
  return count;
}

voxc_error *voxc_tracer_load(const voxc_volume *volume, const char *kernel_path,
                             const voxc_tracer_options *options, voxc_tracer **tracer) {
  return guarded([&]() -> Expected<void> {
    const auto given = VOXC_TRY(optionsOf(options));
    auto kernel = VOXC_TRY(Kernel::load(kernel_path));
    auto device = VOXC_TRY(Device::open(textOr(given.device, "")));
    auto made = std::make_unique<voxc_tracer>();
    made->volume = volume->volume;
    made->device = std::make_unique<Device>(std::move(device));
    made->deviceName = made->device->info().name;
    made->threads = given.threads;
    made->tracer = VOXC_TRY(createTracer(*made->device, kernel, *made->volume, given.threads));
    *tracer = made.release();
    return {};
  });
}

void voxc_tracer_free(voxc_tracer *tracer) {
  if (tracer)
    tracer->tracer.reset(); // Before its device.
  delete tracer;
}

const char *voxc_tracer_device(const voxc_tracer *tracer) { return tracer->deviceName.c_str(); }

voxc_error *voxc_tracer_trace(voxc_tracer *tracer, const voxc_ray *rays, uint64_t count, voxc_hit *hits) {
  return guarded([&] {
    return traceAll(*tracer, std::span(reinterpret_cast<const Ray *>(rays), std::size_t(count)), hits);
  });
}

voxc_error *voxc_tracer_trace_bounded(voxc_tracer *tracer, const voxc_bounded_ray *rays, uint64_t count,
                                      voxc_hit *hits) {
  return guarded([&] {
    return traceAll(*tracer, std::span(reinterpret_cast<const BoundedRay *>(rays), std::size_t(count)), hits);
  });
}

void voxc_face_normal(uint32_t face, float normal[3]) {
  const glm::vec3 vector = normalOf(face);
  for (int axis = 0; axis < 3; ++axis)
    normal[axis] = vector[axis];
}

voxc_error *voxc_tracer_update(voxc_tracer *tracer, const voxc_volume *volume, uint64_t *copied_bytes) {
  return guarded([&]() -> Expected<void> {
    VOXC_TRY(checkIdle(*tracer));
    VOXC_TRY(checkTakes(*tracer, *volume->volume));
    const auto updated = VOXC_TRY(updateTo(*tracer, *volume->volume));
    tracer->volume = volume->volume;
    tracer->follows = false;
    tracer->isOther = true;
    if (copied_bytes)
      *copied_bytes = updated.copiedBytes;
    return {};
  });
}
