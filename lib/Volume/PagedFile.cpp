// Decoding the pages of a file, on several threads.
#include "PagedFile.h"

#include "Support/ParallelFor.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Volume/Frames.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace voxc {
namespace {

/// What is decoded between two growths of the memory.
constexpr std::uint64_t kRunBytes = std::uint64_t{64} << 20;

/// What a byte of the file may stand for in a stream that has more elements than there are voxels: attributes
/// and coarse blocks have fewer.
constexpr std::uint64_t kMostPerStoredByte = 1024;
/// Streams of so many bytes are decoded whatever they take in the file, and frames too, which can repeat.
constexpr std::uint64_t kSmallBytes = std::uint64_t{1} << 20, kFrameBytes = kMostFrames * sizeof(Frame);

/// Decodes one stream after the other.
class StreamDecoder {
public:
  StreamDecoder(const PagedVolume &file, const LoadOptions &options)
      : file_(file), threads_(options.threads), progress_(options.progress), memory_(options.memory) {}

  /// All of a stream, in a block as large.
  Expected<MemoryBlock> decode(std::size_t stream) const;

private:
  Expected<void> decodeRun(std::size_t stream, std::uint64_t first, std::uint64_t last,
                           std::byte *begin) const;

  const PagedVolume &file_;
  unsigned threads_;
  const Progress &progress_;
  std::shared_ptr<WorkingMemory> memory_;
};

Expected<MemoryBlock> StreamDecoder::decode(std::size_t stream) const {
  const PagedStream &told = file_.streams()[stream];
  auto block = VOXC_TRY(memory_->reserve(told.bytes));
  const std::uint64_t runPages = kRunBytes / told.pageBytes;
  for (std::uint64_t first = 0; first < told.pages(); first += runPages) {
    VOXC_TRY(progress_.check());
    const std::uint64_t last = std::min(first + runPages, told.pages());
    const std::uint64_t begin = first * told.pageBytes;
    VOXC_TRY(memory_->extend(block, std::min(kRunBytes, told.bytes - begin)));
    VOXC_TRY(decodeRun(stream, first, last, block.data()));
  }
  return block;
}

Expected<void> StreamDecoder::decodeRun(std::size_t stream, std::uint64_t first, std::uint64_t last,
                                        std::byte *begin) const {
  const PagedStream &told = file_.streams()[stream];
  return parallelTry(last - first, threads_, [&](std::uint64_t i) {
    const std::uint64_t page = first + i;
    memory_->relieve(told.bytesOf(page));
    return file_.decode(stream, page, {begin + page * told.pageBytes, told.bytesOf(page)});
  });
}

/// What the streams of a whole volume lie in.
struct Kept {
  Volume proved;
  std::vector<MemoryBlock> blocks;
};

bool isProved(std::string_view name) { return name == kWordStream || name == kFrameStream; }

/// True if a stream has more than what an element for each voxel would take, and than what is let pass.
bool claimsTooMuch(const PagedStream &stream, std::uint64_t voxels) {
  return stream.bytes > kSmallBytes && stream.bytes / stream.elementBytes > voxels &&
         stream.bytes / kMostPerStoredByte > stream.storedBytes;
}

Error tooMuch(const std::string &name, const PagedStream &stream) {
  return Error::input("'" + name + "' has a stream '" + stream.name + "' of " + std::to_string(stream.bytes) +
                      " bytes, but it takes " + std::to_string(stream.storedBytes) +
                      " in the file; a stream of more elements than the volume has voxels has at most " +
                      std::to_string(kMostPerStoredByte) + " times as many");
}

Stream streamOf(const PagedStream &told, const MemoryBlock &block) {
  return {told.name, told.elementBytes, {block.data(), told.bytes}, told.storedBytes};
}

} // namespace

PagedReading::PagedReading(const PagedVolume &file, const std::string &name, const LoadOptions &options)
    : file_(file), name_(name), options_(options) {
  if (!options_.memory)
    options_.memory = WorkingMemory::createDefault();
}

Expected<Volume> PagedReading::proved() const {
  const StreamDecoder decoder(file_, options_);
  auto blocks = std::make_shared<std::vector<MemoryBlock>>();
  std::vector<Stream> streams;
  for (std::size_t i = 0; i < file_.streams().size(); ++i) {
    const PagedStream &told = file_.streams()[i];
    if (!isProved(told.name))
      continue;
    // Of frames there may be more than of voxels, whose number is not known yet.
    if (told.name != kWordStream && told.bytes > kFrameBytes && claimsTooMuch(told, 0))
      return tooMuch(name_, told);
    auto block = VOXC_TRY(decoder.decode(i));
    streams.push_back(streamOf(told, block));
    blocks->push_back(std::move(block));
  }
  return Volume(file_.info(), std::move(streams), std::move(blocks));
}

Expected<Volume> PagedReading::whole(Volume proved) const {
  const StreamDecoder decoder(file_, options_);
  const auto kept = std::make_shared<Kept>(Kept{std::move(proved), {}});
  std::vector<Stream> streams;
  for (std::size_t i = 0; i < file_.streams().size(); ++i) {
    const PagedStream &told = file_.streams()[i];
    if (const Stream *const stream = kept->proved.findStream(told.name)) {
      streams.push_back(*stream);
      continue;
    }
    if (claimsTooMuch(told, kept->proved.info().voxels))
      return tooMuch(name_, told);
    auto block = VOXC_TRY(decoder.decode(i));
    streams.push_back(streamOf(told, block));
    kept->blocks.push_back(std::move(block));
  }
  return Volume(file_.info(), std::move(streams), kept);
}

} // namespace voxc
