// Reading sub-volumes word by word, within bounds: what the kinds of slots are written against.
#pragma once

#include "voxc/Support/Geometry.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace voxc {

/// A cell's terminating integer, and the aligned cube of cells around it that is known to have the same
/// value.
struct Lookup {
  std::uint32_t value = 0;
  int log2Side = 0; ///< In cells of the level.
  std::uint64_t rank =
      0; ///< In ranked strata, how many voxels of the sub-volume come before those of the cell.
};

/// What the slots of a ranked stratum say of the voxels of a node or cell.
struct Ranks {
  std::uint64_t first = 0; ///< How many of the sub-volume come before them.
  std::uint64_t count = 0; ///< How many they are; 0 if no slot says.
};

/// Words that are not all in memory.
class WordSource {
public:
  virtual ~WordSource() = default;
  virtual std::uint64_t size() const = 0;
  /// The word at an offset below `size()`; 0 if it cannot be had.
  virtual std::uint32_t at(std::uint64_t offset) const = 0;
};

/// The words of a volume. Reads outside give 0 and are remembered as the first problem found.
class WordReader {
public:
  /// References in the words count 2^log2Unit words each (`Layout::reader`).
  explicit WordReader(std::span<const std::uint32_t> words, int log2Unit = 0)
      : words_(words), log2Unit_(log2Unit) {}
  /// Reads what `source` has, which must outlive it.
  explicit WordReader(const WordSource &source, int log2Unit = 0) : source_(&source), log2Unit_(log2Unit) {}

  std::uint64_t size() const { return source_ ? source_->size() : words_.size(); }
  std::uint32_t operator[](std::uint64_t offset) const {
    if (offset < words_.size())
      return words_[offset];
    return source_ && offset < source_->size() ? source_->at(offset) : 0;
  }
  /// Brings near the words from an offset on, for a node that is read soon.
  void fetch(std::uint64_t offset) const {
    static constexpr std::uint64_t kMostNodes = 8; // Words that are enough for most nodes.
    if (offset + kMostNodes > words_.size())
      return;
    __builtin_prefetch(words_.data() + offset);
    __builtin_prefetch(words_.data() + offset + kMostNodes - 1);
  }
  /// The word that a reference leads to.
  std::uint64_t wordOf(std::uint32_t ref) const { return std::uint64_t{ref} << log2Unit_; }
  /// True if words [offset, offset + count) exist; otherwise a problem is noted that names `what`.
  bool require(std::uint64_t offset, std::uint64_t count, const char *what);
  /// Notes a problem; the first one stays.
  void fail(std::string problem) {
    if (!problem_)
      problem_ = std::move(problem);
  }
  const std::optional<std::string> &problem() const { return problem_; }

private:
  std::span<const std::uint32_t> words_; ///< None if there is a source.
  const WordSource *source_ = nullptr;
  int log2Unit_;
  std::optional<std::string> problem_;
};

/// Receives what `visitSubVolume` finds.
class SubVolumeVisitor {
public:
  virtual ~SubVolumeVisitor() = default;
  /// A node (of a tree; a grid is one node) of 2^height cells a side is about to be read; false leaves it
  /// out.
  virtual bool enterNode(std::uint64_t offset, int height, Ranks ranks) = 0;
  /// A node of 2^height cells a side, or the sub-volume in a cell of this value, is likely to be read soon.
  virtual void foreseeNode(std::uint64_t /*offset*/, int /*height*/) {}
  virtual void foreseeCell(std::uint32_t /*value*/) {}
  /// True to be given, by `countCells`, how many cells are not empty in a node of a tree of 2^height cells a
  /// side, or, with 0, in one that was entered and has cells alone below, and not to be shown them.
  virtual bool countsCells(int /*height*/) const { return false; }
  virtual void countCells(std::uint64_t /*count*/) {}
  /// All of the node that was entered last, and not left yet, has been visited.
  virtual void leaveNode() {}
  /// Every cell of the aligned `cube` (in cells, from the sub-volume's low corner) has this non-zero value.
  virtual void cells(const Cube &cube, std::uint32_t value, Ranks ranks) = 0;
  /// True to end the traversal early.
  virtual bool done() const { return false; }
};

} // namespace voxc
