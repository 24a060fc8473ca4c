// The table of every cell.
#include "report/Html.h"
#include "report/Sections.h"
#include "report/Words.h"

namespace voxc::report {
namespace {

/// The text of an entry in a column; numbers of one column share one unit, so that they can be sorted.
struct Column {
  const char *heading;
  bool isNumber;
  std::string (*text)(const Entry &);
};

std::string figureText(Figure value, double unit = 1) { return value ? numberText(*value / unit) : ""; }

/// Of the three kinds of errors one, or "" if none was looked for.
std::string errorText(const Entry &entry, double ErrorRecord::*kind) {
  return entry.cell->error ? countText(*entry.cell->error.*kind) : "";
}

constexpr double kMebi = 1 << 20;

constexpr Column kColumns[] = {
    {"Format", false, [](const Entry &e) { return e.look.name; }},
    {"Label", false, [](const Entry &e) { return e.cell->format.label; }},
    {"Model", false, [](const Entry &e) { return e.column; }},
    {"Side", true, [](const Entry &e) { return numberText(e.cell->resolution); }},
    {"Device", false, [](const Entry &e) { return e.device; }},
    {"Steps", false, [](const Entry &e) { return e.cell->precision; }},
    {"Passes", false, [](const Entry &e) { return e.passes; }},
    {"Size, MiB", true, [](const Entry &e) { return figureText(e.cell->volume.bytes, kMebi); }},
    {"Bytes a voxel", true, [](const Entry &e) { return figureText(e.cell->volume.bytesPerVoxel); }},
    {"Speed, Mrays/s", true, [](const Entry &e) { return figureText(e.cell->speed.median); }},
    {"Of", false, [](const Entry &e) { return std::string(e.cell->device.hasClock ? "GPU" : "CPU"); }},
    {"Spread, %", true, [](const Entry &e) { return figureText(e.cell->speed.spread, 0.01); }},
    {"Missed", true, [](const Entry &e) { return errorText(e, &ErrorRecord::missed); }},
    {"Ghost", true, [](const Entry &e) { return errorText(e, &ErrorRecord::ghost); }},
    {"Wrong", true, [](const Entry &e) { return errorText(e, &ErrorRecord::wrong); }},
    {"Of rays", true, [](const Entry &e) { return errorText(e, &ErrorRecord::rays); }},
    {"Lookups a ray", true, [](const Entry &e) { return figureText(e.cell->lookupsPerRay); }},
    {"Words a ray", true, [](const Entry &e) { return figureText(e.cell->wordsPerRay); }},
    {"Build, s", true, [](const Entry &e) { return figureText(e.cell->build.build); }},
    {"Build, CPU s", true, [](const Entry &e) { return figureText(e.cell->build.buildCpu); }},
    {"Peak, MiB", true, [](const Entry &e) { return figureText(e.cell->build.peakBytes, kMebi); }},
    {"Kernel, s", true, [](const Entry &e) { return figureText(e.cell->kernel.compile); }},
    {"First dispatch, s", true, [](const Entry &e) { return figureText(e.cell->kernel.firstDispatch); }},
    {"Frontier", false, [](const Entry &e) { return std::string(e.onFrontier ? "●" : ""); }},
    {"Outcome", false,
     [](const Entry &e) {
       return e.cell->measured ? std::string(e.cell->speed.steady ? "" : "not steady") : "failed";
     }},
};

std::string row(const Catalogue &catalogue, const Entry &entry) {
  std::string cells;
  for (const Column &column : kColumns) {
    const std::string text = column.text(entry);
    if (cells.empty())
      cells = textTag("th", {{"scope", "row"}}, text);
    else if (column.isNumber)
      cells += textTag("td", {{"class", "n"}}, text);
    else
      cells += textTag("td", {}, text);
  }
  return tag("tr", {{"id", rowId(catalogue, entry)}, {"data-format", std::to_string(entry.format)}}, cells) + "\n";
}

} // namespace

std::string rowId(const Catalogue &catalogue, const Entry &entry) {
  return "r" + std::to_string(&entry - catalogue.entries.data() + 1);
}

std::string cellSection(const Catalogue &catalogue) {
  std::string head, rows;
  for (const Column &column : kColumns)
    head += textTag("th", {{"scope", "col"}, {"class", column.isNumber ? "n" : ""}}, column.heading);
  for (const Entry &entry : catalogue.entries)
    rows += row(catalogue, entry);
  return fill("section/cells.html", {{"head", head}, {"rows", rows}});
}

} // namespace voxc::report
