// A volume: the streams of one scene in one format, in memory or mapped from a .hvx file. The first is its
// words.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Layout/WordReader.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/Transform.h"
#include "voxc/Volume/Stream.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

class WorkingMemory;

/// The words that each part of a volume takes. The rest of its words are a head of a few, and what keeps
/// nodes apart where references count granules.
struct WordCounts {
  std::vector<std::uint64_t> levels; ///< Nodes of each level, from the first.
  std::uint64_t values = 0;          ///< Values of voxels that stand apart from the levels.
};

/// What a volume says of itself beside its streams; kept in the file's header.
struct VolumeInfo {
  Format format; ///< Its storage: no traversal attributes.
  Int3 extent;   ///< Of the input, in voxels; the rest of the format is padding.
  Transform voxelToModel;
  std::uint64_t voxels = 0; ///< Non-empty ones.
  std::string provenance;   ///< How to voxelize the input again: "resolution=512 coverage=conservative ...".
  /// As the build counted them; none in volumes of one's own and files of before. Not proved on loading.
  std::optional<WordCounts> wordCounts;
};

/// A quarter of an hour of decoding.
inline constexpr std::uint64_t kMostCubes = std::uint64_t{1} << 34;

/// How a volume is loaded.
struct LoadOptions {
  bool trusted = false; ///< Leaves out the check that proves every offset.
  /// Where the streams of a compressed file go; null: `WorkingMemory::createDefault()`.
  std::shared_ptr<WorkingMemory> memory;
  unsigned threads = 0; ///< That decode a compressed file; 0: as many as the machine has.
  Progress progress;    ///< Loading ends early where it is stopped.
  /// Takes the file as it is where edits wait in a journal beside it; else that is an error.
  bool withoutJournal = false;
  /// Which frame of a volume of several it is to be, from 1 on (`voxc/Volume/Frames.h`); 0: the first, with
  /// all others in its stream of frames, which a volume of one frame alone does not have.
  int frame = 0;
  /// Uniform cubes that `decode` may find: a small file can stand for 2^60, which no one waits for.
  std::uint64_t mostCubes = kMostCubes;
};

/// How a volume is written. Only `compress` and `pageBytes` change the bytes of the file.
struct SaveOptions {
  bool compress = false; ///< In pages compressed by zstd, to be decoded; else as it is, to be mapped.
  /// Of every page but the last, decoded: a power of two, 4 KiB to 1 MiB. By default 64 thousand words: few
  /// enough to fetch for a handful of them, enough for zstd to find what repeats.
  std::uint32_t pageBytes = 1 << 18;
  unsigned threads = 0; ///< That compress; 0: as many as the machine has.
  /// A bound that compressing keeps to; null: none.
  std::shared_ptr<WorkingMemory> memory;
  Progress progress;
};

/// An immutable volume. Cheap to move; its streams live as long as it does.
class Volume {
public:
  /// Takes words made by a builder; they are trusted.
  Volume(VolumeInfo info, std::vector<std::uint32_t> words);
  /// The same for words that `owner` keeps alive.
  Volume(VolumeInfo info, std::span<const std::uint32_t> words, std::shared_ptr<const void> owner);
  /// The same for several streams: the words, then at most 63 others.
  Volume(VolumeInfo info, std::vector<Stream> streams, std::shared_ptr<const void> owner);
  ~Volume();
  Volume(Volume &&) noexcept;
  Volume &operator=(Volume &&) noexcept;

  /// Maps a .hvx file, or decodes one that is compressed. Everything in it is checked, every reachable offset
  /// too unless `trusted`, before the volume is handed out. Errors: no such file, not a .hvx, truncated, a
  /// wrong checksum, a broken structure, no such frame, edits that wait in a journal (`loadEdited` has them);
  /// `Environment`, no memory for what is decoded; interrupted.
  static Expected<Volume> load(const std::string &path, const LoadOptions &options = {});

  /// Writes a .hvx file under a temporary name and renames it: `path` is whole, or unchanged. Errors:
  /// `Input`, edits wait for the volume of that name; `Environment`; of a compressed one also that `path` is
  /// a pipe, or interrupted.
  Expected<void> save(const std::string &path, const SaveOptions &options = {}) const;

  const VolumeInfo &info() const;
  const Format &format() const { return info().format; }
  std::span<const std::uint32_t> words() const;

  /// All streams in the order of the file; the first is `words`.
  std::span<const Stream> streams() const;
  /// The stream of this name, or null.
  const Stream *findStream(std::string_view name) const;
  /// Of all streams together.
  std::uint64_t bytes() const;
  /// How many cubes `decode` may find: `LoadOptions::mostCubes`.
  std::uint64_t mostCubes() const;

  /// The voxel's word, and the side of the aligned cube around it that holds the same; 0 outside the format.
  Lookup lookup(Int3 voxel) const;

  /// How the words lie: `layoutOf(format())`.
  const Layout &layout() const;
  /// What a kernel's must equal.
  std::uint64_t storageDigest() const { return layout().storageDigest; }

private:
  struct State;
  void allowCubes(std::uint64_t most);
  Expected<void> chooseFrame(int number);
  Expected<void> saveMapped(const std::string &path) const;
  std::unique_ptr<State> state_;
};

/// Where edits of a volume file wait that are not in it yet: beside the file itself, of whatever link to it.
std::string journalPathOf(const std::string &volumePath);

/// Error (`Input`) if there is a journal beside a volume file, naming what puts its edits into the file.
Expected<void> checkNoJournal(const std::string &volumePath);

/// Asked now and then by work that may take long; false ends it as interrupted.
using KeepOn = std::function<bool()>;

/// Proves that every word reachable from the root is in range and well-formed: safe for any kernel of the
/// format. Returns the number of its voxels, in time that follows the words however they are shared. Errors
/// (`Input`): what is broken; interrupted by `keepOn`.
Expected<std::uint64_t> checkStructure(const Format &format, std::span<const std::uint32_t> words,
                                       const KeepOn &keepOn = {});

/// Receives a uniform cube of voxels; false ends the decoding.
using DecodeVisit = std::function<bool(const Cube &cube, std::uint32_t word)>;

/// Calls `visit` for every maximal uniform cube that the volume stores, in Morton order: together all its
/// voxels, so that there are no more cubes than `info().voxels`. Errors: interrupted; more than
/// `volume.mostCubes()`; more voxels than the header says, which only a file that was trusted unseen can
/// have.
Expected<void> decode(const Volume &volume, const DecodeVisit &visit, const Progress &progress = {});

} // namespace voxc
