// Files of fragments: what one machine hands to the one that merges (docs/hvf.md).
#pragma once

#include "Construct/Parts/Fragment.h"

#include "Volume/Checksum.h"
#include "voxc/Construct/FragmentShare.h"
#include "voxc/Support/File.h"
#include "voxc/Support/Next.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace voxc {

/// What all fragments of a volume agree on, and which one a file is.
struct FragmentInfo {
  VolumeInfo volume;   ///< Of a file that is read, the number of voxels is that of its parts.
  int log2Side = 0;    ///< Of the smallest parts, the cubes that `share` counts.
  FragmentShare share; ///< What the file is to hold.
};

/// A part in a file: which cube, and how many bytes of memory it takes.
struct PartPlace {
  Cube cube;
  std::uint64_t bytes = 0;
};

/// Writes parts to a file, which gets its name when it is complete.
class FragmentWriter {
public:
  /// Errors: as `OutputFile::create`; `Input` if `path` is a pipe or a device.
  static Expected<FragmentWriter> create(const std::string &path, const FragmentInfo &info);

  /// Adds the next part. Error: `Environment`.
  Expected<void> add(const Fragment &fragment);
  /// Completes the file, which has its name then. `looked`: how many cubes of its share were looked at, those
  /// of its parts and empty ones. Errors: not all of them, and nothing is written; `Environment`.
  Expected<void> finish(std::uint64_t looked);

private:
  FragmentWriter(OutputFile file, FragmentInfo info);
  Expected<void> write(const void *data, std::size_t size);

  OutputFile file_;
  FragmentInfo info_;
  std::unique_ptr<Checksum> sum_;
  std::uint64_t parts_ = 0;
  std::uint64_t voxels_ = 0;
  std::uint64_t bytes_ = 0;
};

/// Reads the parts of a file one after the other. Nothing in the file is believed.
class FragmentReader {
public:
  /// Maps and checks a file. Errors: `Input`.
  static Expected<FragmentReader> open(const std::string &path);

  const FragmentInfo &info() const { return info_; }
  /// How the words of the volume lie.
  const Layout &layout() const { return layout_; }
  const std::string &path() const { return path_; }
  std::span<const std::byte> bytes() const { return file_.bytes(); }

  /// The cube of the next part. Errors: it is not there, or at the end, the parts are not all that the file
  /// is said to hold.
  Next<Cube> next() const;
  /// All parts from the next one on, as far as their headers do not contradict the file.
  std::vector<PartPlace> places() const;
  /// That part. Error: it is broken.
  Expected<Fragment> take();

private:
  FragmentReader(MappedFile file, std::string path) : file_(std::move(file)), path_(std::move(path)) {}

  MappedFile file_;
  std::string path_;
  FragmentInfo info_;
  Layout layout_;
  std::uint64_t at_ = 0;        ///< Byte of the next part.
  std::uint64_t remaining_ = 0; ///< Parts.
  std::uint64_t voxels_ = 0;    ///< Of the parts that were taken.
};

} // namespace voxc
