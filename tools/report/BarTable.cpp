// Tables of bars.
#include "report/BarTable.h"

#include "report/Html.h"

#include <algorithm>
#include <array>

namespace voxc::report {
namespace {

constexpr std::array<const char *, 4> kToneNames = {"plain", "better", "worse", "equal"};

std::size_t addTo(std::vector<std::string> &list, const std::string &name) {
  const auto found = std::ranges::find(list, name);
  if (found != list.end())
    return static_cast<std::size_t>(found - list.begin());
  list.push_back(name);
  return list.size() - 1;
}

/// A custom property that style.css makes a length of.
std::string property(const char *name, double value, double most) {
  return std::string("--") + name + ":" + plot::coordinate(100 * value / most) + "%";
}

std::string barHtml(const Bar &bar, double most, double reference) {
  std::string style = property("length", bar.value, most);
  if (reference > 0)
    style += ";" + property("reference", reference, most);
  const std::string name = std::string("bar ") + kToneNames[static_cast<std::size_t>(bar.tone)] +
                           (reference > 0 ? " referred" : "");
  const std::string line = textTag("b", {}, bar.text) + tag("span", {{"class", name}, {"style", style}}, "");
  return tag("td", {{"title", bar.note}}, tag("div", {}, line));
}

std::string head(const BarTable &table) {
  std::string cells = textTag("th", {{"scope", "col"}}, "Format");
  for (const std::string &column : table.columns)
    cells += textTag("th", {{"scope", "col"}}, column);
  return tag("thead", {}, tag("tr", {}, cells));
}

} // namespace

std::size_t BarTable::row(const std::string &name) { return addTo(rows, name); }

std::size_t BarTable::column(const std::string &name) { return addTo(columns, name); }

std::string toHtml(const BarTable &table) {
  double most = table.reference > 0 ? table.reference : 1e-300;
  for (const auto &[place, bar] : table.bars)
    most = std::max(most, bar.value);
  std::string body;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::string cells = textTag("th", {{"scope", "row"}}, table.rows[row]);
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      const auto bar = table.bars.find({row, column});
      cells += bar == table.bars.end() ? tag("td", {}, "") : barHtml(bar->second, most, table.reference);
    }
    body += tag("tr", {}, cells) + "\n";
  }
  const std::string caption = table.caption.empty() ? "" : textTag("caption", {}, table.caption);
  return tag("div", {{"class", "scroll"}},
             tag("table", {{"class", "bars"}, {"style", "--columns:" + std::to_string(table.columns.size())}},
                 caption + head(table) + tag("tbody", {}, body)));
}

} // namespace voxc::report
