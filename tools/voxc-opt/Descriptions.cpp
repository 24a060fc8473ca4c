// Printing the tables of passes, level kinds and attributes.
#include "Descriptions.h"

#include "voxc/Passes/Pass.h"
#include "voxc/Plan/Plan.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace voxc::tool {

namespace {

const char *nameOf(AttributeEffect effect) {
  return effect == AttributeEffect::Storage ? "storage" : "traversal";
}

std::string concat(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts)
    text += part;
  return text;
}

/// The names of a range one after the other, each between `mark`s.
template <typename Names>
std::string listed(const Names &names, const char *separator, const char *mark = "") {
  std::string text;
  for (const std::string_view name : names)
    text += concat({text.empty() ? "" : separator, mark, name, mark});
  return text;
}

std::string listedValues(const AttributeKind &kind, const char *separator, const char *mark = "") {
  std::string text;
  for (const ValueRange &range : valueRanges(kind))
    text += (text.empty() ? "" : separator) + range.text(mark);
  return text;
}

/// A pass as its flag: "--palette[=N]".
std::string flagOf(const Pass &pass) { return concat({"--", pass.name, pass.number ? "[=N]" : ""}); }

std::string listAttributes(AttributeKinds attributes) {
  std::string text;
  for (const AttributeKind *attribute : attributes)
    text += concat({"  ", attribute->name, " (", nameOf(attribute->effect),
                    "): ", listedValues(*attribute, " "), "; ", attribute->summary, "\n"});
  return text + "\n";
}

std::string describeLevel(const LevelKind &kind) {
  std::vector<std::string_view> names;
  std::string meanings;
  for (const ParameterKind &parameter : kind.parameters) {
    names.push_back(parameter.name);
    meanings += concat({"  ", parameter.name, ": ", parameter.meaning, "\n"});
  }
  const std::string parameters = "(" + listed(names, ", ") + ")";
  return concat({std::string_view(&kind.letter, 1), parameters, ", in IR ", kind.name, parameters, "\n  ",
                 kind.summary, "\n\n", meanings, listAttributes(kind.attributes)});
}

/// The level kinds that take an attribute, as they are written in IR.
std::vector<std::string_view> takersOf(const AttributeKind &attribute) {
  std::vector<std::string_view> takers;
  for (const LevelKind *kind : levelKinds())
    if (std::ranges::find(kind->attributes, &attribute) != kind->attributes.end())
      takers.push_back(kind->name);
  return takers;
}

/// Every attribute once: those of levels, then those of formats.
std::vector<const AttributeKind *> allAttributes() {
  std::vector<const AttributeKind *> all;
  const auto append = [&all](AttributeKinds more) {
    for (const AttributeKind *attribute : more)
      if (std::ranges::find(all, attribute) == all.end())
        all.push_back(attribute);
  };
  for (const LevelKind *kind : levelKinds())
    append(kind->attributes);
  append(formatAttributes());
  return all;
}

} // namespace

std::string listPasses() {
  std::string text = "Passes over formats:\n";
  for (const Pass &pass : passes()) {
    text += concat({"  ", pass.name});
    if (const auto &number = pass.number)
      text += concat({"{", number->name, "=N}  N is ", std::to_string(number->least), " to ",
                      std::to_string(number->most), ", ", std::to_string(number->byDefault),
                      " if it is not written"});
    text += "\n";
  }
  text += concat({"From a format to a plan:\n  ", kLowering, "\nPasses over plans:\n"});
  for (const PlanPass &pass : planPasses())
    text += concat({"  ", pass.name, "\n"});
  return text;
}

std::string describePasses() {
  std::string text;
  for (const Pass &pass : passes())
    text += concat(
        {flagOf(pass), " (", nameOf(pass.effect), ")\n  ", pass.summary, "\n\n", pass.details, "\n\n"});
  return text;
}

std::string describePlanPasses() {
  std::string text = "| Pass | Does | Why there |\n|---|---|---|\n";
  for (const PlanPass &pass : planPasses())
    text += concat({"| `", pass.name, "` | ", pass.summary, " | ", pass.place, " |\n"});
  return text;
}

std::string describeLevels() {
  std::string text;
  for (const LevelKind *kind : levelKinds())
    text += describeLevel(*kind);
  return text + "A format as a whole, in IR after the word format\n\n" + listAttributes(formatAttributes());
}

namespace {

/// What an attribute needs, and what it excludes, to follow its summary.
std::string conditionText(const AttributeKind &attribute) {
  std::string text = attribute.needs ? concat({"; needs `", attribute.needs->name, "`"}) : "";
  for (const AttributeValue &excluded : attribute.excludes)
    text += concat({&excluded == attribute.excludes.data() ? "; any but the default excludes `" : " and `",
                    excluded.kind->name, "=", excluded.value, "`"});
  return text;
}

} // namespace

std::string describeAttributes() {
  std::string text =
      "| Attribute | Values, the default first | Effect | On | Chooses |\n|---|---|---|---|---|\n";
  for (const AttributeKind *attribute : allAttributes()) {
    const auto takers = takersOf(*attribute);
    text +=
        concat({"| `", attribute->name, "` | ", listedValues(*attribute, ", ", "`"), " | ",
                nameOf(attribute->effect), " | ", takers.empty() ? "the format" : listed(takers, ", ", "`"),
                " | ", attribute->summary, conditionText(*attribute), " |\n"});
  }
  return text;
}

} // namespace voxc::tool
