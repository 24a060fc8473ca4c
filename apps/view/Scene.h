// What the viewer shows: a volume in a format, and a tracer for it on a device.
#pragma once

#include "view/Sculpture.h"

#include "voxc/IR/Format.h"
#include "voxc/Render/SurfaceNormals.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Trace/PagedTracer.h"
#include "voxc/Trace/Tracer.h"
#include "voxc/Volume/Volume.h"

#include <functional>
#include <memory>
#include <string>

namespace voxc::view {

/// A volume, with the way that its kernel shall traverse it.
struct Model {
  std::shared_ptr<const Volume> volume;
  Format format;    ///< With traversal attributes.
  std::string text; ///< The format and its passes, as `FormatText` reads them.
  /// Of its words, if only pages of them are in memory, which the tracer alone has: the volume is an outline.
  std::uint64_t pagedBytes = 0;
  bool isEdited = false; ///< It is not what its input holds any more.
};

/// What traces a model.
struct Tracers {
  std::unique_ptr<Tracer> tracer;
  /// Of a model in pages: another one, on this processor alone and on one thread, that is used by a thread of
  /// its own. What it reads the first finds at hand. Null: there is none.
  std::unique_ptr<Tracer> prefetch = {};
  std::function<PagingReport()> paging = {}; ///< What the first has done; empty: it has no pages.
  /// Of a model in pages: finds its normals on so many threads, and may be asked by two.
  std::function<std::unique_ptr<SurfaceNormals>(unsigned threads)> makeNormals = {};
};

struct Scene {
  Model model;
  std::string device; ///< Its name.
  std::unique_ptr<Tracer> tracer;
  std::function<PagingReport()> paging;    ///< As in `Tracers`; asked by the thread that traces.
  std::shared_ptr<const Scene> prefetch;   ///< The same model, traced by the prefetch; or null.
  std::unique_ptr<SurfaceNormals> normals; ///< That its pictures have found.
  std::unique_ptr<Sculpture> sculpture;    ///< Its volume while it is edited; null of a model in pages.
  unsigned threads = 0;                    ///< That shade; 0: all of the machine.

  /// The volume as it is to be seen now, for the thread that paints.
  std::shared_ptr<const Volume> volume() const { return sculpture ? sculpture->volume() : model.volume; }
  /// The same for any other, which stays as it is.
  std::shared_ptr<const Volume> frozen() const {
    auto edited = sculpture ? sculpture->frozen() : nullptr;
    return edited ? edited : model.volume;
  }
  /// The model with all that was done to it, and all its frames. Of any thread. Error: no addresses.
  Expected<Model> now() const;
};

/// Makes what scenes are made of. The functions are called on a thread of the viewer, one call at a time.
struct SceneMaker {
  /// The model in a format ("" for the one of the beginning). Errors: the text is no format, the input does
  /// not fit, all those of building.
  std::function<Expected<Model>(const std::string &text, const Progress &progress)> makeModel;
  /// Tracers on the device that `name` names ("" for the best one), which keep the volume alive; `name`
  /// becomes the device's own. Errors: those of devices and kernels.
  std::function<Expected<Tracers>(const Model &model, std::string &name)> makeTracers;
  unsigned threads = 0; ///< Of scenes.
};

/// What to show next; both as `SceneMaker` takes them.
struct SceneWish {
  std::string format, device;
};

/// Makes a scene. What `old` has already is taken from there; it may be null. Errors: those of `maker`.
Expected<std::shared_ptr<Scene>> makeScene(const SceneMaker &maker, const SceneWish &wish, const Scene *old,
                                           const Progress &progress);

} // namespace voxc::view
