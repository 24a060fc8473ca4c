// Watching a mapped file from its opening to its end.
#include "Support/WatchedFile.h"

namespace voxc {

Expected<std::shared_ptr<const WatchedFile>> WatchedFile::open(const std::string &path,
                                                               std::shared_ptr<WorkingMemory> memory) {
  auto file = VOXC_TRY(MappedFile::open(path));
  return std::make_shared<const WatchedFile>(std::move(file), std::move(memory));
}

WatchedFile::WatchedFile(MappedFile file, std::shared_ptr<WorkingMemory> memory)
    : file_(std::move(file)), memory_(std::move(memory)) {
  memory_->watch(file_.bytes());
}

WatchedFile::~WatchedFile() { memory_->unwatch(file_.bytes()); }

} // namespace voxc
