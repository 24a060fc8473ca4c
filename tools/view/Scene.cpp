// Making scenes.
#include "view/Scene.h"

#include "view/SlicedTracer.h"
#include "voxc/Trace/CpuKernel.h"

namespace voxc::view {
namespace {

/// Seconds for which a device may go on when a picture is no longer wanted.
constexpr double kSlice = 0.01;

} // namespace

Expected<std::shared_ptr<Scene>> makeScene(const SceneMaker &maker, const SceneWish &wish, const Scene *old,
                                           const Progress &progress) {
  auto scene = std::make_shared<Scene>();
  if (old && wish.format == old->model.text) {
    scene->model = old->model;
  } else {
    Expected<Model> model = maker.makeModel(wish.format, progress);
    if (!model)
      return model.error();
    scene->model = std::move(*model);
  }
  if (progress.stopped())
    return Error::interrupted();
  progress.at("compile the kernel", 0);
  scene->device = wish.device;
  auto tracer = maker.makeTracer(scene->model, scene->device);
  if (!tracer)
    return tracer.error();
  // This processor ends by itself as soon as it is told to.
  const bool endsLate = scene->device != cpuDeviceInfo().name;
  scene->tracer = endsLate ? inSlices(std::move(*tracer), kSlice) : std::move(*tracer);
  scene->normals = std::make_unique<SurfaceNormals>(*scene->model.volume, maker.threads);
  scene->threads = maker.threads;
  return scene;
}

} // namespace voxc::view
