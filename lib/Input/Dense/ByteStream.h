// Bytes of samples that come piece by piece, out of whatever a file has encoded them with.
#pragma once

#include "Input/Dense/Samples.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc {

class ByteStream {
public:
  virtual ~ByteStream() = default;

  /// Fills `target`, or as much of it as there is left, and returns how much that was. Error: damaged data.
  virtual Expected<std::size_t> readSome(std::span<std::byte> target) = 0;

  /// More bytes than this are in no such stream.
  virtual std::uint64_t mostBytes() const = 0;

  /// Once the end was read: how many bytes lie behind what is compressed.
  virtual std::uint64_t bytesBehind() const { return 0; }
};

/// Each reads `bytes`, which must outlive it: as they are; by gzip, whose members follow each other;
/// deflated, with nothing around that; by bzip2, as gzip; two hexadecimal digits a byte; decimal numbers that
/// become samples of a type in this machine's order.
std::unique_ptr<ByteStream> makeRawStream(std::span<const std::byte> bytes);
std::unique_ptr<ByteStream> makeGzipStream(std::span<const std::byte> bytes);
std::unique_ptr<ByteStream> makeDeflateStream(std::span<const std::byte> bytes);
std::unique_ptr<ByteStream> makeBzip2Stream(std::span<const std::byte> bytes);
std::unique_ptr<ByteStream> makeHexStream(std::span<const std::byte> bytes);
std::unique_ptr<ByteStream> makeTextStream(std::span<const std::byte> bytes, SampleType type);

/// Reads to the end and returns how many bytes that were. Errors: more than `most`, the stream's,
/// interrupted.
Expected<std::uint64_t> countBytes(ByteStream &stream, std::uint64_t most, const Progress &progress);

/// Leaves out bytes. Errors: there are fewer; the stream's; interrupted.
Expected<void> skipBytes(ByteStream &stream, std::uint64_t count, const Progress &progress);

/// A sentence about what follows the samples that were read: more of them, or damage; else nothing.
std::vector<std::string> saysBehind(ByteStream &stream);

/// Appends `count` bytes to `target`, which grows with what is read, not with what was promised. Errors:
/// there are fewer; the stream's; no memory; interrupted.
Expected<void> appendBytes(ByteStream &stream, std::uint64_t count, ScratchArray<std::byte> &target,
                           WorkingMemory &memory, const Progress &progress);

} // namespace voxc
