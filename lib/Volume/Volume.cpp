// Volumes: words in memory or in a mapped file, and what is known of them.
#include "voxc/Volume/Volume.h"

#include "VolumeFile.h"

#include "voxc/Support/File.h"

namespace voxc {

struct Volume::State {
  VolumeInfo info;
  std::vector<std::uint32_t> owned;
  std::shared_ptr<const void> owner;
  std::span<const std::uint32_t> words; ///< Of `owned`, or of `owner`.
  Layout layout;
};

Volume::Volume(VolumeInfo info, std::vector<std::uint32_t> words) : state_(std::make_unique<State>()) {
  state_->layout = layoutOf(info.format);
  state_->info = std::move(info);
  state_->owned = std::move(words);
  state_->words = state_->owned;
}

Volume::Volume(VolumeInfo info, std::span<const std::uint32_t> words, std::shared_ptr<const void> owner)
    : state_(std::make_unique<State>()) {
  state_->layout = layoutOf(info.format);
  state_->info = std::move(info);
  state_->owner = std::move(owner);
  state_->words = words;
}

Volume::~Volume() = default;
Volume::Volume(Volume &&) noexcept = default;
Volume &Volume::operator=(Volume &&) noexcept = default;

const VolumeInfo &Volume::info() const { return state_->info; }
std::span<const std::uint32_t> Volume::words() const { return state_->words; }
const Layout &Volume::layout() const { return state_->layout; }

Expected<Volume> Volume::load(const std::string &path, bool trusted) {
  auto file = MappedFile::open(path);
  if (!file)
    return file.error();
  auto contents = parseVolumeFile(file->bytes(), path);
  if (!contents)
    return contents.error();
  if (contents->words.empty())
    return Error::input("'" + path + "' has no words; even an empty volume has one");
  if (!trusted) {
    const auto voxels = checkStructure(contents->info.format, contents->words);
    if (!voxels)
      return Error::input("'" + path + "': " + voxels.error().message);
    if (*voxels != contents->info.voxels)
      return Error::input("'" + path + "' holds " + std::to_string(*voxels) +
                          " voxels, but its header says " + std::to_string(contents->info.voxels));
  }
  const auto words = contents->words;
  return Volume(std::move(contents->info), words, std::make_shared<const MappedFile>(std::move(*file)));
}

Expected<void> Volume::save(const std::string &path) const {
  auto file = OutputFile::create(path);
  if (!file)
    return file.error();
  const std::string header = volumeFileHeader(info(), words());
  if (auto written = file->write(header.data(), header.size()); !written)
    return written.error();
  if (auto written = file->write(words().data(), words().size_bytes()); !written)
    return written.error();
  return file->commit();
}

} // namespace voxc
