// Making scenes.
#include "view/Scene.h"

#include "view/SlicedTracer.h"
#include "voxc/Trace/CpuKernel.h"

namespace voxc::view {
namespace {

/// Seconds for which a device may go on when a picture is no longer wanted.
constexpr double kSlice = 0.01;

std::unique_ptr<SurfaceNormals> normalsOf(const Model &model, const Tracers &tracers, unsigned threads) {
  return tracers.makeNormals ? tracers.makeNormals(threads)
                             : std::make_unique<SurfaceNormals>(*model.volume, threads);
}

/// What a prefetch paints is seen by nobody; it takes one thread, and what shades it is its own.
std::shared_ptr<const Scene> prefetchScene(const Model &model, Tracers &tracers) {
  if (!tracers.prefetch)
    return nullptr;
  auto scene = std::make_shared<Scene>();
  scene->model = model;
  scene->tracer = std::move(tracers.prefetch);
  scene->normals = normalsOf(model, tracers, 1);
  scene->threads = 1;
  return scene;
}

} // namespace

Expected<Model> Scene::now() const {
  Model model = this->model;
  if (!sculpture)
    return model;
  model.isEdited = model.isEdited || sculpture->isEdited();
  const auto frames = VOXC_TRY(sculpture->frozenFrames());
  model.volume = frames ? frames : frozen();
  return model;
}

Expected<std::shared_ptr<Scene>> makeScene(const SceneMaker &maker, const SceneWish &wish, const Scene *old,
                                           const Progress &progress) {
  auto scene = std::make_shared<Scene>();
  if (old && wish.format == old->model.text) {
    scene->model = VOXC_TRY(old->now());
  } else if (old && old->model.isEdited) {
    return Error::usage("the volume was edited before it went to this device; write it (F2), and open that "
                        "file to see it in another format");
  } else if (old && old->sculpture && old->sculpture->isEdited()) {
    return Error::usage(
        "the volume was edited in the format that is shown; undo all strokes (Z) to load another");
  } else {
    scene->model = VOXC_TRY(maker.makeModel(wish.format, progress));
  }
  VOXC_TRY(progress.check());
  progress.at("compile the kernel", 0);
  scene->device = wish.device;
  auto tracers = VOXC_TRY(maker.makeTracers(scene->model, scene->device));
  // This processor ends by itself as soon as it is told to.
  const bool endsLate = scene->device != cpuDeviceInfo().name;
  scene->tracer = endsLate ? inSlices(std::move(tracers.tracer), kSlice) : std::move(tracers.tracer);
  scene->paging = std::move(tracers.paging);
  scene->prefetch = prefetchScene(scene->model, tracers);
  if (scene->model.pagedBytes == 0)
    scene->sculpture = std::make_unique<Sculpture>(scene->model.volume);
  scene->normals = normalsOf(scene->model, tracers, maker.threads);
  scene->threads = maker.threads;
  return scene;
}

} // namespace voxc::view
