// A compressed .hvx file that is being written.
#pragma once

#include "voxc/Support/File.h"
#include "voxc/Volume/Volume.h"

#include <span>
#include <string>
#include <utility>

namespace voxc {

/// A compressed file, written when the volume is complete.
class PagedFileWriter {
public:
  /// Errors: as `OutputFile::create`; `path` is a pipe, whose beginning cannot be written last.
  static Expected<PagedFileWriter> create(const std::string &path);

  /// Compresses the streams, completes the file and gives it its name. The bytes depend on info, streams and
  /// the version of zstd alone. Errors: `Environment`, a full disk; interrupted; edits that
  /// came meanwhile, of what it would replace (`Input`).
  Expected<void> finish(const VolumeInfo &info, std::span<const Stream> streams, const SaveOptions &options);

private:
  PagedFileWriter(std::string path, OutputFile file) : path_(std::move(path)), file_(std::move(file)) {}

  std::string path_;
  OutputFile file_;
};

} // namespace voxc
