// The table of streams in a .hvx file (docs/hvx.md): what each is called, and where it lies.
#pragma once

#include "voxc/Volume/Stream.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

inline constexpr std::uint32_t kMostStreams = 64;
inline constexpr std::uint32_t kMostElementBytes = 256;

/// A row of the table; little-endian, no padding.
struct StreamRow {
  std::array<char, 32> name{}; ///< Filled up with zeros, of which there is at least one.
  std::uint32_t elementBytes = 0;
  std::uint32_t pageBytes = 0; ///< Before compression, of all pages but the last; 0: stored as it is.
  std::uint64_t elements = 0;
  std::uint64_t offset = 0; ///< In bytes from the beginning of the file.
};
static_assert(sizeof(StreamRow) == 56);

/// 1 to 31 of a to z, 0 to 9 and '-', the first a letter.
bool isStreamName(std::string_view name);

/// The smallest number of bytes from here up that is whole pages, as they can be mapped and uploaded.
std::uint64_t wholePages(std::uint64_t bytes);

/// Where a stream of so many bytes lies behind what ends at `end`: at the next page, or there if it is empty.
std::uint64_t placeOf(std::uint64_t bytes, std::uint64_t end);

/// The rows of streams that stand one behind the other after a head of `headBytes`.
std::vector<StreamRow> layOut(std::span<const Stream> streams, std::uint64_t headBytes);

/// What is wrong with the row `index` beside where it lies, or nothing.
std::string describeProblem(std::span<const StreamRow> rows, std::size_t index);

/// What is wrong with the rows of a mapped file, or nothing: they must be those that `layOut` gives for
/// streams that reach to the end of the file. "has ...", to follow the file's name.
std::string describeProblem(std::span<const StreamRow> rows, std::uint64_t headBytes,
                            std::uint64_t fileBytes);

/// The name of a row that was found right.
std::string_view nameOf(const StreamRow &row);

/// The streams inside the bytes of a file whose rows were found right.
std::vector<Stream> streamsIn(std::span<const std::byte> file, std::span<const StreamRow> rows);

} // namespace voxc
