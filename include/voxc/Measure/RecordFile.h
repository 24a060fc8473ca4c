// Records in files: all of a folder read, and new ones appended so that every line is whole.
#pragma once

#include "voxc/Measure/Record.h"

#include <string>
#include <vector>

namespace voxc::measure {

/// The file of a folder that a sweep appends to.
inline constexpr const char *kResultsName = "results.jsonl";

/// The records of every *.jsonl file of `folder`, files in the order of their names; of two with the same
/// cell the later one counts, in the place of the first. A last line that was cut short is left out. Errors:
/// `Input` for a folder or file that cannot be read and a line that is no record, by file and line.
Expected<std::vector<Record>> readRecords(const std::string &folder);

/// The same of one file; none if there is no such file.
Expected<std::vector<Record>> readRecordFile(const std::string &path);

/// The one writer of a file of records.
class RecordWriter {
public:
  /// Opens `path` for appending, and makes it if it is not there. A last line that was cut short is removed
  /// first. Errors: `Input` if another process is writing to it, `Environment`.
  static Expected<RecordWriter> open(const std::string &path);
  ~RecordWriter();
  RecordWriter(RecordWriter &&other) noexcept;
  RecordWriter &operator=(RecordWriter &&) = delete;

  /// Appends a line in one piece, on the disk when this returns. Error: `Environment`.
  Expected<void> append(const Record &record);

  /// Moves the records of another file to the end of this one and removes that file; one that another process
  /// is writing to is left as it is. Error: `Environment`.
  Expected<void> take(const std::string &path);

private:
  RecordWriter(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {}
  Expected<void> removeCutLine();
  Expected<void> appendText(const std::string &lines);

  int descriptor_;
  std::string path_;
};

} // namespace voxc::measure
