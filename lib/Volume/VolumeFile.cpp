// Reading .hvx files of all versions, and the heads of those that are mapped; docs/hvx.md has the layout as a
// table.
#include "VolumeFile.h"

#include "Frames.h"
#include "PagedFile.h"
#include "Structure.h"
#include "VolumeHead.h"

#include <algorithm>
#include <cstddef>

namespace voxc {
namespace {

constexpr std::size_t kBytesBetweenPauses = std::size_t{1} << 16;

void addStream(Checksum &checksum, std::span<const std::byte> bytes, const std::function<void()> &pause) {
  for (std::size_t begin = 0; begin < bytes.size(); begin += kBytesBetweenPauses) {
    checksum.add(bytes.data() + begin, std::min(kBytesBetweenPauses, bytes.size() - begin));
    if (pause)
      pause();
  }
}

Error broken(const std::string &name, const std::string &problem) {
  return Error::input("'" + name + "' " + problem);
}

/// A volume whose streams stay where they lie.
Expected<Volume> readMapped(const Header &header, std::span<const std::byte> bytes,
                            std::shared_ptr<const void> owner, const std::string &name) {
  const auto rows = rowsOf(header, bytes);
  if (const std::string problem = describeProblem(rows, header.headBytes, bytes.size()); !problem.empty())
    return broken(name, problem);
  Checksum checksum;
  addAllButItself(checksum, bytes);
  if (checksum.digest() != header.checksum)
    return broken(name, "is damaged: its checksum does not match its contents");
  auto info = infoOf(header, bytes);
  if (!info)
    return broken(name, info.error().message);
  return Volume(std::move(*info), streamsIn(bytes, rows), std::move(owner));
}

/// Follows every pointer of every frame, and counts the voxels.
Expected<void> checkWords(const Volume &volume, const std::string &name, const Progress &progress) {
  const KeepOn keepOn = [&] { return !progress.stopped(); };
  if (const auto frames = framesOf(volume); !frames.empty()) {
    const auto checked = checkStructure(volume.layout(), volume.words(), frames, keepOn);
    return checked || checked.error().kind == ErrorKind::Interrupted ? checked
                                                                     : broken(name, checked.error().message);
  }
  const auto voxels = checkStructure(volume.layout(), volume.words(), keepOn);
  if (!voxels && voxels.error().kind == ErrorKind::Interrupted)
    return voxels.error();
  if (!voxels)
    return Error::input("'" + name + "': " + voxels.error().message);
  if (*voxels != volume.info().voxels)
    return Error::input("'" + name + "' holds " + std::to_string(*voxels) + " voxels, but its header says " +
                        std::to_string(volume.info().voxels));
  return {};
}

/// Proves the words and frames of a volume.
Expected<void> prove(const Volume &volume, const std::string &name, const LoadOptions &options) {
  if (auto framed = checkFrames(volume); !framed)
    return broken(name, framed.error().message);
  return options.trusted ? Expected<void>() : checkWords(volume, name, options.progress);
}

/// A volume whose streams are decoded, and need the file no longer. What its voxels ask for is decoded once
/// there are so many.
Expected<Volume> readPaged(std::span<const std::byte> bytes, const std::string &name,
                           const LoadOptions &options) {
  const auto file = VOXC_TRY(PagedVolume::read(bytes, nullptr, name));
  const PagedReading reading(file, name, options);
  auto proved = VOXC_TRY(reading.proved());
  VOXC_TRY(prove(proved, name, options));
  return reading.whole(std::move(proved));
}

} // namespace

Expected<Volume> readVolumeFile(std::span<const std::byte> bytes, std::shared_ptr<const void> owner,
                                const std::string &name, const LoadOptions &options) {
  const auto header = readHeader(bytes);
  if (!header)
    return broken(name, header.error().message);
  if (header->version == kPagedVersion)
    return readPaged(bytes, name, options);
  auto volume = VOXC_TRY(readMapped(*header, bytes, std::move(owner), name));
  VOXC_TRY(prove(volume, name, options));
  return volume;
}

std::uint64_t volumeHeadBytes(const VolumeInfo &info, std::size_t streams) {
  return headerOf(info, streams).headBytes;
}

std::string volumeFileHead(const VolumeInfo &info, std::span<const Stream> streams,
                           const std::function<void()> &pause) {
  Header header = headerOf(info, streams.size());
  const auto rows = layOut(streams, header.headBytes);
  header.fileBytes = rows.back().offset + streams.back().bytes.size();
  std::string head = headText(header, rows, info);
  head.resize(header.headBytes);

  Checksum checksum;
  addAllButItself(checksum, std::as_bytes(std::span(head)));
  std::uint64_t end = head.size();
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const std::string padding(rows[i].offset - end, '\0');
    checksum.add(padding.data(), padding.size());
    addStream(checksum, streams[i].bytes, pause);
    end = rows[i].offset + streams[i].bytes.size();
  }
  seal(head, checksum.digest());
  return head;
}

} // namespace voxc
