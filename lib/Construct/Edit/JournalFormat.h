// The bytes of a journal of edits (docs/edits.md).
#pragma once

#include "voxc/Source/Edit.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc::journal {

/// What tells a volume file from every other: the checksum and the size in its head.
using Identity = std::array<std::uint64_t, 2>;

/// The head of a journal.
struct Head {
  std::array<std::uint8_t, 8> magic;
  std::uint32_t version;
  std::uint32_t byteOrder;
  Identity identity; ///< Of the volume file whose edits these are.
};

inline constexpr Head kHead = {{0x89, 'H', 'V', 'J', '\r', '\n', 0x1a, '\n'}, 1, 0x01020304, {}};

enum class RecordKind : std::uint32_t {
  Edits = 1,  ///< One transaction.
  Closed = 2, ///< The identity of a volume file that has all edits before it.
};

/// What stands before the bytes of a record.
struct RecordHead {
  RecordKind kind;
  std::uint32_t unused;
  std::uint64_t bytes;
  std::uint64_t checksum; ///< XXH3-64 of kind, number and bytes of the record.
};

struct Record {
  RecordKind kind;
  std::span<const std::byte> bytes;
};

/// A record, the `number`-th of its journal from 0 on, as it is written.
std::string recordText(RecordKind kind, std::uint64_t number, const std::string &bytes);

/// What a journal holds: its whole records, and where they end. What follows was being written when its
/// process ended.
struct Contents {
  Identity identity{};
  std::vector<Record> records;
  std::uint64_t end = 0;
};

/// Errors (`Input`): this is no journal; a record is damaged that was whole, since others follow. One that
/// ends within its head is empty.
Expected<Contents> parse(std::span<const std::byte> file, const std::string &path);

/// The identity in the head of a volume file. Error (`Input`): it cannot be read.
Expected<Identity> identityOf(const std::string &volumePath);

/// Edits as the bytes of a record, and back: volumes that they paste are decoded in `memory`. Errors: a
/// pasted volume cannot be written (`Environment`), or the bytes are no edits (`Input`).
Expected<std::string> editsText(const std::vector<VoxelEdit> &edits);
Expected<void> parseEdits(std::span<const std::byte> bytes, const std::shared_ptr<WorkingMemory> &memory,
                          std::vector<VoxelEdit> &edits);

} // namespace voxc::journal
