// Volumes: streams in memory or in a mapped file, and what is known of them.
#include "voxc/Volume/Volume.h"

#include "Frames.h"
#include "PagedFileWriter.h"
#include "StreamTable.h"
#include "VolumeFile.h"

#include "Support/Platform/File.h"
#include "Support/Platform/Path.h"
#include "voxc/Support/File.h"
#include "voxc/Support/ShellWord.h"

#include <algorithm>
#include <filesystem>

namespace voxc {

struct Volume::State {
  VolumeInfo info;
  std::vector<std::uint32_t> owned;
  std::shared_ptr<const void> owner;
  std::vector<Stream> streams; ///< Of `owned`, or of `owner`.
  std::span<const std::uint32_t> words;
  Layout layout;
  std::uint64_t mostCubes = kMostCubes;

  State(VolumeInfo given, std::vector<Stream> held, std::shared_ptr<const void> holder)
      : info(std::move(given)), owner(std::move(holder)), streams(std::move(held)),
        words(streams.front().as<std::uint32_t>()), layout(layoutOf(info.format)) {}
};

Volume::Volume(VolumeInfo info, std::vector<std::uint32_t> words) : Volume(std::move(info), words, nullptr) {
  state_->owned = std::move(words); // Its elements stay where they are.
}

Volume::Volume(VolumeInfo info, std::span<const std::uint32_t> words, std::shared_ptr<const void> owner)
    : Volume(std::move(info), std::vector{wordStream(words)}, std::move(owner)) {}

Volume::Volume(VolumeInfo info, std::vector<Stream> streams, std::shared_ptr<const void> owner)
    : state_(std::make_unique<State>(std::move(info), std::move(streams), std::move(owner))) {}

Volume::~Volume() = default;
Volume::Volume(Volume &&) noexcept = default;
Volume &Volume::operator=(Volume &&) noexcept = default;

const VolumeInfo &Volume::info() const { return state_->info; }
std::span<const std::uint32_t> Volume::words() const { return state_->words; }
const Layout &Volume::layout() const { return state_->layout; }
std::span<const Stream> Volume::streams() const { return state_->streams; }

const Stream *Volume::findStream(std::string_view name) const {
  const auto found = std::ranges::find(state_->streams, name, &Stream::name);
  return found == state_->streams.end() ? nullptr : &*found;
}

std::uint64_t Volume::bytes() const {
  std::uint64_t bytes = 0;
  for (const Stream &stream : streams())
    bytes += stream.bytes.size();
  return bytes;
}

std::uint64_t Volume::mostCubes() const { return state_->mostCubes; }
void Volume::allowCubes(std::uint64_t most) { state_->mostCubes = most; }

/// The words are those of all frames, of which this one is at the head, but for one that is empty. All other
/// streams are of the voxels of the first.
Expected<void> Volume::chooseFrame(int number) {
  const std::span<const Frame> frames = framesOf(*this);
  if (frames.empty() && number == 1)
    return {};
  VOXC_TRY(checkFrameNumber(number, frames.size()));
  const Frame frame = frames[static_cast<std::size_t>(number) - 1];
  const std::span<const std::uint32_t> root(&frame.root, 1);
  VOXC_TRY(writeOver(std::as_bytes(words().first(1)), std::as_bytes(root)));
  state_->info.voxels = frame.voxels;
  state_->info.wordCounts.reset();
  std::erase_if(state_->streams, [&](const Stream &stream) {
    return stream.name == kFrameStream || (number > 1 && stream.name != kWordStream);
  });
  if (frame.root == 0) {
    state_->words = state_->words.first(state_->layout.headWords());
    state_->streams.front().bytes = std::as_bytes(state_->words);
  }
  return {};
}

/// A volume that links lead to has the one journal of its own name.
std::string journalPathOf(const std::string &volumePath) {
  const auto end = platform::followLinks(volumePath);
  return (end ? end->path : volumePath) + ".journal";
}

Expected<void> checkNoJournal(const std::string &volumePath) {
  constexpr std::uintmax_t kHeadBytes = 32; // Of a journal that was begun, and has no edits.
  std::error_code failure;
  const std::uintmax_t bytes =
      std::filesystem::file_size(platform::pathFrom(journalPathOf(volumePath)), failure);
  if (!failure && bytes > kHeadBytes)
    return Error::input("edits of '" + volumePath + "' wait in '" + journalPathOf(volumePath) +
                        "'; `voxc edit " + shellWord(volumePath) + " --compact -o " + shellWord(volumePath) +
                        "` puts them into it");
  return {};
}

Expected<Volume> Volume::load(const std::string &path, const LoadOptions &options) {
  if (!options.withoutJournal)
    VOXC_TRY(checkNoJournal(path));
  auto opened = VOXC_TRY(MappedFile::open(path));
  const auto file = std::make_shared<const MappedFile>(std::move(opened));
  auto volume = VOXC_TRY(readVolumeFile(file->bytes(), file, path, options));
  volume.allowCubes(options.mostCubes);
  if (options.frame != 0)
    if (auto chosen = volume.chooseFrame(options.frame); !chosen)
      return Error{chosen.error().kind, "'" + path + "': " + chosen.error().message};
  return volume;
}

Expected<void> Volume::save(const std::string &path, const SaveOptions &options) const {
  VOXC_TRY(checkNoJournal(path)); // Its edits would be of no file.
  if (!options.compress)
    return saveMapped(path);
  auto writer = PagedFileWriter::create(path);
  return writer ? writer->finish(info(), streams(), options) : writer.error();
}

Expected<void> Volume::saveMapped(const std::string &path) const {
  auto file = VOXC_TRY(OutputFile::create(path));
  const std::string head = volumeFileHead(info(), streams());
  VOXC_TRY(file.write(head.data(), head.size()));
  std::uint64_t end = head.size();
  for (const Stream &stream : streams()) {
    const std::string padding(placeOf(stream.bytes.size(), end) - end, '\0');
    VOXC_TRY(file.write(padding.data(), padding.size()));
    VOXC_TRY(file.write(stream.bytes.data(), stream.bytes.size()));
    end += padding.size() + stream.bytes.size();
  }
  VOXC_TRY(checkNoJournal(path));
  return file.commit();
}

} // namespace voxc
