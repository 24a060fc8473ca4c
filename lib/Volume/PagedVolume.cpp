// Compressed files: their heads checked at once, their pages when they are decoded.
#include "voxc/Volume/PagedVolume.h"

#include "Frames.h"
#include "PageCodec.h"
#include "PageTable.h"
#include "VolumeHead.h"

#include "voxc/Support/File.h"
#include "voxc/Volume/Volume.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace voxc {

struct PagedVolume::State {
  std::string name;
  std::span<const std::byte> file;
  std::shared_ptr<const void> owner;
  VolumeInfo info;
  std::uint64_t headChecksum = 0;
  std::uint64_t headBytes = 0;
  std::vector<PagedStream> streams;
  std::vector<StreamPages> pages; ///< One a stream.
  std::optional<Frame> frame;     ///< In place of the first.

  Error broken(const std::string &problem) const { return Error::input("'" + name + "' " + problem); }
  /// All that the head says. The error follows the file's name.
  Expected<void> readHead();

  /// Of those of the first frame: others have none.
  void dropStreamsOfVoxels() {
    for (std::size_t i = streams.size(); i-- > 1;)
      if (streams[i].name != kFrameStream) {
        streams.erase(streams.begin() + static_cast<std::ptrdiff_t>(i));
        pages.erase(pages.begin() + static_cast<std::ptrdiff_t>(i));
      }
  }
};

namespace {

std::uint64_t storedBytes(const StreamPages &stream) {
  return stream.rows.empty() ? 0 : stream.rows.back().end - stream.offset;
}

} // namespace

Expected<void> PagedVolume::State::readHead() {
  const auto header = VOXC_TRY(readHeader(file));
  if (header.version != kPagedVersion)
    return Error::input(
        "is not compressed: it has no pages to decode; `voxc export --compress` makes a file that has");
  auto read = VOXC_TRY(readPageTables(rowsOf(header, file), header.textEnd(), header.headBytes, file));
  Checksum checksum;
  addAllButItself(checksum, file.first(header.headBytes));
  if (checksum.digest() != header.checksum)
    return Error::input("is damaged: its checksum does not match its head");
  if (std::string problem = describeProblem(read, header.headBytes, file.size()); !problem.empty())
    return Error::input(std::move(problem));
  info = VOXC_TRY(infoOf(header, file));
  headChecksum = header.checksum;
  headBytes = header.headBytes;
  pages = std::move(read);
  for (const StreamPages &stream : pages) {
    streams.push_back(stream.stream);
    streams.back().storedBytes = storedBytes(stream);
  }
  return {};
}

PagedVolume::PagedVolume(std::unique_ptr<State> state) : state_(std::move(state)) {}
PagedVolume::~PagedVolume() = default;
PagedVolume::PagedVolume(PagedVolume &&) noexcept = default;
PagedVolume &PagedVolume::operator=(PagedVolume &&) noexcept = default;

Expected<PagedVolume> PagedVolume::open(const std::string &path) {
  VOXC_TRY(checkNoJournal(path));
  auto opened = VOXC_TRY(MappedFile::open(path));
  const auto file = std::make_shared<const MappedFile>(std::move(opened));
  return read(file->bytes(), file, path);
}

Expected<PagedVolume> PagedVolume::read(std::span<const std::byte> file, std::shared_ptr<const void> owner,
                                        const std::string &name) {
  auto state = std::make_unique<State>();
  state->name = name;
  state->file = file;
  state->owner = std::move(owner);
  if (auto head = state->readHead(); !head)
    return state->broken(head.error().message);
  return PagedVolume(std::move(state));
}

const VolumeInfo &PagedVolume::info() const { return state_->info; }
std::span<const PagedStream> PagedVolume::streams() const { return state_->streams; }
std::uint64_t PagedVolume::headChecksum() const { return state_->headChecksum; }
std::uint64_t PagedVolume::headBytes() const { return state_->headBytes; }
std::uint64_t PagedVolume::fileBytes() const { return state_->file.size(); }

Expected<void> PagedVolume::decode(std::size_t stream, std::uint64_t page, std::span<std::byte> room) const {
  if (stream >= state_->pages.size() || page >= state_->pages[stream].rows.size())
    return Error::usage("'" + state_->name + "' has no page " + std::to_string(page) + " of stream " +
                        std::to_string(stream));
  const StreamPages &pages = state_->pages[stream];
  if (room.size() != pages.stream.bytesOf(page))
    return Error::usage("page " + std::to_string(page) + " of stream '" + pages.stream.name +
                        "' needs room for " + std::to_string(pages.stream.bytesOf(page)) + " bytes, not " +
                        std::to_string(room.size()));
  // A copy: what changes in the file after it was checked is not looked at.
  thread_local std::vector<std::byte> stored;
  const auto inFile = pages.stored(state_->file, page);
  stored.assign(inFile.begin(), inFile.end());
  Checksum checksum;
  checksum.add(stored.data(), stored.size());
  thread_local PageDecoder decoder;
  if (checksum.digest() != pages.rows[page].checksum ||
      !decoder.decode(stored, pages.stream.elementBytes, room))
    return state_->broken("is damaged: page " + std::to_string(page) + " of stream '" + pages.stream.name +
                          "' is not what was stored");
  if (state_->frame && stream == 0 && page == 0)
    std::memcpy(room.data(), &state_->frame->root, sizeof state_->frame->root);
  return {};
}

/// Decodes the one page that the frame lies in. With another than the first, streams of voxels are gone.
Expected<void> PagedVolume::chooseFrame(int number) {
  const auto stream = std::ranges::find(streams(), kFrameStream, &PagedStream::name);
  const bool hasFrames =
      stream != streams().end() && stream->elementBytes == sizeof(Frame) && stream->bytes > 0;
  if (!hasFrames && number == 1)
    return {};
  if (auto checked = checkFrameNumber(number, hasFrames ? stream->bytes / sizeof(Frame) : 0); !checked)
    return Error::input("'" + state_->name + "': " + checked.error().message);
  const std::uint64_t place = (static_cast<std::uint64_t>(number) - 1) * sizeof(Frame);
  const std::uint64_t page = place / stream->pageBytes; // Pages are whole frames: powers of two.
  std::vector<std::byte> room(stream->bytesOf(page));
  VOXC_TRY(decode(static_cast<std::size_t>(stream - streams().begin()), page, room));
  Frame frame;
  std::memcpy(&frame, room.data() + place % stream->pageBytes, sizeof frame);
  state_->frame = frame;
  state_->info.voxels = frame.voxels;
  if (number > 1)
    state_->dropStreamsOfVoxels();
  return {};
}

} // namespace voxc
