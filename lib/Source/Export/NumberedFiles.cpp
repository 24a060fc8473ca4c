// Files of which the first ones wait for the others.
#include "Source/Export/NumberedFiles.h"

#include "Support/Platform/File.h"

namespace voxc {
namespace {

/// What a reader may begin with: numbers 0 and 1.
constexpr std::uint64_t kBeginning = 2;

/// Removes a file; a pipe or a device stays, and is written to. So does a link to a file, which is made anew
/// where that leads.
void removeFile(const std::string &path) {
  const auto end = platform::followLinks(path);
  if (end && !end->isOpen && platform::kindOf(end->path) == platform::PathKind::File)
    platform::removeFile(end->path);
}

} // namespace

Expected<void> NumberedFiles::add(std::string_view bytes) {
  // From the first file that may take the place of another, an earlier set is none any more.
  if (count_ == kBeginning)
    for (std::uint64_t number = 0; number < kBeginning; ++number)
      removeFile(path_(number));
  auto added = count_ < kBeginning ? addBeginning(bytes) : writeFile(path_(count_), bytes);
  ++count_;
  return added;
}

Expected<void> NumberedFiles::addBeginning(std::string_view bytes) {
  auto file = VOXC_TRY(OutputFile::create(path_(count_)));
  VOXC_TRY(file.write(bytes.data(), bytes.size()));
  beginning_.push_back(std::move(file));
  return {};
}

/// Number 0 is the first, for a reader takes 1 without it for the beginning; 0 without 1 is a gap before all
/// others.
Expected<void> NumberedFiles::finish() {
  for (OutputFile &file : beginning_)
    VOXC_TRY(file.commit());
  beginning_.clear();
  return {};
}

std::string NumberedFiles::leftover() const {
  const std::string path = path_(count_);
  if (platform::kindOf(path) != platform::PathKind::File)
    return "";
  return "'" + path + "' lies there from before, and belongs to another set; remove it and those behind it";
}

} // namespace voxc
