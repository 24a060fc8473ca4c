// What the viewer shows, and what it does with what its threads bring.
#include "view/Viewer.h"

#include "common/PictureFile.h"
#include "view/Words.h"
#include "voxc/Render/View.h"

#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace voxc::view {
namespace {

/// Seconds that the first step of a picture shall take: with ending the step before it, copying and
/// presenting, an input is seen within a tenth of a second.
constexpr double kBudget = 0.03;

/// Samples of the finest picture, unless somebody says otherwise.
constexpr unsigned kFinest = 16;

/// Of the longest axis, that one moves in a second.
constexpr double kStride = 0.3;

/// What does not come from a key in time is not caught up with.
constexpr double kLongestStep = 0.1;

/// Traces by a scene that no other thread has.
Expected<tool::PlacedCamera> placeIn(const Scene &scene, const tool::PictureOptions &options,
                                     const Clip &clip) {
  const auto trace = [&](std::span<const Ray> rays, std::span<Hit> hits,
                         const TraceOptions &traceOptions) -> Expected<void> {
    const Expected<TraceReport> report = traceClipped(scene, clip, rays, hits, traceOptions);
    return report ? Expected<void>() : report.error();
  };
  return tool::placeCamera(options, *scene.model.volume, trace);
}

/// What is to be seen of a scene. Precondition: the options are right, whatever the volume.
Clip clipIn(const Scene &scene, const tool::ClipOptions &options) {
  const Expected<Clip> clip = tool::clipOf(options, scene.model.volume->info().voxelToModel);
  return clip ? *clip : Clip();
}

} // namespace

Viewer::Viewer(ViewerOptions options, SceneMaker maker, EventLog &log, std::function<void()> wake)
    : options_(std::move(options)), maker_(std::move(maker)), log_(log), wake_(std::move(wake)),
      screenshots_(options_.screenshots, ".png", wake_), volumes_(options_.screenshots, ".hvx", wake_),
      oracleCheck_(wake_),
      painter_({kBudget, options_.picture.samples > 0 ? options_.picture.samples : kFinest}, wake_) {
  state_.style = tool::styleOf(options_.picture);
  request(options_.wish);
}

void Viewer::request(const SceneWish &wish) {
  wish_ = wish;
  state_.error.clear();
  log_.note("load " + (wish.format.empty() ? "the first format" : wish.format) + " on " +
            (wish.device.empty() ? "the best device" : wish.device));
  loader_.post([this, wish, old = scene_](const std::atomic<bool> &stop) {
    const Progress progress{[this](std::string_view stage, double fraction, std::uint64_t) {
                              work_.put(std::string(stage) + " " + std::to_string(int(100 * fraction)) +
                                        " %");
                              wake_();
                            },
                            &stop};
    Loaded loaded{makeScene(maker_, wish, old.get(), progress), std::nullopt};
    if (stop)
      return;
    if (loaded.scene && !old) {
      const Expected<tool::PlacedCamera> camera =
          placeIn(**loaded.scene, options_.picture, clipIn(**loaded.scene, options_.clip));
      if (camera)
        loaded.placed = *camera;
      else
        loaded.scene = camera.error();
    }
    loaded_.put(std::move(loaded));
    wake_();
  });
  state_.work = "begin";
  isLoading_ = true;
  editsAtLoad_ = edits_;
}

/// What has been asked for last does not come any more. Precondition: there is a scene.
void Viewer::stopLoading() {
  loader_.post([](const std::atomic<bool> &) {});
  log_.tell("stopped loading " + (wish_.format.empty() ? "the first format" : wish_.format));
  wish_ = {scene_->model.text, scene_->device};
  state_.work.clear();
  isLoading_ = false;
}

void Viewer::load(const std::string &format) { request({format, scene_ ? scene_->device : wish_.device}); }

void Viewer::useDevice(const std::string &device) {
  request({scene_ ? scene_->model.text : wish_.format, device});
}

void Viewer::fail(const Error &error) {
  state_.error = error.message;
  if (!failure_)
    log_.tell("error " + error.message);
}

void Viewer::takeLoaded(Loaded loaded) {
  if (!isLoading_) // It came as it was stopped.
    return;
  if (edits_ != editsAtLoad_) // What came has not all strokes.
    return request(wish_);
  state_.work.clear();
  isLoading_ = false;
  if (!loaded.scene) {
    if (!scene_)
      failure_ = loaded.scene.error();
    return fail(loaded.scene.error());
  }
  scene_ = std::move(*loaded.scene);
  if (loaded.placed) {
    setFlying(isInside(loaded.placed->camera));
    setCamera(*(home_ = ViewCamera(loaded.placed->camera)));
  }
  state_.format = scene_->model.text;
  state_.device = scene_->device;
  state_.size = sizeText(scene_->model);
  const std::size_t frame = std::exchange(state_.frame, 0);
  state_.frames = scene_->sculpture ? scene_->sculpture->frames() : 1;
  isPlaying_ = isPlaying_ && state_.frames > 1;
  log_.tell("scene " + state_.format + " on " + state_.device + ": " + state_.size);
  if (!loaded.placed) {
    show();
    chooseFrame(frame); // If it has that one, too.
  } else if (loaded.placed->isAuto) {
    log_.tell("view " + loaded.placed->view +
              (loaded.placed->view == "inside" ? "; V looks from outside" : ""));
  }
}

/// What is to be seen now.
Shot Viewer::shot() const {
  const RenderOptions options = tool::renderOptions(options_.picture, *scene_->model.volume);
  const bool isSmooth = options.isSmooth && kindOf(state_.style).needsNormals;
  return {scene_, camera_->camera(options_.width, options_.height),
          Look{state_.style, isSmooth, options.sun, options.coarse, clipIn(*scene_, options_.clip)}};
}

void Viewer::show() {
  if (!isPlaced())
    return;
  const std::uint64_t number = painter_.show(shot());
  if (!waiting_)
    waiting_ = Waiting{number, acted_.value_or(Stopwatch())};
  acted_.reset();
}

void Viewer::takePainting(Painting painting) {
  if (!painting.picture)
    return fail(painting.picture.error());
  state_.picture = stepText(painting);
  fineness_ = state_.picture + (painting.isLast ? ", the finest" : "");
  log_.note("painted " + fineness_ + pagesText(painting));
  picture_ = std::move(*painting.picture);
  pictureNumber_ = painting.number;
  isPictureNew_ = true;
}

const Picture *Viewer::takePicture() {
  takenNumber_ = pictureNumber_;
  return std::exchange(isPictureNew_, false) ? &picture_ : nullptr;
}

void Viewer::presented() {
  log_.note("shown " + fineness_);
  if (!waiting_ || takenNumber_ < waiting_->number)
    return;
  char text[64];
  std::snprintf(text, sizeof text, "reacted after %.1f ms", 1e3 * waiting_->watch.seconds());
  log_.note(text);
  waiting_.reset();
}

bool Viewer::advance(double seconds) {
  if (isPlaced()) {
    const Int3 extent = scene_->model.volume->info().extent;
    const glm::dvec3 sides =
        glm::dvec3(extent.x, extent.y, extent.z) *
        tool::spacingOf(options_.picture.camera, scene_->model.volume->info().voxelToModel);
    const double stride = kStride * std::max({sides.x, sides.y, sides.z});
    if (motion_.advance(*camera_, std::min(seconds, kLongestStep), stride))
      show();
    playOn(seconds);
    prefetch_.follow(shot(), *camera_, seconds);
  }
  bool hasChanged = false;
  const auto take = [&hasChanged](auto &from, const auto &use) {
    if (auto thing = from.take()) {
      use(std::move(*thing));
      hasChanged = true;
    }
  };
  take(work_, [this](std::string work) {
    if (isLoading_)
      state_.work = std::move(work);
  });
  take(loaded_, [this](Loaded loaded) { takeLoaded(std::move(loaded)); });
  take(painter_, [this](Painting painting) { takePainting(std::move(painting)); });
  take(pick_, [this](const Expected<Pick> &pick) { takePick(pick); });
  take(screenshots_, [this](const Expected<std::string> &path) { takeScreenshot(path); });
  take(volumes_, [this](const Expected<std::string> &path) { takeSaved(path); });
  take(carving_, [this](const Expected<Carving> &carving) { takeCarving(carving); });
  take(cut_, [this](const auto &cut) { takeCut(cut); });
  take(placed_, [this](const Expected<Camera> &camera) { takeCamera(camera); });
  take(oracleCheck_, [this](const Expected<CheckedHit> &checked) {
    if (!checked)
      return fail(checked.error());
    state_.picked = describe(*checked);
    log_.tell("picked " + state_.picked);
  });
  return hasChanged;
}

void Viewer::takePick(const Expected<Pick> &pick) {
  if (!pick)
    return fail(pick.error());
  touched_ = pick->hit;
  state_.picked = describe(pick->hit) + "; asking the oracle";
  oracleCheck_.ask(*pick);
}

void Viewer::setCamera(const ViewCamera &camera) {
  camera_ = camera;
  setFlying(state_.isFlying);
  show();
}

void Viewer::setFlying(bool isFlying) {
  if (isFlying != state_.isFlying)
    log_.tell(isFlying ? "mode fly" : "mode orbit");
  state_.isFlying = isFlying;
  if (camera_)
    camera_->setTurning(isFlying ? Turning::Fly : Turning::Orbit);
}

void Viewer::orbitTouched() {
  if (!camera_ || !touched_ || !touched_->isHit())
    return;
  camera_->lookAt({touched_->voxel[0] + 0.5, touched_->voxel[1] + 0.5, touched_->voxel[2] + 0.5});
  setFlying(false);
  show();
}

void Viewer::nextView() {
  constexpr voxc::View kViews[] = {voxc::View::Iso, voxc::View::Front, voxc::View::Top, voxc::View::Inside};
  if (!isPlaced())
    return;
  const voxc::View view = kViews[view_++ % std::size(kViews)];
  log_.tell("view " + std::string(toString(view)));
  tool::PictureOptions options = options_.picture;
  options.view = toString(view);
  options.camera.camera.clear();
  // From inside, parallel rays see nothing.
  options.camera.orthographic = camera_->isOrthographic() && view != voxc::View::Inside;
  options.camera.viewHeight = 0;
  options.camera.size = std::to_string(options_.width) + "x" + std::to_string(options_.height);
  painter_.ask([this, options](const Shot &shot) {
    const Expected<tool::PlacedCamera> placed = placeIn(*shot.scene, options, shot.look.clip);
    placed_.put(placed ? Expected<Camera>(placed->camera) : placed.error());
  });
}

void Viewer::toggleOrthographic() {
  if (!camera_)
    return;
  camera_->setOrthographic(!camera_->isOrthographic());
  log_.tell(camera_->isOrthographic() ? "rays parallel" : "rays from the eye");
  show();
}

void Viewer::takeCamera(const Expected<Camera> &camera) {
  if (!camera)
    return fail(camera.error());
  setFlying(isInside(*camera));
  setCamera(ViewCamera(*camera));
}

/// Whether an eye stands within the box of the volume: going around a point would lead through its walls.
bool Viewer::isInside(const Camera &camera) const {
  const Int3 extent = scene_->model.volume->info().extent;
  return glm::all(glm::greaterThan(camera.eye, glm::dvec3(0))) &&
         glm::all(glm::lessThan(camera.eye, glm::dvec3(extent.x, extent.y, extent.z)));
}

void Viewer::nextDevice() {
  const std::vector<std::string> &devices = options_.devices;
  if (devices.empty())
    return;
  const auto now = std::ranges::find(devices, wish_.device.empty() ? state_.device : wish_.device);
  useDevice(now == devices.end() || now + 1 == devices.end() ? devices.front() : *(now + 1));
}

void Viewer::nextPoint(int step) {
  // A wish that is no point, as the first one or one that failed, leaves the scene where it is.
  const auto wished = options_.search.find(wish_.format);
  const auto from = wished ? wished : options_.search.find(state_.format);
  const auto next = options_.search.nextLeading(from, step);
  if (next)
    load(options_.search.points[*next].text);
}

void Viewer::copyCamera() {
  if (!isPlaced())
    return;
  const Camera camera = camera_->camera(options_.width, options_.height);
  copied_ = tool::cameraText(options_.picture, camera, *scene_->model.volume);
  log_.tell("camera " + *copied_);
}

void Viewer::writeScreenshot() {
  if (picture_.pixels.empty())
    return;
  if (const auto before = screenshots_.write(
          [picture = picture_](const std::string &path) { return tool::writePicture(path, picture); }))
    takeScreenshot(*before);
  shot_ = state_.picture;
}

void Viewer::takeScreenshot(const Expected<std::string> &path) {
  if (!path)
    return fail(path.error());
  log_.tell("screenshot " + *path + ": " + shot_);
}

} // namespace voxc::view
