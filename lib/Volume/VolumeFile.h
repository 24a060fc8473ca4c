// The .hvx file (docs/hvx.md): a head that says everything about the streams, then the streams.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Volume/Volume.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace voxc {

/// The volume in a whole file, of any version up to ours, that lies in memory that `owner` keeps, aligned as
/// a mapped file is; a compressed one is decoded and not kept. Nothing that it claims is believed: see
/// `Volume::load`, whose errors these are.
Expected<Volume> readVolumeFile(std::span<const std::byte> bytes, std::shared_ptr<const void> owner,
                                const std::string &name, const LoadOptions &options = {});

/// The bytes of the head of a file with so many streams, whole pages: there the words begin.
std::uint64_t volumeHeadBytes(const VolumeInfo &info, std::size_t streams);

/// The head of a file that holds these streams as they are. `pause` is called for every few kilobytes that
/// are read of them.
std::string volumeFileHead(const VolumeInfo &info, std::span<const Stream> streams,
                           const std::function<void()> &pause = {});

} // namespace voxc
