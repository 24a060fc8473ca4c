// The words of a volume on a device.
#include "VolumeWords.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace voxc {
namespace {

Expected<void> checkAddressing(const Device::State &device, std::uint64_t words, Addressing addressing) {
  const DeviceInfo &info = device.info();
  std::uint64_t bytes = VolumeWords::paddedBytes(words);
  if (words == 0)
    return Error::input("this volume has no words; even an empty one has word 0");
  if (addressing == Addressing::Buffer && bytes > info.maxStorageBufferBytes)
    return Error::environment("this volume has " + bytesText(bytes) + ", but a storage buffer of " +
                              info.name + " holds at most " + bytesText(info.maxStorageBufferBytes) +
                              ": use a kernel with addressing=segments");
  if (addressing == Addressing::Texels && bytes > info.maxTexelBufferBytes)
    return Error::environment("this volume has " + bytesText(bytes) + ", but a texel buffer of " + info.name +
                              " holds at most " + bytesText(info.maxTexelBufferBytes) +
                              ": use a kernel with addressing=buffer");
  if (addressing == Addressing::Segments && !info.deviceAddresses)
    return Error::environment("this volume of " + bytesText(bytes) + " needs device addresses, which " +
                              info.name + " lacks: use a device that has them");
  return {};
}

/// Words are compared and copied in blocks of so many: copying a block takes less than a copy of its own.
constexpr std::size_t kBlockWords = std::size_t{1} << 14;

/// The bytes that the part of a volume may have.
std::uint64_t mostBytes(const DeviceInfo &device, Addressing addressing) {
  if (addressing == Addressing::Segments)
    return VolumeWords::paddedBytes(kSegmentWords);
  const std::uint64_t reached =
      addressing == Addressing::Texels ? device.maxTexelBufferBytes : device.maxStorageBufferBytes;
  return std::min(reached, device.maxAllocationBytes) / 16 * 16;
}

/// A buffer that grows gets room for an eighth more than it needs: edits follow one another.
std::uint64_t roomyBytes(const DeviceInfo &device, std::uint64_t words, Addressing addressing) {
  return std::max(VolumeWords::paddedBytes(words),
                  std::min(VolumeWords::paddedBytes(words + words / 8), mostBytes(device, addressing)));
}

bool areZero(std::span<const std::uint32_t> words) {
  return words.front() == 0 &&
         std::memcmp(words.data(), words.data() + 1, words.size_bytes() - sizeof(std::uint32_t)) == 0;
}

bool areEqual(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

/// Those of the part `index`, if there are any.
std::span<const std::uint32_t> partOf(std::span<const std::uint32_t> words, std::uint64_t partWords,
                                      std::uint64_t index) {
  const std::uint64_t first = std::min<std::uint64_t>(index * partWords, words.size());
  return words.subspan(first, std::min<std::uint64_t>(partWords, words.size() - first));
}

/// The ranges that lie in the part `index`, of so many words, counted from its first word.
std::vector<WordRange> rangesWithin(std::span<const WordRange> ranges, std::uint64_t index,
                                    std::uint64_t partWords, std::uint64_t words) {
  std::vector<WordRange> within;
  const std::uint64_t begin = index == 0 ? 0 : index * partWords;
  for (const WordRange &range : ranges) {
    const std::uint64_t first = std::max(range.first, begin), end = std::min(range.end, begin + words);
    if (first < end)
      within.push_back({first - begin, end - begin});
  }
  return within;
}

/// Whether block `index` of a part holds what it held before.
bool isBlockEqual(std::span<const std::uint32_t> before, std::span<const std::uint32_t> after,
                  std::uint64_t index) {
  return areEqual(partOf(before, kBlockWords, index), partOf(after, kBlockWords, index));
}

/// Copies those blocks of a part that differ; returns the bytes.
Expected<std::uint64_t> copyChanges(Transfer &transfer, Buffer &buffer, std::span<const std::uint32_t> before,
                                    std::span<const std::uint32_t> after) {
  const std::uint64_t blocks = (after.size() + kBlockWords - 1) / kBlockWords;
  std::uint64_t copied = 0;
  for (std::uint64_t first = 0; first < blocks; ++first) {
    std::uint64_t end = first;
    while (end < blocks && !isBlockEqual(before, after, end))
      ++end;
    if (end == first)
      continue;
    const std::uint64_t at = first * kBlockWords;
    const auto changed = std::as_bytes(after.subspan(at, std::min(end * kBlockWords, after.size()) - at));
    VOXC_TRY(transfer.upload(changed, buffer, at * sizeof(std::uint32_t)));
    copied += changed.size();
    first = end;
  }
  return copied;
}

} // namespace

std::uint64_t VolumeWords::partWords() const {
  return addressing_ == Addressing::Segments ? kSegmentWords : std::numeric_limits<std::uint64_t>::max();
}

Expected<VolumeWords> VolumeWords::upload(Device::State &device, Transfer &transfer,
                                          std::span<const std::uint32_t> words, Addressing addressing) {
  VolumeWords result(device, addressing);
  VOXC_TRY(result.update(transfer, {}, words));
  return result;
}

Expected<UpdateReport> VolumeWords::update(Transfer &transfer, std::span<const std::uint32_t> before,
                                           std::span<const std::uint32_t> after) {
  VOXC_TRY(checkAddressing(*device_, after.size(), addressing_));
  UpdateReport report;
  parts_.resize(1 + (after.size() - 1) / partWords());
  for (std::uint64_t index = 0; index < parts_.size(); ++index) {
    auto copied = VOXC_TRY(updatePart(transfer, parts_[index], partOf(before, partWords(), index),
                                      partOf(after, partWords(), index)));
    report.copiedBytes += copied;
  }
  return updated(transfer, after.size(), report);
}

/// Ends an update of all parts.
Expected<UpdateReport> VolumeWords::updated(Transfer &transfer, std::uint64_t words, UpdateReport report) {
  if (zeros_.use_count() == 1)
    zeros_ = nullptr;
  count_ = words;
  if (addressing_ == Addressing::Segments)
    VOXC_TRY(uploadTable(transfer));
  return report;
}

Expected<UpdateReport> VolumeWords::follow(Transfer &transfer, std::span<const std::uint32_t> after,
                                           std::span<const WordRange> changed) {
  VOXC_TRY(checkAddressing(*device_, after.size(), addressing_));
  UpdateReport report;
  parts_.resize(1 + (after.size() - 1) / partWords());
  for (std::uint64_t index = 0; index < parts_.size(); ++index) {
    const auto words = partOf(after, partWords(), index);
    auto copied = VOXC_TRY(
        followPart(transfer, parts_[index], words, rangesWithin(changed, index, partWords(), words.size())));
    report.copiedBytes += copied;
  }
  return updated(transfer, after.size(), report);
}

/// A part that is new, or one that stands for several, is copied as a whole.
Expected<std::uint64_t> VolumeWords::followPart(Transfer &transfer, Part &part,
                                                std::span<const std::uint32_t> after,
                                                std::span<const WordRange> changed) {
  if (part && changed.empty())
    return std::uint64_t{0};
  if (!part || part == zeros_)
    return updatePart(transfer, part, {}, after);
  VOXC_TRY(makeRoom(transfer, part, after.size()));
  return transfer.upload(after, changed, *part);
}

Expected<std::uint64_t> VolumeWords::updatePart(Transfer &transfer, Part &part,
                                                std::span<const std::uint32_t> before,
                                                std::span<const std::uint32_t> after) {
  if (part && areEqual(before, after))
    return std::uint64_t{0};
  const bool isZero = after.size() == kSegmentWords && areZero(after);
  if (isZero && zeros_) {
    part = zeros_;
    return std::uint64_t{0};
  }
  if (part == zeros_)
    part = nullptr; // Others are that one, too.
  if (!part)
    before = {};
  VOXC_TRY(makeRoom(transfer, part, after.size()));
  auto copied = copyChanges(transfer, *part, before, after);
  if (isZero)
    zeros_ = part;
  return copied;
}

Expected<void> VolumeWords::makeRoom(Transfer &transfer, Part &part, std::uint64_t words) {
  if (part && part->bytes() >= paddedBytes(words))
    return {};
  const std::uint64_t bytes = part ? roomyBytes(device_->info(), words, addressing_) : paddedBytes(words);
  auto buffer = VOXC_TRY(Buffer::create(*device_, {.what = "a volume's words",
                                                   .bytes = bytes,
                                                   .addressed = addressing_ == Addressing::Segments,
                                                   .texels = addressing_ == Addressing::Texels}));
  if (part)
    VOXC_TRY(transfer.copy(*part, buffer, {0, 0, part->bytes()}));
  part = std::make_shared<Buffer>(std::move(buffer));
  return {};
}

Expected<void> VolumeWords::uploadTable(Transfer &transfer) {
  std::vector<VkDeviceAddress> addresses;
  addresses.reserve(parts_.size());
  for (const Part &part : parts_)
    addresses.push_back(part->address(*device_));
  const auto bytes = std::as_bytes(std::span<const VkDeviceAddress>(addresses));
  if (!table_ || table_->bytes() < bytes.size()) {
    auto table = VOXC_TRY(Buffer::create(*device_, {.what = "a table of segments", .bytes = bytes.size()}));
    table_.emplace(std::move(table));
  }
  return transfer.upload(bytes, *table_);
}

} // namespace voxc
