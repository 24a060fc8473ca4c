// The table of every cell.
#include "report/Html.h"
#include "report/Sections.h"
#include "report/Words.h"

#include <cctype>
#include <cstdio>

namespace voxc::report {
namespace {

/// The text of an entry in a column; numbers of one column share one unit, so that they can be sorted.
struct Column {
  const char *heading;
  bool isNumber;
  std::string (*text)(const Entry &);
};

std::string figureText(Figure value, double unit = 1) { return value ? numberText(*value / unit) : ""; }

/// A kind of errors, or "" if none was looked for.
std::string errorText(const Entry &entry, double Errors::*kind) {
  return entry.errors ? countText(*entry.errors.*kind) : "";
}

constexpr double kMebi = 1 << 20;

constexpr Column kColumns[] = {
    {"Format", false, [](const Entry &e) { return e.look.name; }},
    {"Label", false, [](const Entry &e) { return e.cell->format.label; }},
    {"Model", false, [](const Entry &e) { return e.column; }},
    {"Side", true, [](const Entry &e) { return std::to_string(e.cell->resolution.value_or(0)); }},
    {"Device", false, [](const Entry &e) { return e.device; }},
    {"Steps", false, [](const Entry &e) { return e.cell->precision; }},
    {"Passes", false, [](const Entry &e) { return passList(e.cell->format.passes); }},
    {"Size, MiB", true, [](const Entry &e) { return figureText(e.bytes, kMebi); }},
    {"Bytes a voxel", true, [](const Entry &e) { return figureText(e.cell->volume.bytesPerVoxel); }},
    {"Speed, Mrays/s", true,
     [](const Entry &e) { return e.speed ? numberText(e.speed->median) : std::string(); }},
    {"Of", false, [](const Entry &e) { return std::string(e.hasClock ? "GPU" : "CPU"); }},
    {"Spread, %", true,
     [](const Entry &e) { return e.speed ? numberText(e.speed->spread * 100) : std::string(); }},
    {"Frontier", false,
     [](const Entry &e) {
       return std::string(e.isLeading() ? "●" : e.isAsGood() ? "≈" : "");
     }},
    {"Missed", true, [](const Entry &e) { return errorText(e, &Errors::missed); }},
    {"Ghost", true, [](const Entry &e) { return errorText(e, &Errors::ghost); }},
    {"Wrong", true, [](const Entry &e) { return errorText(e, &Errors::wrong); }},
    {"Of rays", true, [](const Entry &e) { return errorText(e, &Errors::rays); }},
    {"Lookups a ray", true, [](const Entry &e) { return figureText(e.cell->work.stepsPerRay); }},
    {"Words a ray", true, [](const Entry &e) { return figureText(e.cell->work.wordsPerRay); }},
    {"Build, s", true, [](const Entry &e) { return figureText(e.cell->build.buildSeconds); }},
    {"Build, CPU s", true, [](const Entry &e) { return figureText(e.cell->build.buildCpuSeconds); }},
    {"Peak, MiB", true, [](const Entry &e) { return figureText(e.peakBytes, kMebi); }},
    {"Kernel, s", true, [](const Entry &e) { return figureText(e.cell->kernel.compileSeconds); }},
    {"First dispatch, s", true,
     [](const Entry &e) { return figureText(e.cell->kernel.firstDispatchSeconds); }},
    {"Outcome", false,
     [](const Entry &e) {
       return e.cell->isMeasured() ? std::string(e.isSteady ? "" : "not steady") : "failed";
     }},
};

/// Without the end tags that HTML lets one leave out: the rows are the largest part of the page.
std::string row(const Catalogue &catalogue, const Entry &entry) {
  std::string html = "<tr id=" + rowId(catalogue, entry) + ">";
  for (const Column &column : kColumns) {
    const bool isFirst = &column == kColumns;
    html += isFirst ? "<th scope=row>" : column.isNumber ? "<td class=n>" : "<td>";
    html += escaped(column.text(entry));
  }
  return html + "\n";
}

/// The address of a file beside the page, whatever its name holds.
std::string linkTo(const std::string &name) {
  std::string address = "./";
  for (const char c : name) {
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
    const bool isPlain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
    address += isPlain ? std::string(1, c) : code;
  }
  return address;
}

} // namespace

std::string rowId(const Catalogue &catalogue, const Entry &entry) {
  return "r" + std::to_string(&entry - catalogue.entries.data() + 1);
}

std::string cellSection(const Catalogue &catalogue, const std::string &csvName) {
  std::string head, rows;
  for (const Column &column : kColumns)
    head += textTag("th", {{"scope", "col"}, {"class", column.isNumber ? "n" : ""}}, column.heading);
  for (const Entry &entry : catalogue.entries)
    rows += row(catalogue, entry);
  const std::string link = csvName.empty() ? ""
                                           : " The same with all digits, for a spreadsheet: " +
                                                 textTag("a", {{"href", linkTo(csvName)}}, csvName) + ".";
  return fill("section/cells.html", {{"head", head}, {"rows", rows}, {"csv", link}});
}

} // namespace voxc::report
