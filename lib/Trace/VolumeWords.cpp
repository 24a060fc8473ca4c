// The words of a volume on a device.
#include "VolumeWords.h"

#include <algorithm>
#include <array>

namespace voxc {
namespace {

constexpr std::size_t kMaxSegments = 16;

Expected<void> checkAddressing(const Device::State &device, std::uint64_t words, Addressing addressing) {
  const DeviceInfo &info = device.info();
  std::uint64_t bytes = VolumeWords::paddedBytes(words);
  if (words == 0)
    return Error::input("this volume has no words; even an empty one has word 0");
  if (words > kSegmentWords * kMaxSegments)
    return Error::environment("this volume has " + bytesText(bytes) + ", but a kernel reaches at most " +
                              bytesText(kSegmentWords * kMaxSegments * sizeof(std::uint32_t)));
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

Expected<Buffer> uploadTable(Device::State &device, Transfer &transfer, std::span<const Buffer> segments) {
  std::array<VkDeviceAddress, kMaxSegments> addresses{};
  std::ranges::transform(segments, addresses.begin(),
                         [&](const Buffer &buffer) { return buffer.address(device); });
  auto table = Buffer::create(device, {.what = "a table of segments", .bytes = sizeof addresses});
  if (!table)
    return table;
  if (auto uploaded = transfer.upload(std::as_bytes(std::span(addresses)), *table); !uploaded)
    return uploaded.error();
  return table;
}

} // namespace

Expected<VolumeWords> VolumeWords::upload(Device::State &device, Transfer &transfer,
                                          std::span<const std::uint32_t> words, Addressing addressing) {
  if (auto checked = checkAddressing(device, words.size(), addressing); !checked)
    return checked.error();
  bool addressed = addressing == Addressing::Segments;
  VolumeWords result;
  for (std::uint64_t first = 0; first < words.size(); first += kSegmentWords) {
    std::uint64_t count = addressed ? std::min(kSegmentWords, words.size() - first) : words.size();
    auto part = uploadPart(device, transfer, words.subspan(first, count), addressed);
    if (!part)
      return part.error();
    result.segments_.push_back(std::move(*part));
    if (!addressed)
      return result;
  }
  auto table = uploadTable(device, transfer, result.segments_);
  if (!table)
    return table.error();
  result.table_.emplace(std::move(*table));
  return result;
}

} // namespace voxc
