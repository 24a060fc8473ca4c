// Packs: what a machine without the compiler needs to trace cells, in folders of a bounded size.
#pragma once

#include "sweep/RaySet.h"

#include "voxc/IR/Format.h"
#include "voxc/Measure/Record.h"
#include "voxc/Support/Error.h"

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace voxc::tool::bench {

using namespace measure;

/// Writes files into pack-001, pack-002, ... of a folder, each of at most so many bytes. A file that does not
/// fit into what is left of a pack goes on in the next, in pieces whose names sort in order.
class PackWriter {
public:
  PackWriter(std::string folder, std::uint64_t packBytes)
      : folder_(std::move(folder)), packBytes_(packBytes) {}

  /// Adds a file in pieces named NAME.001, NAME.002, ...; one whose name was added before is left out.
  /// Errors: `Input` if `path` cannot be read, `Environment`.
  Expected<void> addPieces(const std::string &name, const std::string &path);
  /// Adds a small file whole, under its name.
  Expected<void> addWhole(const std::string &name, std::string_view content);
  /// Adds a line to the list of cells.
  void addCell(const std::string &line) { cells_ += line + "\n"; }
  /// Writes the list and the script that runs it into the last pack.
  Expected<void> finish();

  unsigned packs() const { return pack_; }

private:
  Expected<void> startPack();
  std::string pathOf(const std::string &name) const;

  std::string folder_;
  std::uint64_t packBytes_;
  std::uint64_t left_ = 0; ///< Of the pack that is being filled.
  unsigned pack_ = 0;
  std::string cells_;
  std::set<std::string> added_;
};

/// The format of a record as its kernel traverses it. Error: `Input` if the record's format and digest do not
/// belong together.
Expected<Format> formatOf(const Record &record);

/// The path, without its ending, of a volume in a folder's cache.
std::string cachePath(const std::string &folder, const std::string &modelDigest, const Format &format);

/// Adds what a record's cell needs: its volume from the cache of `folder`, its kernel and its rays. Errors:
/// the volume is not in the cache any more (`Input`), and those of the parts.
Expected<void> packCell(const Record &record, const std::string &folder, PackWriter &packs);

} // namespace voxc::tool::bench
