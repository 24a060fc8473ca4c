// Reading the records of several folders.
#include "report/Cells.h"

#include "bench/RecordFile.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace voxc::report {
namespace {

namespace fs = std::filesystem;

bool leavesItsFolder(const fs::path &path) {
  return path.is_absolute() || std::ranges::find(path, fs::path("..")) != path.end();
}

void locatePicture(Cell &cell, const fs::path &folder) {
  std::optional<std::string> &picture = cell.model.picture;
  if (picture && leavesItsFolder(*picture))
    picture.reset();
  else if (picture)
    picture = (folder / *picture).string();
}

} // namespace

Expected<std::vector<Cell>> readCells(const std::vector<std::string> &folders) {
  std::vector<Cell> cells;
  std::map<std::string, std::size_t> places;
  for (const std::string &folder : folders) {
    Expected<std::vector<Cell>> records = tool::bench::readRecords(folder);
    if (!records)
      return records.error();
    for (Cell &cell : *records) {
      locatePicture(cell, folder);
      const auto [known, isNew] = places.emplace(cell.cell, cells.size());
      if (isNew)
        cells.push_back(std::move(cell));
      else
        cells[known->second] = std::move(cell);
    }
  }
  if (cells.empty())
    return Error::input("there are no records; a folder should hold .jsonl files of voxc bench");
  return cells;
}

} // namespace voxc::report
