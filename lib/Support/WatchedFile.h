// Input files that are read in place, within the bound of a WorkingMemory.
#pragma once

#include "voxc/Support/File.h"
#include "voxc/Support/WorkingMemory.h"

#include <memory>
#include <string>
#include <string_view>

namespace voxc {

/// A mapped file whose pages a WorkingMemory may let go of, as long as the file is open.
class WatchedFile {
public:
  /// Errors: as `MappedFile::open`.
  static Expected<std::shared_ptr<const WatchedFile>> open(const std::string &path,
                                                           std::shared_ptr<WorkingMemory> memory);
  WatchedFile(MappedFile file, std::shared_ptr<WorkingMemory> memory);
  ~WatchedFile();
  WatchedFile(const WatchedFile &) = delete;
  WatchedFile &operator=(const WatchedFile &) = delete;

  std::span<const std::byte> bytes() const { return file_.bytes(); }
  std::string_view text() const { return {reinterpret_cast<const char *>(bytes().data()), bytes().size()}; }

private:
  MappedFile file_;
  std::shared_ptr<WorkingMemory> memory_;
};

} // namespace voxc
