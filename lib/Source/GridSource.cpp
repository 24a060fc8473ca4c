// A dense grid of words, in memory or from a file.
#include "Source/DenseSource.h"
#include "Source/GridExtent.h"
#include "Support/WatchedFile.h"
#include "voxc/Source/Sources.h"

#include <bit>
#include <cstring>
#include <utility>

namespace voxc {

namespace {

static_assert(std::endian::native == std::endian::little, "words are read as they lie in the file");

/// Words that lie one after the other, and what keeps them there.
template <typename Storage> class WordRows final : public DenseRows {
public:
  WordRows(Int3 extent, Storage storage, const std::byte *words)
      : extent_(extent), storage_(std::move(storage)), words_(words) {}

  void read(Int3 first, std::int32_t count, std::uint32_t *words) const override {
    const std::uint64_t at = cellNumber(extent_, first) * sizeof *words;
    std::memcpy(words, words_ + at, static_cast<std::size_t>(count) * sizeof *words);
  }

private:
  Int3 extent_;
  Storage storage_;
  const std::byte *words_;
};

} // namespace

std::unique_ptr<VoxelSource> makeGridSource(Int3 extent, std::vector<std::uint32_t> words) {
  const auto *const bytes = reinterpret_cast<const std::byte *>(words.data());
  auto rows = std::make_shared<WordRows<std::vector<std::uint32_t>>>(extent, std::move(words), bytes);
  // Nothing stops this.
  return std::move(*makeDenseSource(extent, std::move(rows), {}, nullptr, {}));
}

Expected<std::unique_ptr<VoxelSource>> loadGridSource(Int3 extent, const std::string &path,
                                                      std::shared_ptr<WorkingMemory> memory,
                                                      const Progress &progress) {
  VOXC_TRY(checkGridExtent(extent));
  auto file = VOXC_TRY(WatchedFile::open(path, memory));
  const std::uint64_t count = cellsOf(extent);
  const std::uint64_t bytes = file->bytes().size();
  if (bytes % 4 != 0 || bytes / 4 != count)
    return Error::input("'" + path + "' has " + std::to_string(bytes) + " bytes, but a grid of " +
                        extentText(extent) + " cells has " + std::to_string(count) + " words of 4 bytes");
  const std::byte *const words = file->bytes().data();
  using FileRows = WordRows<std::shared_ptr<const WatchedFile>>;
  return makeDenseSource(extent, std::make_shared<FileRows>(extent, std::move(file), words), {},
                         std::move(memory), progress);
}

} // namespace voxc
