// Decoding all pages of a file, on several threads.
#include "PagedFile.h"

#include "Support/ParallelFor.h"
#include "voxc/Support/WorkingMemory.h"

#include <algorithm>

namespace voxc {
namespace {

/// What is decoded between two growths of the memory.
constexpr std::uint64_t kRunBytes = std::uint64_t{64} << 20;

/// Decodes one stream after the other.
class StreamDecoder {
public:
  StreamDecoder(const PagedVolume &file, const LoadOptions &options)
      : file_(file), threads_(options.threads), progress_(options.progress),
        memory_(options.memory ? options.memory : WorkingMemory::createDefault()) {}

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
    if (progress_.stopped())
      return Error::interrupted();
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

} // namespace

Expected<Volume> decodeAll(const PagedVolume &file, const LoadOptions &options) {
  const StreamDecoder decoder(file, options);
  auto blocks = std::make_shared<std::vector<MemoryBlock>>();
  std::vector<Stream> streams;
  for (std::size_t i = 0; i < file.streams().size(); ++i) {
    const PagedStream &told = file.streams()[i];
    auto block = VOXC_TRY(decoder.decode(i));
    streams.push_back({told.name, told.elementBytes, {block.data(), told.bytes}, told.storedBytes});
    blocks->push_back(std::move(block));
  }
  return Volume(file.info(), std::move(streams), std::move(blocks));
}

} // namespace voxc
