// Making scenes.
#include "view/Scene.h"

namespace voxc::view {

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
  scene->tracer = std::move(*tracer);
  scene->normals = std::make_unique<SurfaceNormals>(*scene->model.volume, maker.threads);
  scene->threads = maker.threads;
  return scene;
}

} // namespace voxc::view
