// Files of records.
#include "voxc/Measure/RecordFile.h"

#include "voxc/Support/File.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <map>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace voxc::measure {
namespace {

namespace fs = std::filesystem;

constexpr const char *kExtension = ".jsonl";

Error cannotWrite(const std::string &path) {
  return Error::environment("cannot write to '" + path + "': " + std::strerror(errno));
}

/// Takes the lock of a file; one that was ended a moment ago may still have it.
bool lock(int descriptor) {
  constexpr int kTries = 20;
  constexpr std::chrono::milliseconds kPause(100);
  for (int i = 0; i < kTries; ++i) {
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
      return true;
    std::this_thread::sleep_for(kPause);
  }
  return false;
}

/// The paths of a folder's files of records, in order.
Expected<std::vector<std::string>> recordFiles(const std::string &folder) {
  std::error_code failure;
  std::vector<std::string> paths;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure))
    if (entry->path().extension() == kExtension)
      paths.push_back(entry->path().string());
  if (failure)
    return Error::input("folder '" + folder + "' cannot be read: " + failure.message());
  std::ranges::sort(paths);
  return paths;
}

/// Records by the order in which their cells came up first.
class RecordList {
public:
  Expected<void> addFile(const std::string &path) {
    const auto text = VOXC_TRY(readTextFile(path));
    std::size_t number = 1;
    // What stands behind the last line end was cut short.
    for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
      if (Expected<void> added = addLine({text.data() + begin, end - begin}); !added)
        return Error::input(path + ":" + std::to_string(number) + ": " + added.error().message);
      else
        ++number;
    return {};
  }

  std::vector<Record> take() { return std::move(records_); }

private:
  Expected<void> addLine(std::string_view line) {
    if (line.empty())
      return {};
    auto record = VOXC_TRY(parseRecord(line));
    const auto [known, isNew] = places_.emplace(record.cell, records_.size());
    if (isNew)
      records_.push_back(std::move(record));
    else
      records_[known->second] = std::move(record);
    return {};
  }

  std::vector<Record> records_;
  std::map<std::string, std::size_t> places_;
};

} // namespace

Expected<std::vector<Record>> readRecords(const std::string &folder) {
  const auto paths = VOXC_TRY(recordFiles(folder));
  RecordList list;
  for (const std::string &path : paths)
    VOXC_TRY(list.addFile(path));
  return list.take();
}

Expected<std::vector<Record>> readRecordFile(const std::string &path) {
  RecordList list;
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    return list.take();
  VOXC_TRY(list.addFile(path));
  return list.take();
}

Expected<RecordWriter> RecordWriter::open(const std::string &path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0)
    return cannotWrite(path);
  RecordWriter writer(descriptor, path);
  if (!lock(descriptor))
    return Error::input("'" + path +
                        "' is being written by another voxc; wait for it, or name another folder");
  VOXC_TRY(writer.removeCutLine());
  return writer;
}

RecordWriter::~RecordWriter() {
  if (descriptor_ >= 0)
    ::close(descriptor_);
}

RecordWriter::RecordWriter(RecordWriter &&other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::move(other.path_)) {}

Expected<void> RecordWriter::removeCutLine() {
  struct stat status{};
  if (::fstat(descriptor_, &status) != 0)
    return cannotWrite(path_);
  if (!S_ISREG(status.st_mode) || status.st_size == 0)
    return {};
  const auto text = VOXC_TRY(readTextFile(path_));
  const std::size_t whole = text.rfind('\n') + 1; // npos + 1 is 0: no line is whole.
  if (whole < text.size() && ::ftruncate(descriptor_, static_cast<off_t>(whole)) != 0)
    return cannotWrite(path_);
  return {};
}

Expected<void> RecordWriter::append(const Record &record) { return appendText(toLine(record) + "\n"); }

Expected<void> RecordWriter::appendText(const std::string &lines) {
  for (std::size_t done = 0; done < lines.size();) {
    const ssize_t written = ::write(descriptor_, lines.data() + done, lines.size() - done);
    if (written < 0 && errno != EINTR)
      return cannotWrite(path_);
    done += written < 0 ? 0 : static_cast<std::size_t>(written);
  }
  return ::fdatasync(descriptor_) == 0 ? Expected<void>() : cannotWrite(path_);
}

Expected<void> RecordWriter::take(const std::string &path) {
  // While it is open here no other process writes to it, and its last line is whole.
  const Expected<RecordWriter> source = open(path);
  if (!source)
    return source.error().kind == ErrorKind::Input ? Expected<void>() : source.error();
  const auto lines = VOXC_TRY(readTextFile(path));
  // In this order: what is cut short here leaves the records in two files, which is as good as in one.
  VOXC_TRY(appendText(lines));
  std::error_code failure;
  fs::remove(path, failure);
  return failure ? Error::environment("cannot remove '" + path + "': " + failure.message())
                 : Expected<void>();
}

} // namespace voxc::measure
