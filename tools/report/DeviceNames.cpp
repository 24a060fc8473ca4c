// Names of devices.
#include "report/DeviceNames.h"

#include "report/Html.h"

#include <array>
#include <set>

namespace voxc::report {
namespace {

std::string shortName(const Cell &cell) {
  const std::string &name = cell.device.name;
  return name.substr(0, name.find(" ("));
}
std::string wholeName(const Cell &cell) { return cell.device.name; }
std::string withThreads(const Cell &cell) {
  return cell.device.name +
         (cell.device.threads ? ", " + countText(double(*cell.device.threads)) + " threads" : "");
}
std::string withProcessor(const Cell &cell) {
  return withThreads(cell) + (cell.madeBy.processor.empty() ? "" : ", " + cell.madeBy.processor);
}
std::string withDriver(const Cell &cell) {
  return withProcessor(cell) + (cell.device.driver.empty() ? "" : ", " + cell.device.driver);
}

/// From short to long; the last tells apart what can be told apart.
constexpr std::array<std::string (*)(const Cell &), 5> kNames = {shortName, wholeName, withThreads,
                                                                 withProcessor, withDriver};

} // namespace

std::vector<std::string> deviceNames(const std::vector<Cell> &cells) {
  std::set<std::string> devices;
  for (const Cell &cell : cells)
    devices.insert(kNames.back()(cell));
  for (const auto &nameOf : kNames) {
    std::vector<std::string> names;
    names.reserve(cells.size());
    for (const Cell &cell : cells)
      names.push_back(nameOf(cell));
    if (std::set(names.begin(), names.end()).size() == devices.size())
      return names;
  }
  return {};
}

} // namespace voxc::report
