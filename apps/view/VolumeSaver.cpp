// Writing volumes.
#include "view/VolumeSaver.h"

#include "view/NumberedFile.h"

#include "common/UserCache.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Source/Sources.h"

namespace voxc::view {
namespace {

Expected<void> build(const std::shared_ptr<const Volume> &volume, const std::string &path) {
  const auto constructor = Constructor::compile(volume->format(), tool::compileCache());
  if (!constructor)
    return constructor.error();
  BuildOptions options;
  options.provenance = volume->info().provenance;
  options.path = path;
  const auto source = makeVolumeSource(volume);
  const auto built = constructor->build(*source, options);
  return built ? Expected<void>() : built.error();
}

} // namespace

std::optional<Expected<std::string>> VolumeSaver::write(SavedVolume saved) {
  if (writer_.joinable())
    writer_.join();
  auto before = take();
  const std::string path = nextNumberedPath(folder_, ".hvx", number_);
  writer_ = std::jthread([this, path, saved = std::move(saved)] {
    const Expected<void> written = saved.frames ? saved.frames->save(path) : build(saved.volume, path);
    written_.put(written ? Expected<std::string>(path) : written.error());
    wake_();
  });
  return before;
}

} // namespace voxc::view
