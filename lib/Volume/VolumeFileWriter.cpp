// Writing of .hvx files page by page.
#include "VolumeFileWriter.h"

#include "VolumeFile.h"

#include <algorithm>

namespace voxc {

Expected<VolumeFileWriter> VolumeFileWriter::create(const std::string &path, const VolumeInfo &info) {
  auto file = OutputFile::create(path);
  if (!file)
    return file.error();
  return VolumeFileWriter(std::move(*file), volumeWordsOffset(info));
}

Expected<void> VolumeFileWriter::settle(MemoryBlock &block, std::uint64_t begin, std::uint64_t bytes,
                                        WorkingMemory &memory) {
  return memory.settle(block, begin, bytes, file_.descriptor(), wordsOffset_ + begin);
}

Expected<void> VolumeFileWriter::finish(const VolumeInfo &info, std::span<const std::uint32_t> words,
                                        std::pair<std::uint64_t, std::uint64_t> settled,
                                        WorkingMemory &memory) {
  const auto bytes = std::as_bytes(words);
  const std::uint64_t headEnd = std::min<std::uint64_t>(settled.first, bytes.size());
  if (auto written = file_.rewrite(wordsOffset_, bytes.data(), headEnd); !written)
    return written;
  if (bytes.size() > settled.second)
    if (auto written = file_.rewrite(wordsOffset_ + settled.second, bytes.data() + settled.second,
                                     bytes.size() - settled.second);
        !written)
      return written;
  const std::string header = volumeFileHeader(info, words, [&] { memory.relieve(); });
  if (auto written = file_.rewrite(0, header.data(), header.size()); !written)
    return written;
  return file_.commit();
}

} // namespace voxc
