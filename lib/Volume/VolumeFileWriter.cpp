// Writing of .hvx files page by page.
#include "VolumeFileWriter.h"

#include "VolumeFile.h"

#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace voxc {

Expected<VolumeFileWriter> VolumeFileWriter::create(const std::string &path, const VolumeInfo &info) {
  auto file = OutputFile::create(path);
  if (!file)
    return file.error();
  return VolumeFileWriter(std::move(*file), volumeWordsOffset(info));
}

Expected<void> VolumeFileWriter::extend(MemoryBlock &block, std::uint64_t bytes, WorkingMemory &memory) {
  return memory.extendFromFile(block, bytes, file_.descriptor(), wordsOffset_ + block.size());
}

Expected<void> VolumeFileWriter::finish(const VolumeInfo &info, std::span<const std::uint32_t> words,
                                        WorkingMemory &memory) {
  const std::string header = volumeFileHeader(info, words, [&] { memory.relieve(); });
  const auto size = static_cast<off_t>(wordsOffset_ + words.size_bytes());
  const ssize_t written = ::pwrite(file_.descriptor(), header.data(), header.size(), 0);
  if (::ftruncate(file_.descriptor(), size) != 0 || written != static_cast<ssize_t>(header.size()))
    return Error::environment(std::string("cannot complete the volume's file: ") + std::strerror(errno));
  return file_.commit();
}

} // namespace voxc
