// The words of a volume on a device.
#include "VolumeWords.h"

#include <algorithm>
#include <cstring>

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
  if (addressing == Addressing::Segments && !info.deviceAddresses)
    return Error::environment("this volume of " + bytesText(bytes) + " needs device addresses, which " +
                              info.name + " lacks: use a device that has them");
  return {};
}

Expected<Buffer> uploadPart(Device::State &device, Transfer &transfer, std::span<const std::uint32_t> words,
                            bool addressed) {
  auto buffer = Buffer::create(
      device,
      {.what = "a volume's words", .bytes = VolumeWords::paddedBytes(words.size()), .addressed = addressed});
  if (!buffer)
    return buffer;
  if (auto uploaded = transfer.upload(std::as_bytes(words), *buffer); !uploaded)
    return uploaded.error();
  return buffer;
}

Expected<Buffer> uploadTable(Device::State &device, Transfer &transfer,
                             std::span<const VkDeviceAddress> addresses) {
  auto table = Buffer::create(device, {.what = "a table of segments", .bytes = addresses.size_bytes()});
  if (!table)
    return table;
  if (auto uploaded = transfer.upload(std::as_bytes(addresses), *table); !uploaded)
    return uploaded.error();
  return table;
}

bool areZero(std::span<const std::uint32_t> words) {
  return words.front() == 0 &&
         std::memcmp(words.data(), words.data() + 1, words.size_bytes() - sizeof(std::uint32_t)) == 0;
}

} // namespace

Expected<VolumeWords> VolumeWords::upload(Device::State &device, Transfer &transfer,
                                          std::span<const std::uint32_t> words, Addressing addressing) {
  if (auto checked = checkAddressing(device, words.size(), addressing); !checked)
    return checked.error();
  VolumeWords result;
  if (addressing == Addressing::Segments) {
    if (auto uploaded = result.uploadSegments(device, transfer, words); !uploaded)
      return uploaded.error();
    return result;
  }
  auto whole = uploadPart(device, transfer, words, false);
  if (!whole)
    return whole.error();
  result.segments_.push_back(std::move(*whole));
  return result;
}

Expected<void> VolumeWords::uploadSegments(Device::State &device, Transfer &transfer,
                                           std::span<const std::uint32_t> words) {
  std::vector<VkDeviceAddress> addresses;
  VkDeviceAddress zeros = 0; // Of the one segment that all those are which hold nothing.
  for (std::uint64_t first = 0; first < words.size(); first += kSegmentWords) {
    const auto part = words.subspan(first, std::min(kSegmentWords, words.size() - first));
    const bool isZero = part.size() == kSegmentWords && areZero(part);
    if (isZero && zeros != 0) {
      addresses.push_back(zeros);
      continue;
    }
    auto segment = uploadPart(device, transfer, part, true);
    if (!segment)
      return segment.error();
    addresses.push_back(segment->address(device));
    zeros = isZero ? addresses.back() : zeros;
    segments_.push_back(std::move(*segment));
  }
  auto table = uploadTable(device, transfer, addresses);
  if (!table)
    return table.error();
  table_.emplace(std::move(*table));
  return {};
}

} // namespace voxc
