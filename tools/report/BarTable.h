// Tables of bars: a row a format, a column a model; each cell has its figure in words and as a length.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace voxc::report {

/// What a bar means, told by its colour beside its length.
enum class Tone { Plain, Better, Worse, Equal };

struct Bar {
  double value = 0;
  std::string text;
  std::string note; ///< Shown when pointed at.
  Tone tone = Tone::Plain;
};

struct BarTable {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::string> rows;
  std::map<std::pair<std::size_t, std::size_t>, Bar> bars; ///< By row and column; a place may be empty.
  double reference = 0;                                    ///< A value with a line across the bars; 0: none.

  bool empty() const { return bars.empty(); }
  /// The row or column of a name, which is added behind the others if it is new.
  std::size_t row(const std::string &name);
  std::size_t column(const std::string &name);
};

/// All bars are drawn to one scale from 0.
std::string toHtml(const BarTable &table);

} // namespace voxc::report
