// Tracing a page file within a budget of memory, for the commands that take a finished volume.
#pragma once

#include "tracing/TraceSession.h"

#include "common/CommandLine.h"
#include "voxc/Render/SurfaceNormals.h"
#include "voxc/Volume/PagedVolume.h"

#include <memory>
#include <optional>
#include <string>

namespace voxc::tool {

class DeviceMemory {
public:
  /// Adds --device-memory to a command; no oracle has a volume in parts, so --check goes not with it.
  void declare(const CommandLine &command);

  /// Adds --allow-coarse to a command that has the above: for pictures.
  void declareCoarse(const CommandLine &command);

  bool isGiven() const { return !budget_.empty(); }
  /// How small blocks may look that stand in for pages, in pixels; 0: they must not, or nobody allows it.
  double allowedCoarse() const { return coarse_.value_or(0); }

  /// How many bytes of words the open file has.
  std::uint64_t volumeBytes() const { return volume_->streams().front().bytes; }

  /// Maps the page file, and returns what it says of itself, without words. `frame`: which is to be seen,
  /// from 1 on; 0: the first. Its figures are added. Error: a file that is not compressed has no pages.
  Expected<Volume> open(const std::string &path, int frame, Json &figures);
  /// Makes `tracing` trace the open file as `format` says. Errors: the traversal cannot wait for pages; as
  /// `createPagedTracer`. `options` tell the shelves; memory and blocks are those of the command.
  Expected<void> prepare(TraceSession &tracing, const Format &format, Json &figures,
                         PagingOptions options = {}) const;
  /// A shelf for pages that are not read for rays alone: half as large as the memory for pages.
  std::shared_ptr<PageShelf> makeShelf() const;
  /// The normals of the open file, which reads pages that are not on the shelf.
  SurfaceNormals makeNormals(std::shared_ptr<PageShelf> shelf, unsigned threads) const {
    return {*volume_, std::move(shelf), threads};
  }

private:
  std::string budget_;
  std::optional<double> coarse_;
  std::optional<PagedVolume> volume_;
};

} // namespace voxc::tool
