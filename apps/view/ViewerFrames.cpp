// What the viewer does with the frames of an animation, and saving what is to be seen.
#include "view/Viewer.h"

#include "voxc/Construct/Constructor.h"
#include "voxc/Source/Sources.h"
#include "voxc/Support/UserCache.h"

namespace voxc::view {
namespace {

/// The file that a build of the voxels makes.
Expected<void> buildFile(const std::shared_ptr<const Volume> &volume, const std::string &path) {
  const auto constructor = VOXC_TRY(Constructor::compile(volume->format(), compileCache()));
  BuildOptions options;
  options.provenance = volume->info().provenance;
  options.path = path;
  const auto source = makeVolumeSource(volume);
  const auto built = constructor.build(*source, options);
  return built ? Expected<void>() : built.error();
}

} // namespace

/// Has the thread that paints show it.
void Viewer::chooseFrame(std::size_t index) {
  if (index == state_.frame || index >= state_.frames)
    return;
  state_.frame = index;
  playedSeconds_ = 0;
  log_.note("frame " + std::to_string(index + 1) + " of " + std::to_string(state_.frames));
  act(ShowFrame{index});
}

void Viewer::showFrame(std::size_t index) {
  setPlaying(false);
  chooseFrame(index);
}

void Viewer::stepFrame(int by) {
  const auto frames = static_cast<std::ptrdiff_t>(state_.frames);
  showFrame(std::size_t((std::ptrdiff_t(state_.frame) + by + frames) % frames));
}

void Viewer::setPlaying(bool isPlaying) {
  isPlaying = isPlaying && state_.frames > 1;
  if (isPlaying != isPlaying_)
    log_.tell(isPlaying ? "playing" : "stopped playing");
  isPlaying_ = isPlaying;
  playedSeconds_ = 0;
}

/// The frame that it is time for, once the one before has been seen: a slow device leaves frames out.
void Viewer::playOn(double seconds) {
  if (!isPlaying_)
    return;
  playedSeconds_ += seconds;
  const auto steps = static_cast<std::size_t>(playedSeconds_ * options_.framesPerSecond);
  if (steps > 0 && !acted_ && !waiting_)
    chooseFrame((state_.frame + steps) % state_.frames);
}

void Viewer::saveVolume() {
  if (!isPlaced())
    return;
  if (!scene_->sculpture)
    return fail(Error::usage("a volume in pages is saved as it is; copy its file"));
  const auto frames = scene_->sculpture->frozenFrames();
  if (!frames)
    return fail(frames.error());
  const auto write = [frames = *frames, volume = scene_->frozen()](const std::string &path) {
    return frames ? frames->save(path) : buildFile(volume, path);
  };
  if (const auto before = volumes_.write(write))
    takeSaved(*before);
}

void Viewer::takeSaved(const Expected<std::string> &path) {
  if (!path)
    return fail(path.error());
  log_.tell("saved " + *path);
}

} // namespace voxc::view
