// Writing of .hvx files page by page.
#include "VolumeFileWriter.h"

#include "StreamTable.h"
#include "VolumeFile.h"

#include <algorithm>

namespace voxc {

Expected<VolumeFileWriter> VolumeFileWriter::create(const std::string &path, const VolumeInfo &info,
                                                    std::size_t streams) {
  auto file = VOXC_TRY(OutputFile::create(path));
  return VolumeFileWriter(path, std::move(file), volumeHeadBytes(info, streams));
}

Expected<void> VolumeFileWriter::flush(MemoryBlock &block, std::uint64_t begin, std::uint64_t bytes,
                                       WorkingMemory &memory) {
  Expected<void> flushed = memory.flush(block, begin, bytes, file_.descriptor(), wordsOffset_ + begin);
  if (!flushed)
    return Error{flushed.error().kind, "'" + path_ + "': " + flushed.error().message};
  return flushed;
}

Expected<void> VolumeFileWriter::write(std::uint64_t offset, std::span<const std::byte> bytes,
                                       WorkingMemory &memory) {
  constexpr std::size_t kPiece = std::size_t{4} << 20;
  while (!bytes.empty()) {
    const auto piece = bytes.first(std::min(kPiece, bytes.size()));
    VOXC_TRY(file_.rewrite(offset, piece.data(), piece.size()));
    memory.relieve(piece.size());
    offset += piece.size();
    bytes = bytes.subspan(piece.size());
  }
  return {};
}

Expected<void> VolumeFileWriter::finish(const VolumeInfo &info, std::span<const Stream> streams,
                                        std::pair<std::uint64_t, std::uint64_t> flushed,
                                        WorkingMemory &memory) {
  const auto words = streams.front().bytes;
  const std::uint64_t headEnd = std::min<std::uint64_t>(flushed.first, words.size());
  const std::uint64_t tail = std::min<std::uint64_t>(flushed.second, words.size());
  VOXC_TRY(write(wordsOffset_, words.first(headEnd), memory));
  VOXC_TRY(write(wordsOffset_ + tail, words.subspan(tail), memory));
  const auto rows = layOut(streams, wordsOffset_);
  for (std::size_t i = 1; i < streams.size(); ++i)
    VOXC_TRY(write(rows[i].offset, streams[i].bytes, memory));
  const std::string head = volumeFileHead(info, streams, [&] { memory.relieve(); });
  VOXC_TRY(file_.rewrite(0, head.data(), head.size()));
  VOXC_TRY(checkNoJournal(path_));
  return file_.commit();
}

} // namespace voxc
